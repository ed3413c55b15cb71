//! Curves that may hold edges: those of the solids themselves, and those in which faces of
//! different solids meet.

use nalgebra::Point2;

use super::super::blocks::Sweep;
use super::face::{Chart, Domain, Face};
use super::{Boundary, overlap, tolerance};
use crate::cloud::{Point, Vector};

/// A curve with a parameter from 0 to 1 in proportion to its length.
#[derive(Debug, Clone)]
pub struct Curve {
    pub length: f64,
    /// Whether it returns to its start.
    pub closed: bool,
    course: Course,
}

#[derive(Debug, Clone)]
enum Course {
    /// A corner of an outline, swept.
    Way { solid: usize, corner: Point2<f64> },
    /// A segment of an outline at one end of its sweep.
    Rim {
        solid: usize,
        segment: usize,
        sweep: f64,
    },
    /// A chain of points on two faces.
    Meeting {
        points: Vec<Point>,
        lengths: Vec<f64>,
        faces: [usize; 2],
    },
}

impl Curve {
    /// The point at a parameter, which may go beyond 1 on a second round.
    pub fn at(&self, boundary: &Boundary, t: f64) -> Point {
        let t = if t > 1.0 { t - 1.0 } else { t };
        match &self.course {
            Course::Way { solid, corner } => {
                let solid = &boundary.solids[*solid];
                solid.place(corner, t * solid.span())
            }
            Course::Rim {
                solid,
                segment,
                sweep,
            } => {
                let solid = &boundary.solids[*solid];
                let segment = &solid.segments[*segment];
                solid.place(&segment.at(t * segment.length()), *sweep)
            }
            Course::Meeting {
                points,
                lengths,
                faces,
            } => {
                let along = t * self.length;
                let next = lengths.partition_point(|&length| length <= along);
                let next = next.clamp(1, points.len() - 1);
                let (low, high) = (lengths[next - 1], lengths[next]);
                let share = (along - low) / (high - low);
                let chord = points[next - 1] + (points[next] - points[next - 1]) * share;
                boundary.settle(chord, faces)
            }
        }
    }

    /// Whether the ends are corners of a solid, known exactly.
    pub fn ends_exactly(&self) -> bool {
        !matches!(self.course, Course::Meeting { .. })
    }
}

/// All curves that may hold edges, found at least as finely as the given step. Of solids that are
/// equal the first speaks for all: of n of them, two faces would meet n² times in one curve.
pub fn curves(boundary: &Boundary, step: f64) -> Vec<Curve> {
    let mut curves = own_curves(boundary);
    let faces = boundary.faces.iter().enumerate();
    let faces: Vec<(usize, &Face)> = faces
        .filter(|(_, face)| boundary.is_first[face.solid])
        .collect();
    for (place, &(first, a)) in faces.iter().enumerate() {
        for &(second, b) in &faces[place + 1..] {
            let apart = a.solid == b.solid || a.carrier == b.carrier;
            if !apart && overlap(&a.bounds, &b.bounds) {
                curves.extend(meetings(boundary, [first, second], step));
            }
        }
    }
    curves
}

fn own_curves(boundary: &Boundary) -> Vec<Curve> {
    let mut curves = Vec::new();
    for (solid, placed) in boundary.solids.iter().enumerate() {
        if !boundary.is_first[solid] {
            continue;
        }
        let ends: &[f64] = &[0.0, placed.span()];
        for (segment, shape) in placed.segments.iter().enumerate() {
            let corner = shape.ends()[0];
            let length = placed.pace(&corner) * placed.span();
            if !shape.is_closed() && length > tolerance::ON * boundary.diagonal {
                curves.push(Curve {
                    length,
                    closed: placed.is_closed(),
                    course: Course::Way { solid, corner },
                });
            }
            for &sweep in ends.iter().filter(|_| !placed.is_closed()) {
                let on_axis = shape.ends().iter().all(|end| end.x == 0.0);
                if matches!(placed.sweep, Sweep::Revolve { .. }) && on_axis {
                    continue;
                }
                curves.push(Curve {
                    length: shape.length(),
                    closed: shape.is_closed(),
                    course: Course::Rim {
                        solid,
                        segment,
                        sweep,
                    },
                });
            }
        }
    }
    curves
}

