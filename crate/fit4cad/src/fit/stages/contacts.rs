//! Contacts: where two bodies touch, a face of the one lies on a face of the other.
//!
//! Both are on one plane, and within the rim of the smaller the points of both are mixed. Each face
//! was meshed by itself, its points evenly apart; laid over each other they are twice as dense, and
//! any two points that are nearer than the points of either face ever are belong to different faces.
//! These pairs, the nearest first, tell the faces apart as the two sides of a bipartite graph, all the
//! way from the rim, which is of the one face, to the points beyond it, which are of the other.

use super::super::search::Search;
use super::label::Labels;
use super::patches::Patch;
use super::polygon::Polygon;
use crate::cloud::Point;
use crate::cloud::neighbours::{KdTree, Neighbour};
use crate::fit::quantile::quantile;
use crate::fit::thin::chains::chains;
use crate::fit::thin::plan::Plan;
use crate::fit::thin::profile::Place;
use crate::surface::Surface;

/// Fewest points of a rim, and fewest within it and around it.
const FEWEST: usize = 12;
/// Longest step from one point of a rim to the next, in spacings.
const STEP: f64 = 8.0;
/// Neighbours that tell how dense points are.
const NEIGHBOURS: usize = 12;
/// Ratio of densities above which points may be those of two faces.
const DENSER: f64 = 1.6;
/// Distance of the nearest neighbour, in distances of the farthest of [`NEIGHBOURS`], that it has not
/// among even points.
const CLOSE: f64 = 0.33;
/// Share of such points among those of two faces.
const MIXED: f64 = 0.4;
/// Distance, in that of even neighbours, below which pairs are of different faces unless nearer pairs
/// say otherwise.
const REACH: f64 = 1.15;
/// As [`REACH`], of pairs that are surely of different faces.
const SURE: f64 = 0.66;
/// Share of the points about which sure pairs may contradict each other.
const CONTRADICTED: f64 = 0.02;

/// Splits the planar patches of a clean cloud on which another face lies. Where the points of the two
/// cannot be told apart, those within the rim are given to both. O(n log n).
pub fn split_contacts(search: &Search<'_>, labels: &Labels, patches: Vec<Patch>) -> Vec<Patch> {
    if !search.scale.is_clean() {
        return patches;
    }
    let mut split = Vec::with_capacity(patches.len());
    for mut patch in patches {
        if let Surface::Plane(plane) = &patch.surface {
            let plan = Plan::new(Point::origin(), plane.normal);
            for rim in rims(search, labels, &plan, &patch.points) {
                if let Some([upper, lower]) = faces(search, labels, &plan, &patch.points, &rim) {
                    let surface = patch.surface;
                    split.push(Patch {
                        surface,
                        points: upper,
                    });
                    patch.points = lower;
                }
            }
        }
        split.push(patch);
    }
    split
}

/// Closed curves of points of a plane that are on other surfaces too, each on one in common with the
/// next. The first point comes last again.
fn rims(search: &Search<'_>, labels: &Labels, plan: &Plan, points: &[u32]) -> Vec<Vec<u32>> {
    let edge: Vec<u32> = points
        .iter()
        .copied()
        .filter(|&index| labels.of(index).len() > 1)
        .collect();
    let places: Vec<Place> = edge.iter().map(|&i| plan.place(search.point(i))).collect();
    // One of the surfaces that they have in common is the plane.
    let beside = |a: usize, b: usize| {
        let others = labels.of(edge[b]);
        let common = labels.of(edge[a]).iter().filter(|it| others.contains(it));
        common.count() > 1
    };
    let reach = STEP * search.scale.spacing;
    chains(&places, &vec![2; places.len()], reach, beside, |_, _| true)
        .into_iter()
        .filter(|chain| chain.is_closed && chain.places.len() > FEWEST)
        .map(|chain| chain.places.iter().map(|&place| edge[place]).collect())
        .collect()
}

