//! Open borders: where an accepted surface ends and nothing yet begins.
//!
//! The surface of a solid is closed: along every edge two faces meet. A ring, chamfer or countersink
//! one point wide has no interior points, so none of its points ever looks unexplained: all lie on
//! the edges of its neighbours. But these edges are open, held by one surface alone, until the
//! missing face is found.

use std::f64::consts::TAU;

use nalgebra::{Matrix2, Vector2};

use crate::cloud::neighbours::Neighbour;
use crate::cloud::{Direction, Vector};
use crate::fit::holders::Holders;
use crate::fit::{Candidate, Search};
use crate::surface::{Surface, across};

/// Angle without neighbours, in radians, above which a point is on the border of its surface. On a
/// straight border it is π; inside a face of evenly spread points it stays below 1.5.
const GAP: f64 = 1.9;
/// Nearest points of a patch among which a gap is looked for. Of the patch, not of the cloud: where
/// points along the rulings of narrow faces are sparse, the nearest are on other faces.
const AROUND: usize = 10;
/// How far off they may be, in spacings.
const REACH: f64 = 12.0;
/// How far inside, in radians, the next points along a border may lie.
const ALONG: f64 = 0.4;

/// Points in which surfaces must meet to be neighbours.
const ANCHOR: usize = 3;

/// Root mean square error of a thin face, in tolerances: those of the training clouds stay below,
/// and narrow cylinders over free-form regions fill the tolerance.
const EXACT: f64 = 0.03;
/// As [`EXACT`], in errors of the cloud's median face, where that is more.
const AS_EXACT: f64 = 10.0;

/// A point on the border of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BorderPoint {
    /// The point.
    pub index: u32,
    /// The points before and after it along the border.
    pub along: [u32; 2],
}

/// The points of a patch around which its other points leave a gap. O(points of the patch).
pub fn border(search: &Search<'_>, candidate: &Candidate) -> Vec<BorderPoint> {
    border_within(search, candidate, |index| {
        candidate.support.binary_search(&index).is_ok()
    })
}

/// As [`border`], where it is known which points are the patch's.
fn border_within(
    search: &Search<'_>,
    candidate: &Candidate,
    is_inside: impl Fn(u32) -> bool,
) -> Vec<BorderPoint> {
    let (mut near, mut steps) = (Vec::new(), Vec::new());
    let points = candidate.support.iter();
    points
        .filter_map(|&index| {
            let surface = &candidate.surface;
            let along = ends(search, surface, &is_inside, index, &mut near, &mut steps)?;
            Some(BorderPoint { index, along })
        })
        .collect()
}

/// A step from a point to a neighbour, seen along the normal.
#[derive(Debug, Clone, Copy)]
struct Step {
    angle: f64,
    length: f64,
    to: u32,
}

/// The neighbours of a point along the border of a patch; `None` for a point inside.
fn ends(
    search: &Search<'_>,
    surface: &Surface,
    is_inside: impl Fn(u32) -> bool,
    index: u32,
    near: &mut Vec<Neighbour>,
    steps: &mut Vec<Step>,
) -> Option<[u32; 2]> {
    if search.graph.of(index).iter().all(|&i| is_inside(i)) {
        return None;
    }
    let point = search.point(index);
    let normal = surface.normal(point);
    let radius = REACH * search.scale.spacing;
    search
        .tree
        .nearest(point, AROUND + 1, radius, &is_inside, near);
    steps.clear();
    let others = near
        .iter()
        .map(|neighbour| neighbour.index)
        .filter(|&to| to != index);
    around(
        &normal,
        others.map(|to| (to, search.point(to) - point)),
        steps,
    );
    let (gap, before, after) = widest_gap(steps);
    if gap <= GAP {
        return None;
    }
    // Of the points in about the direction of the border's end, the nearest is the next along it.
    let next = |end: f64, side: f64| {
        let along = steps.iter().filter(|step| {
            let inward = (side * (step.angle - end)).rem_euclid(TAU);
            !(ALONG..=TAU - 1e-9).contains(&inward)
        });
        along
            .min_by(|a, b| a.length.total_cmp(&b.length))
            .map_or(index, |step| step.to)
    };
    Some([next(before, -1.0), next(after, 1.0)])
}

