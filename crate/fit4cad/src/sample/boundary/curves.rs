//! Curves that may hold edges: those of the solids themselves, and those in which faces of
//! different solids meet.

use nalgebra::Point2;

use super::super::blocks::Sweep;
use super::face::{Chart, Domain};
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

/// All curves that may hold edges, found at least as finely as the given step.
pub fn curves(boundary: &Boundary, step: f64) -> Vec<Curve> {
    let mut curves = own_curves(boundary);
    for (first, a) in boundary.faces.iter().enumerate() {
        for (second, b) in boundary.faces.iter().enumerate().skip(first + 1) {
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

/// Points of a grid on one face where the other's carrier passes through at an angle that can be
/// followed.
fn crossings(boundary: &Boundary, face: usize, other: usize) -> Vec<Point> {
    let grid = Grid::new(boundary, face, other);
    let signs = grid.signs();
    let mut starts = Vec::new();
    let mut bisect = |from: [usize; 2], to: [usize; 2]| {
        if !(grid.is_tangent(from) && grid.is_tangent(to)) {
            starts.push(grid.crossing(from, to, signs[from[0]][from[1]]));
        }
    };
    for i in 0..=STEPS {
        for j in 0..=STEPS {
            let here = signs[i][j];
            if j < STEPS && here != signs[i][j + 1] {
                bisect([i, j], [i, j + 1]);
            }
            if i > 0 && here != signs[i - 1][j] {
                bisect([i, j], [i - 1, j]);
            }
        }
    }
    starts
}

/// Steps of a grid along either coordinate of a face.
const STEPS: usize = 48;

/// Most length of a meeting, over the diagonal of the smaller face's box. A circle is 2.2 of its own.
const ROUNDS: f64 = 30.0;

/// Sine of the angle under which two faces count as tangent: their meeting has no direction.
const TANGENT: f64 = 1e-5;

/// A grid on one face, and how far its places are from the carrier of another.
struct Grid<'a> {
    boundary: &'a Boundary,
    face: usize,
    other: usize,
    domain: Domain,
    /// Length of a step along either coordinate, at most.
    reach: Chart,
}

impl<'a> Grid<'a> {
    fn new(boundary: &'a Boundary, face: usize, other: usize) -> Self {
        let solid = &boundary.solids[boundary.faces[face].solid];
        let domain = boundary.faces[face].domain(solid);
        let step = |k: usize| (domain.high[k] - domain.low[k]) / STEPS as f64;
        let pace = boundary.faces[face].widest_pace(solid);
        Self {
            boundary,
            face,
            other,
            domain,
            reach: [step(0), step(1) * pace],
        }
    }

    fn point(&self, at: [f64; 2]) -> Point {
        let Domain { low, high, .. } = self.domain;
        let chart = [0, 1].map(|k| low[k] + (high[k] - low[k]) * at[k] / STEPS as f64);
        let face = &self.boundary.faces[self.face];
        face.point(&self.boundary.solids[face.solid], chart)
    }

    fn offset(&self, at: [f64; 2]) -> f64 {
        self.boundary.foot(self.other, &self.point(at)).offset
    }

    /// Whether the offset is negative, at every place. A distance grows no faster than the way: a
    /// block of places that is farther from the carrier than it is large has one sign throughout,
    /// which is most of them.
    fn signs(&self) -> Vec<[bool; STEPS + 1]> {
        let mut signs = vec![[false; STEPS + 1]; STEPS + 1];
        // Half-open ranges of places along either coordinate.
        let mut open = vec![[[0, STEPS + 1], [0, STEPS + 1]]];
        while let Some(block) = open.pop() {
            let [rows, columns] = block;
            let offset = self.offset(block.map(|[low, high]| (low + high - 1) as f64 / 2.0));
            let half = |k: usize| (block[k][1] - 1 - block[k][0]) as f64 / 2.0 * self.reach[k];
            let alone = rows[1] - rows[0] == 1 && columns[1] - columns[0] == 1;
            // The margin is for the digits; a free-form foot may leap at the ends of its curve.
            let measured = self.boundary.faces[self.other].surface.is_some();
            if alone || measured && offset.abs() > 1.01 * (half(0) + half(1)) {
                for row in &mut signs[rows[0]..rows[1]] {
                    row[columns[0]..columns[1]].fill(offset < 0.0);
                }
                continue;
            }
            let halves = |[low, high]: [usize; 2]| {
                let middle = low + (high - low).div_ceil(2);
                let parts = [[low, middle], [middle, high]];
                parts.into_iter().filter(|[low, high]| low < high)
            };
            open.extend(halves(rows).flat_map(|r| halves(columns).map(move |c| [r, c])));
        }
        signs
    }

    /// Whether the faces run along each other at a place.
    fn is_tangent(&self, at: [usize; 2]) -> bool {
        let point = self.point(at.map(|k| k as f64));
        let [a, b] = [self.face, self.other].map(|f| self.boundary.foot(f, &point).gradient);
        a.cross(&b).norm() < TANGENT
    }

    /// The place between two where the sign changes, by bisection.
    fn crossing(&self, from: [usize; 2], to: [usize; 2], negative: bool) -> Point {
        let [from, to] = [from, to].map(|at| at.map(|k| k as f64));
        let between = |t: f64| [0, 1].map(|k| from[k] + (to[k] - from[k]) * t);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..30 {
            let middle = (low + high) / 2.0;
            if (self.offset(between(middle)) < 0.0) == negative {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.point(between(low))
    }
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
    // A meeting winds over the smaller face; where rounding leads it past its start, it is not to go on
    // for as many steps as the part is larger than that.
    let sizes = pair.map(|face| boundary.faces[face].bounds.diagonal());
    let limit = (ROUNDS * sizes[0].min(sizes[1]) / step) as usize;
    let mut points = vec![start];
    let mut closed = false;
    'ways: for way in [1.0, -1.0] {
        let (mut point, mut heading) = (start, Vector::zeros());
        while points.len() < limit {
            let [a, b] = pair.map(|face| boundary.foot(face, &point).gradient);
            let Some(tangent) = a.cross(&b).try_normalize(TANGENT) else {
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
