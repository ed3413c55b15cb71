//! Points of clouds of single primitives found again in the cloud they were taken from.
//!
//! Programs that hold coordinates in single precision round them, and first move clouds that lie far out
//! nearer to the origin: a global shift, which is the same for all points and may be missing from what they write.
//! Where the points are not where the cloud's are, it is looked for: each point of the cloud is tried as the
//! place of one of theirs, and what moves most of them onto the cloud is it.

use super::Piece;
use crate::cloud::neighbours::{KdTree, Neighbour};
use crate::cloud::{Bounds, Cloud, Point, Vector};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::format::findings::{Findings, Kind};
use crate::format::labels::Segment;
use crate::format::segments::SINGLE;

const OTHER_CLOUD: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The points of these files, one for each primitive, are not those of the cloud, so they are not used",
    expected: "points of the cloud, in single precision and all moved by the same way at most",
    hint: "Check that they belong to this cloud",
};
const SOME_ELSEWHERE: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Warning,
    message: "Some points of the files, one for each primitive, are not in the cloud",
    expected: "",
    hint: "They are left out",
};
const SHIFTED: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Note,
    message: "The files, one for each primitive, are moved against the cloud, all by the same way, and were moved back",
    expected: "",
    hint: "",
};

/// Points by which a place is judged, spread over all files.
const SAMPLES: usize = 512;

/// Points by which a shift is tried: of the first so many may miss, of all half.
const FIRST: usize = 8;
const MISSES: usize = 2;
const TRIED: usize = 64;

/// Points of the cloud at one place that are all taken for the point of a file there.
const TWINS: usize = 8;

/// Where the points of files lie, and how far a point may be from its own in the cloud.
#[derive(Debug, Clone, Copy)]
struct Placement {
    shift: Vector,
    tolerance: f64,
}

/// The segments of a cloud that the files hold the points of, numbered from 1 in the order of the files; `None`
/// where the points are of another cloud. A point of several files is a member of each. O(n log n) for n points, a
/// few times that where a shift is looked for.
pub(in crate::format) fn onto(
    pieces: &[Piece<'_>],
    cloud: &Cloud,
) -> (Option<Vec<Segment>>, Vec<Diagnostic>) {
    let total: usize = pieces.iter().map(|piece| piece.points.len()).sum();
    let Some(first) = pieces.first().filter(|_| total > 0) else {
        return (None, Vec::new());
    };
    let mut findings = Findings::new(first.path, &[]);
    let tree = KdTree::new(cloud.points());
    let sample: Vec<Point> = pieces
        .iter()
        .flat_map(|piece| &piece.points)
        .step_by(total.div_ceil(SAMPLES))
        .copied()
        .collect();
    let Some(placement) = place(&sample, cloud, &tree) else {
        let found = format!(
            "{} files of {total} points, {} in the cloud",
            pieces.len(),
            cloud.len()
        );
        findings.add_whole(&OTHER_CLOUD, found);
        return (None, findings.finish());
    };
    if placement.shift != Vector::zeros() {
        let [x, y, z] = placement.shift.into();
        findings.add_whole(&SHIFTED, format!("by {x}, {y}, {z}"));
    }
    let mut segments = Vec::new();
    let (mut strangers, mut first_strange) = (0, None);
    let mut buffer = Vec::new();
    for (number, piece) in (1..).zip(pieces) {
        let mut points = Vec::with_capacity(piece.points.len());
        for point in &piece.points {
            placement.find(point, TWINS, &tree, &mut buffer);
            let Some(nearest) = buffer.first() else {
                strangers += 1;
                first_strange.get_or_insert(piece.path);
                continue;
            };
            let place = cloud.points().get(nearest.index as usize);
            let twins = buffer.iter().map(|it| it.index);
            points.extend(twins.filter(|&index| cloud.points().get(index as usize) == place));
        }
        points.sort_unstable();
        points.dedup();
        if !points.is_empty() {
            segments.push(Segment {
                number,
                kind: Some(piece.kind),
                points,
            });
        }
    }
    if let Some(path) = first_strange {
        findings.add_whole(
            &SOME_ELSEWHERE,
            format!("{strangers} of {total}, the first in {path}"),
        );
    }
    (Some(segments), findings.finish())
}

impl Placement {
    /// Points of the cloud at the place of a file's point, nearest first.
    fn find(&self, point: &Point, count: usize, tree: &KdTree, found: &mut Vec<Neighbour>) {
        // A corner of the cube of that tolerance is farther than its side.
        tree.nearest(
            &(point - self.shift),
            count,
            2.0 * self.tolerance,
            |_| true,
            found,
        );
    }

    fn hits<'p>(&self, points: impl Iterator<Item = &'p Point>, tree: &KdTree) -> usize {
        let mut buffer = Vec::new();
        points
            .filter(|point| {
                self.find(point, 1, tree, &mut buffer);
                !buffer.is_empty()
            })
            .count()
    }
}