/// The steps by angle in the tangent plane, ascending, in coordinates in which they are spread
/// equally in all directions: where points along rulings are sparse, those on the next ruling lie
/// almost straight ahead and behind, and a gap would seem to open between them.
fn around(normal: &Direction, seen: impl Iterator<Item = (u32, Vector)>, steps: &mut Vec<Step>) {
    let first = across(normal);
    let second = normal.cross(&first);
    let flat = seen.map(|(to, step)| (to, Vector2::new(step.dot(&first), step.dot(&second))));
    let flat: Vec<(u32, Vector2<f64>)> = flat.collect();
    let moments: Matrix2<f64> = flat.iter().map(|(_, step)| step * step.transpose()).sum();
    let even = moments.cholesky().and_then(|root| root.l().try_inverse());
    let even = even.unwrap_or_else(Matrix2::identity);
    steps.extend(flat.into_iter().map(|(to, step)| {
        let turned = even * step;
        Step {
            angle: libm::atan2(turned.y, turned.x),
            length: turned.norm(),
            to,
        }
    }));
    steps.sort_by(|a, b| a.angle.total_cmp(&b.angle));
}

/// The widest angle without a step, and the angles at which it begins and ends; a full turn for
/// fewer than two steps.
fn widest_gap(steps: &[Step]) -> (f64, f64, f64) {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else {
        return (TAU, 0.0, 0.0);
    };
    let around = (first.angle + TAU - last.angle, last.angle, first.angle);
    steps
        .windows(2)
        .map(|pair| (pair[1].angle - pair[0].angle, pair[0].angle, pair[1].angle))
        .fold(
            around,
            |widest, gap| if gap.0 > widest.0 { gap } else { widest },
        )
}

/// What is known of every point's place among the accepted surfaces.
#[derive(Debug, Clone)]
pub struct Borders {
    state: Vec<State>,
    /// The accepted surfaces through each point.
    holders: Holders,
    /// Whether each accepted surface is certain by itself, without its neighbours.
    certain: Vec<bool>,
    /// How many surfaces had been accepted when the last to hold each point was.
    since: Vec<u32>,
    /// Largest root mean square error of a thin face, in the units of the cloud.
    exact: f64,
}

/// A point's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// On no accepted surface.
    Unexplained,
    /// On an open border of this accepted surface.
    Open(u32, [u32; 2]),
    /// Inside a surface, or where two meet.
    Settled,
}

impl Borders {
    /// Looks at every point. O(n).
    pub fn of(search: &Search<'_>) -> Self {
        let held = search.accepted().iter().map(|face| face.support.len());
        let mut borders = Self {
            state: vec![State::Unexplained; search.cloud.len()],
            holders: Holders::with_room(search.cloud.len(), held.sum()),
            certain: vec![true; search.accepted().len()],
            since: vec![0; search.cloud.len()],
            exact: exact(search),
        };
        for (number, candidate) in (0_u32..).zip(search.accepted()) {
            borders.holders.add(number, &candidate.support);
        }
        for (number, candidate) in (0_u32..).zip(search.accepted()) {
            let holders = &borders.holders;
            let is_inside = |index| holders.of(index).any(|holder| holder == number);
            let border = border_within(search, candidate, is_inside);
            borders.open(number, candidate, &border);
        }
        borders
    }

    /// Notes which border points of a surface have edges of no other.
    fn open(&mut self, surface: u32, candidate: &Candidate, border: &[BorderPoint]) {
        for &index in &candidate.support {
            if self.state[index as usize] == State::Unexplained {
                self.state[index as usize] = State::Settled;
            }
        }
        for point in border {
            if self.is_open(surface, point) {
                self.state[point.index as usize] = State::Open(surface, point.along);
            }
        }
    }

    fn is_open(&self, surface: u32, point: &BorderPoint) -> bool {
        let mut along = point.along.iter();
        along.any(|&next| is_open_edge(&self.holders, surface, point.index, next))
    }

    /// Notes that a surface has been accepted, the last: it closes borders of others and has its own.
    pub fn settle(
        &mut self,
        surface: u32,
        candidate: &Candidate,
        border: &[BorderPoint],
        is_certain: bool,
    ) {
        self.certain.push(is_certain);
        self.holders.add(surface, &candidate.support);
        for &index in &candidate.support {
            self.since[index as usize] = surface + 1;
            let state = self.state[index as usize];
            self.state[index as usize] = match state {
                State::Open(owner, along) if self.is_open(owner, &BorderPoint { index, along }) => {
                    state
                }
                _ => State::Settled,
            };
        }
        self.open(surface, candidate, border);
    }

    /// Takes as known all faces at some points, marked for each point of the cloud: a border of theirs
    /// that seems open only has its next points far away. O(n).
    pub fn close(&mut self, told: &[bool]) {
        for (state, _) in self.state.iter_mut().zip(told).filter(|(_, told)| **told) {
            *state = State::Settled;
        }
    }

    /// Whether a point is unexplained or on an open border.
    pub fn is_free(&self, index: u32) -> bool {
        self.state[index as usize] != State::Settled
    }

    /// Whether one of some points has been held anew since so many surfaces were accepted.
    pub fn is_new(&self, points: &[u32], accepted: usize) -> bool {
        let mut points = points.iter();
        points.any(|&index| self.since[index as usize] as usize > accepted)
    }