/// The points of the face within a rim, and those of the face on which it lies; `None` where there is
/// but one.
fn faces(
    search: &Search<'_>,
    labels: &Labels,
    plan: &Plan,
    points: &[u32],
    rim: &[u32],
) -> Option<[Vec<u32>; 2]> {
    let corners: Vec<Place> = rim.iter().map(|&i| plan.place(search.point(i))).collect();
    let outline = Polygon::new(&corners);
    // Positions in `points` of those on no other surface.
    let own = (0..points.len()).filter(|&at| labels.of(points[at]).len() == 1);
    let is_inside = |&at: &usize| outline.holds(plan.place(search.point(points[at])));
    let (inside, outside): (Vec<usize>, Vec<usize>) = own.partition(is_inside);
    if inside.len() < FEWEST || outside.len() < FEWEST {
        return None;
    }
    let cloud = search.points(points);
    let tree = KdTree::new(&cloud);
    let within = Evenness::of(&cloud, &tree, &inside);
    let around = Evenness::of(&cloud, &tree, &outside);
    let is_double = within.density > DENSER * around.density
        && within.close > MIXED
        && within.close > 2.0 * around.close;
    if !is_double {
        return None;
    }
    let mut role = vec![Role::Edge; points.len()];
    for &at in &outside {
        role[at] = Role::Lower;
    }
    for (number, &at) in inside.iter().enumerate() {
        role[at] = Role::Open(number);
    }
    for index in rim {
        if let Ok(at) = points.binary_search(index) {
            role[at] = Role::Upper;
        }
    }
    let sides = told_apart(&cloud, &tree, &inside, &role, around.step);
    let is_upper = |at: usize, otherwise: bool| match role[at] {
        Role::Upper => true,
        Role::Lower | Role::Edge => false,
        Role::Open(number) => sides
            .as_ref()
            .map_or(otherwise, |is_upper| is_upper[number]),
    };
    let pick = |keep: &dyn Fn(usize) -> bool| {
        let kept = (0..points.len()).filter(|&at| keep(at));
        kept.map(|at| points[at]).collect::<Vec<u32>>()
    };
    Some([
        pick(&|at| is_upper(at, true)),
        pick(&|at| !is_upper(at, false)),
    ])
}

/// To which face a point belongs.
#[derive(Debug, Clone, Copy)]
enum Role {
    /// That within the rim, as the rim itself.
    Upper,
    /// That around the rim.
    Lower,
    /// On other edges of the plane.
    Edge,
    /// Within the rim, one of either face; by its number.
    Open(usize),
}

/// How points lie among each other.
struct Evenness {
    /// Points per area, but for a factor.
    density: f64,
    /// Distance of nearest neighbours.
    step: f64,
    /// Share of points whose nearest neighbour is closer than even points have it.
    close: f64,
}

impl Evenness {
    /// Medians over some of the points.
    fn of(cloud: &[Point], tree: &KdTree, part: &[usize]) -> Self {
        let mut near: Vec<Neighbour> = Vec::new();
        let mut steps = Vec::with_capacity(part.len());
        let mut reaches = Vec::with_capacity(part.len());
        for &at in part {
            let is_other = |other: u32| other as usize != at;
            tree.nearest(&cloud[at], NEIGHBOURS, f64::INFINITY, is_other, &mut near);
            if let [first, .., last] = near[..] {
                steps.push(first.distance_squared.sqrt());
                reaches.push(last.distance_squared.sqrt());
            }
        }
        let pairs = steps.iter().zip(&reaches);
        let close = pairs
            .filter(|(step, reach)| **step < CLOSE * **reach)
            .count();
        Self {
            close: close as f64 / steps.len().max(1) as f64,
            density: quantile(&mut reaches, 0.5).powi(-2),
            step: quantile(&mut steps, 0.5),
        }
    }
}