/// Largest magnitude of a coordinate.
fn largest(bounds: &Bounds) -> f64 {
    bounds.min.coords.amax().max(bounds.max.coords.amax())
}

/// Largest distance of a coordinate from the middle.
fn half(bounds: &Bounds) -> f64 {
    0.5 * (bounds.max - bounds.min).amax()
}

/// Where the points lie, so that at least half of them are in the cloud.
fn place(sample: &[Point], cloud: &Cloud, tree: &KdTree) -> Option<Placement> {
    let (own, theirs) = (cloud.bounds(), Bounds::of(sample));
    // Rounded near the origin and moved back, or rounded where they are.
    let near = SINGLE * half(&own);
    let far = SINGLE * largest(&own).max(largest(&theirs));
    let mut best: Option<(usize, Placement)> = None;
    for tolerance in [near, far] {
        let placement = Placement {
            shift: Vector::zeros(),
            tolerance,
        };
        let hits = placement.hits(sample.iter(), tree);
        if best.is_none_or(|(most, _)| hits > most) {
            best = Some((hits, placement));
        }
        if 20 * hits >= 19 * sample.len() {
            break;
        }
    }
    match best {
        Some((hits, placement)) if 2 * hits >= sample.len() => Some(placement),
        _ => shifted(sample, cloud, tree),
    }
}

/// Where the points lie if all are moved by the same way.
fn shifted(sample: &[Point], cloud: &Cloud, tree: &KdTree) -> Option<Placement> {
    let (own, theirs) = (cloud.bounds(), Bounds::of(sample));
    let rounding = 4.0 * f64::EPSILON * largest(&own);
    let tolerance = SINGLE * half(&own).max(largest(&theirs)) + rounding;
    // Where points may be anywhere, any way would do.
    if sample.len() < FIRST || tolerance.is_nan() || tolerance > 1e-3 * half(&own) {
        return None;
    }
    let tried = spread(sample, TRIED);
    let inner = inner_bounds(sample);
    let room = Vector::repeat(2.0 * tolerance);
    let (least, most) = (inner.max - own.max - room, inner.min - own.min + room);
    let mut best: Option<(usize, f64, Placement)> = None;
    // More than one, since any may be of no point of the cloud.
    for start in spread(sample, 3) {
        if best.is_some_and(|(hits, ..)| hits == tried.len()) {
            break;
        }
        for place in cloud.points() {
            let shift = start - place;
            let within = |axis: usize| (least[axis]..=most[axis]).contains(&shift[axis]);
            if !(0..3).all(within) {
                continue;
            }
            let placement = Placement { shift, tolerance };
            if placement.hits(tried.iter().take(FIRST), tree) + MISSES < FIRST.min(tried.len()) {
                continue;
            }
            let (hits, length) = (placement.hits(tried.iter(), tree), shift.norm());
            let better = best
                .is_none_or(|(most, shortest, _)| hits > most || hits == most && length < shortest);
            if better {
                best = Some((hits, length, placement));
            }
        }
    }
    let (hits, _, placement) = best?;
    (2 * hits >= tried.len()).then(|| placement.refined(&tried, cloud, tree))
}

impl Placement {
    /// The same without the rounding of the one point that it was found by.
    fn refined(self, points: &[Point], cloud: &Cloud, tree: &KdTree) -> Self {
        let (mut sum, mut count) = (Vector::zeros(), 0);
        let mut buffer = Vec::new();
        for point in points {
            self.find(point, 1, tree, &mut buffer);
            let place = buffer
                .first()
                .and_then(|it| cloud.points().get(it.index as usize));
            if let Some(place) = place {
                sum += point - place - self.shift;
                count += 1;
            }
        }
        Self {
            shift: self.shift + sum / f64::from(count.max(1)),
            ..self
        }
    }
}

/// Up to so many of the points, evenly spread over their order.
fn spread(points: &[Point], most: usize) -> Vec<Point> {
    let step = points.len().div_ceil(most).max(1);
    // Spread out, so that the first few are of different files already.
    let count = points.len().div_ceil(step);
    let stride = (count / FIRST).max(1);
    (0..stride)
        .flat_map(|from| (from..count).step_by(stride))
        .filter_map(|at| points.get(at * step))
        .copied()
        .collect()
}

/// The box of the points but for the outermost tenth on either side of each axis, which may be of no cloud.
fn inner_bounds(points: &[Point]) -> Bounds {
    let mut bounds = Bounds::of(points);
    for axis in 0..3 {
        let mut values: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let tenth = values.len() / 10;
        if let (Some(&low), Some(&high)) = (values.get(tenth), values.get(values.len() - 1 - tenth))
        {
            bounds.min[axis] = low;
            bounds.max[axis] = high;
        }
    }
    bounds
}