    /// The position, among the accepted, of the surface whose open border a point is on.
    pub fn owner(&self, index: u32) -> Option<u32> {
        match self.state[index as usize] {
            State::Open(owner, _) => Some(owner),
            _ => None,
        }
    }

    /// Whether a candidate is as exact as the cloud's faces.
    pub fn is_exact(&self, candidate: &Candidate) -> bool {
        candidate.error <= self.exact
    }

    /// Whether a new surface joins one that is certain by itself. Otherwise a free-form extrusion would
    /// be covered with narrow cylinders, each next to the last.
    pub fn is_anchored(&self, support: &[u32]) -> bool {
        let is_certain = |&&index: &&u32| {
            let mut holders = self.holders.of(index);
            holders.any(|holder| self.certain[holder as usize])
        };
        support.iter().filter(is_certain).count() >= ANCHOR
    }

    /// How many free points a new surface would settle, and whether they show that it is there: on
    /// the border of one surface alone a second one always finds a row of points to pass through, so
    /// the free points must come from two sides, or from one side and from none.
    pub fn evidence(&self, support: &[u32]) -> Option<usize> {
        let mut sides: Vec<(Option<u32>, usize)> = Vec::new();
        for &index in support.iter().filter(|&&index| self.is_free(index)) {
            let owner = self.owner(index);
            match sides.iter_mut().find(|(side, _)| *side == owner) {
                Some((_, count)) => *count += 1,
                None => sides.push((owner, 1)),
            }
        }
        let total: usize = sides.iter().map(|(_, count)| count).sum();
        let largest = sides.iter().map(|(_, count)| *count).max().unwrap_or(0);
        let others = total - largest;
        let two_sided = others >= 2 && 6 * others >= total;
        let mostly_free = 5 * total >= 3 * support.len();
        (two_sided && mostly_free).then_some(total)
    }
}

/// Whether the edge between two border points of a surface belongs to no other.
fn is_open_edge(holders: &Holders, surface: u32, a: u32, b: u32) -> bool {
    let mut others = holders.of(a).filter(|&other| other != surface);
    !others.any(|other| holders.of(b).any(|it| it == other))
}

/// How exact a thin face of a cloud must be. Of the narrow pieces that pass within the tolerance
/// through a few rows of points, true faces are as exact as all the others of their cloud.
pub fn exact(search: &Search<'_>) -> f64 {
    let mut errors: Vec<f64> = search.accepted().iter().map(|face| face.error).collect();
    errors.sort_unstable_by(f64::total_cmp);
    let median = errors.get(errors.len() / 2).copied().unwrap_or(0.0);
    let exact = search.scale.largest_error(EXACT);
    if search.scale.has_noise() {
        exact
    } else {
        exact.max(AS_EXACT * median)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(angles: impl Iterator<Item = f64>) -> Vec<Step> {
        let mut steps = Vec::new();
        let seen = (0..).zip(angles.map(|angle| Vector::new(angle.cos(), angle.sin(), 0.0)));
        around(&Vector::z_axis(), seen, &mut steps);
        steps
    }

    #[test]
    fn a_point_on_a_straight_border_sees_a_gap_of_half_a_turn() {
        let half = steps((0..=8).map(|i| f64::from(i) * std::f64::consts::PI / 8.0));
        let (gap, _, _) = widest_gap(&half);
        assert!((gap - std::f64::consts::PI).abs() < 1e-12);
        let (gap, _, _) = widest_gap(&steps((0..6).map(f64::from)));
        assert!(gap < 1.3);
    }

    #[test]
    fn an_edge_is_closed_once_two_surfaces_hold_both_its_ends() {
        let mut holders = Holders::with_room(4, 0);
        holders.add(0, &[0, 1, 2]);
        holders.add(1, &[1, 3]);
        assert!(is_open_edge(&holders, 0, 1, 2));
        holders.add(2, &[1, 2]);
        assert!(!is_open_edge(&holders, 0, 1, 2));
    }

    #[test]
    fn evidence_needs_free_points_from_two_sides() {
        let open = |owner| vec![State::Open(owner, [0, 0]); 5];
        let borders = Borders {
            state: [open(0), open(1), vec![State::Settled; 5]].concat(),
            holders: Holders::with_room(15, 0),
            certain: vec![true; 2],
            since: vec![0; 15],
            exact: 0.0,
        };
        let support = |range: std::ops::Range<u32>| range.collect::<Vec<u32>>();
        assert_eq!(borders.evidence(&support(0..5)), None);
        assert_eq!(borders.evidence(&support(0..10)), Some(10));
        assert_eq!(borders.evidence(&support(4..15)), None);
    }
}