/// Of each of the points within a rim, whether it belongs to the face of the rim; `None` where close
/// pairs contradict each other.
fn told_apart(
    cloud: &[Point],
    tree: &KdTree,
    inside: &[usize],
    role: &[Role],
    step: f64,
) -> Option<Vec<bool>> {
    let (upper, lower) = (inside.len(), inside.len() + 1);
    let node = |at: usize| match role[at] {
        Role::Upper => Some(upper),
        Role::Lower => Some(lower),
        Role::Edge => None,
        Role::Open(number) => Some(number),
    };
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    let mut near = Vec::new();
    for (number, &at) in inside.iter().enumerate() {
        let is_other = |other: u32| other as usize != at;
        let all = cloud.len();
        tree.nearest(&cloud[at], all, REACH * step, is_other, &mut near);
        for neighbour in &near {
            if let Some(other) = node(neighbour.index as usize)
                && other > number
            {
                pairs.push((neighbour.distance_squared.sqrt(), number, other));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut sides = Sides::new(inside.len() + 2);
    sides.part(upper, lower);
    let mut contradictions = 0;
    for (distance, a, b) in pairs {
        let agrees = sides.part(a, b);
        contradictions += usize::from(!agrees && distance < SURE * step);
    }
    if contradictions as f64 > CONTRADICTED * inside.len() as f64 {
        return None;
    }
    let is_upper = |number| sides.are_parted(number, lower) == Some(true);
    Some((0..inside.len()).map(is_upper).collect())
}

/// Disjoint sets of which every member is on one of two sides.
struct Sides {
    /// The parent of each, and whether it is on the other side than that.
    parents: Vec<(usize, bool)>,
    sizes: Vec<usize>,
}

impl Sides {
    fn new(count: usize) -> Self {
        Self {
            parents: (0..count).map(|it| (it, false)).collect(),
            sizes: vec![1; count],
        }
    }

    /// The root of a set, and whether the member is on the other side. O(log n), as the smaller set
    /// always hangs from the larger.
    fn root(&self, mut member: usize) -> (usize, bool) {
        let mut is_across = false;
        loop {
            let (parent, across) = self.parents[member];
            if parent == member {
                return (member, is_across);
            }
            is_across ^= across;
            member = parent;
        }
    }

    /// Whether two are on different sides, where they are in one set.
    fn are_parted(&self, a: usize, b: usize) -> Option<bool> {
        let ((one, a), (other, b)) = (self.root(a), self.root(b));
        (one == other).then_some(a != b)
    }

    /// Puts two on different sides, unless they are on one already. Returns whether they are on
    /// different ones.
    fn part(&mut self, a: usize, b: usize) -> bool {
        let ((one, a), (other, b)) = (self.root(a), self.root(b));
        if one == other {
            return a != b;
        }
        let (small, large) = if self.sizes[one] < self.sizes[other] {
            (one, other)
        } else {
            (other, one)
        };
        self.parents[small] = (large, a == b);
        self.sizes[large] += self.sizes[small];
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Cloud;
    use crate::fit::{Method, Parameters, fit};
    use crate::surface::SurfaceType;
    use std::f64::consts::TAU;

    /// A lattice of triangles of side one, turned by an angle, without what is farther from the origin
    /// than `reach` in both directions.
    fn lattice(angle: f64, reach: f64) -> impl Iterator<Item = Place> {
        let (sin, cos) = angle.sin_cos();
        let rows = -40..=40;
        let places = rows.flat_map(|j| (-40..=40).map(move |i| (f64::from(i), f64::from(j))));
        places
            .map(move |(i, j)| [i + 0.5 * j + 0.31, 0.75f64.sqrt() * j + 0.17])
            .map(move |[x, y]| [cos * x - sin * y, sin * x + cos * y])
            .filter(move |place| place.iter().all(|it| it.abs() <= reach))
    }

    /// A boss of radius 6 that stands on a plate: of the plate, of the bottom of the boss with its rim,
    /// and of its wall the points, and where they begin.
    fn boss_on_plate() -> (Vec<Point>, [usize; 3]) {
        let mut points: Vec<Point> = lattice(0.0, 18.0)
            .map(|[x, y]| Point::new(x, y, 0.0))
            .collect();
        let plate = points.len();
        let bottom = lattice(0.4, 18.0).filter(|[x, y]| x.hypot(*y) < 5.3);
        points.extend(bottom.map(|[x, y]| Point::new(x, y, 0.0)));
        let ring = |z: u32| {
            (0..38).map(move |i| {
                let (sin, cos) = (TAU * f64::from(i) / 38.0).sin_cos();
                Point::new(6.0 * cos, 6.0 * sin, f64::from(z))
            })
        };
        points.extend(ring(0));
        let boss = points.len();
        points.extend((1..9).flat_map(ring));
        let all = points.len();
        (points, [plate, boss, all])
    }

    #[test]
    fn a_boss_and_the_plate_it_stands_on_have_their_own_points() {
        let (points, [plate, boss, all]) = boss_on_plate();
        let cloud = Cloud::new(points);
        let found = fit(&cloud, Method::Hough, &Parameters::default(), 1, &mut ()).unwrap();
        let mut faces = found.segmentation.primitives;
        faces.sort_by_key(|face| face.points.first().copied());
        let kinds: Vec<_> = faces.iter().map(|face| face.kind.unwrap()).collect();
        use SurfaceType::{Cylinder, Plane};
        assert_eq!(kinds, [Plane, Plane, Cylinder]);
        // Where points of both happen to be about as far apart as those of one, they may be taken for each
        // other.
        let expected = [0..plate, plate..boss, boss - 38..all];
        for (face, range) in faces.iter().zip(expected) {
            let missed = range
                .clone()
                .filter(|&i| face.points.binary_search(&(i as u32)).is_err());
            let strange = face
                .points
                .iter()
                .filter(|&&i| !range.contains(&(i as usize)));
            let wrong = missed.count() + strange.count();
            assert!(50 * wrong <= boss - plate, "{wrong} of {:?}", face.kind);
        }
    }

    #[test]
    fn sides_tell_of_three_mutually_parted_that_it_cannot_be() {
        let mut sides = Sides::new(4);
        assert!(sides.part(0, 1) && sides.part(1, 2));
        assert_eq!(sides.are_parted(0, 2), Some(false));
        assert!(!sides.part(0, 2));
        assert_eq!(sides.are_parted(0, 3), None);
    }
}