/// The curves in which two faces meet: each is found where it crosses a grid on either face, and
/// followed both ways, a step along both faces and Newton's method back onto them.
fn meetings(boundary: &Boundary, pair: [usize; 2], step: f64) -> Vec<Curve> {
    let small = pair.map(|face| boundary.faces[face].bounds.diagonal() / 60.0);
    let step = step.min(small[0]).min(small[1]);
    let mut found: Vec<Curve> = Vec::new();
    for (face, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
        for start in crossings(boundary, face, other) {
            let start = boundary.settle(start, &pair);
            let known = |curve: &Curve| match &curve.course {
                Course::Meeting { points, .. } => {
                    points.iter().any(|p| (p - start).norm() < 1.5 * step)
                }
                _ => false,
            };
            if on_both(boundary, pair, &start) && !found.iter().any(known) {
                found.extend(follow(boundary, pair, start, step));
            }
        }
    }
    found
}

/// Points of a grid on one face where the other's carrier passes through.
fn crossings(boundary: &Boundary, face: usize, other: usize) -> Vec<Point> {
    const STEPS: usize = 48;
    let Face { solid, .. } = boundary.faces[face];
    let (face, solid) = (&boundary.faces[face], &boundary.solids[solid]);
    let Domain { low, high, .. } = face.domain(solid);
    let chart = |i: f64, j: f64| -> Chart {
        [(0, i), (1, j)].map(|(k, step)| low[k] + (high[k] - low[k]) * step / STEPS as f64)
    };
    let offset = |chart: Chart| boundary.foot(other, &face.point(solid, chart)).offset;
    let at = |i: usize, j: usize| offset(chart(i as f64, j as f64));
    let mut starts = Vec::new();
    let mut before: Vec<f64> = Vec::new();
    for i in 0..=STEPS {
        let row: Vec<f64> = (0..=STEPS).map(|j| at(i, j)).collect();
        let mut bisect = |from: [f64; 2], to: [f64; 2], negative: bool| {
            let (mut low, mut high) = (0.0, 1.0);
            let between = |t: f64| {
                chart(
                    from[0] + (to[0] - from[0]) * t,
                    from[1] + (to[1] - from[1]) * t,
                )
            };
            for _ in 0..30 {
                let middle = (low + high) / 2.0;
                if (offset(between(middle)) < 0.0) == negative {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            starts.push(face.point(solid, between(low)));
        };
        let here = i as f64;
        for j in 0..=STEPS {
            let (negative, column) = (row[j] < 0.0, j as f64);
            if j < STEPS && negative != (row[j + 1] < 0.0) {
                bisect([here, column], [here, column + 1.0], negative);
            }
            if i > 0 && negative != (before[j] < 0.0) {
                bisect([here, column], [here - 1.0, column], negative);
            }
        }
        before = row;
    }
    starts
}

/// Whether both faces, before other solids have their say, hold a point of their meeting.
fn on_both(boundary: &Boundary, pair: [usize; 2], point: &Point) -> bool {
    let on = tolerance::ON * boundary.diagonal;
    pair.iter().all(|&index| {
        let face = &boundary.faces[index];
        let foot = boundary.foot(index, point);
        foot.offset.abs() < on && face.holds(&boundary.solids[face.solid], foot.chart, on)
    })
}

/// Follows a meeting both ways from a point, to its end or round to its start. An open one goes a
/// step beyond its ends.
fn follow(boundary: &Boundary, pair: [usize; 2], start: Point, step: f64) -> Option<Curve> {
    let limit = (30.0 * boundary.diagonal / step) as usize;
    let mut points = vec![start];
    let mut closed = false;
    'ways: for way in [1.0, -1.0] {
        let (mut point, mut heading) = (start, Vector::zeros());
        while points.len() < limit {
            let [a, b] = pair.map(|face| boundary.foot(face, &point).gradient);
            let Some(tangent) = a.cross(&b).try_normalize(1e-5) else {
                break;
            };
            // Past a saddle of the offsets the tangent may turn round.
            let turned = heading.dot(&tangent) < 0.0;
            heading = if heading == Vector::zeros() {
                tangent * way
            } else if turned {
                -tangent
            } else {
                tangent
            };
            point = boundary.settle(point + heading * step, &pair);
            points.push(point);
            if !on_both(boundary, pair, &point) {
                break;
            }
            if way > 0.0 && points.len() > 4 && (point - start).norm() < 0.9 * step {
                points.pop();
                points.push(start);
                closed = true;
                break 'ways;
            }
        }
        if way > 0.0 {
            points.reverse();
        }
    }
    let mut lengths = vec![0.0];
    let mut length = 0.0;
    for ends in points.windows(2) {
        length += (ends[1] - ends[0]).norm();
        lengths.push(length);
    }
    (points.len() > 1).then_some(Curve {
        length,
        closed,
        course: Course::Meeting {
            points,
            lengths,
            faces: pair,
        },
    })
}
