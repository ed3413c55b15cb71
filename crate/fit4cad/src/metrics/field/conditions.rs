//! Under what conditions a model is scored: noise, density, and how much of it is missing, measured
//! from its points and its truth.

use std::cmp::Ordering;
use std::f64::consts::{PI, TAU};

use crate::cloud::neighbours::{KdTree, Neighbour};
use crate::cloud::{Bounds, Cloud, Direction, Point};
use crate::disjoint::DisjointSets;
use crate::model::Segmentation;
use crate::surface::{Surface, across};

/// Points whose nearest neighbour is looked for: the median is then known to 2 % of the spread.
const LOOKED_AT: usize = 4096;
/// Places up to which openings are sought among all; of larger clouds among so many, evenly chosen.
const MOST: usize = 60_000;
/// Neighbours of a place that tell whether it is on a rim.
const AROUND: usize = 16;
/// Widest angle without a neighbour inside a face; at a straight rim it is half a turn. Of 16 neighbours
/// at random directions one place in sixty has a wider gap, on meshes and lattices none.
const GAP: f64 = 135.0 / 360.0 * TAU;
/// Points with such a gap along one step of a rim, a step being the side of the square that a point has to
/// itself: 0.69 to 0.82 for lattices, meshes and random points, along lines and around holes and discs.
const ALONG: f64 = 0.75;
/// Points of a rim farther apart are of two openings, in steps. Where the rim crosses from a face to the
/// next, neither has rim points for the radius of 16 neighbours (2.3 steps inside a face, 3.2 at a rim);
/// of random points' gaps two are within it, too few to hang together.
const LINK: f64 = 6.5;
/// Points of the smallest rim: fewer are accidents, or a hole of fewer than 20 points.
const LEAST: usize = 12;

/// What a model's points say about how hard it is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conditions {
    /// Root mean square distance of a true primitive's points to its surface, of the model the median
    /// over the points listed; in diagonals of the cloud's box. `None` without true surfaces.
    pub noise: Option<f64>,
    /// Median distance of a point to the nearest in another place, in diagonals of the cloud's box.
    /// `None` for fewer than two places.
    pub spacing: Option<f64>,
    /// Share of the points that a whole model would have and this has not, 0 to 1: an estimate from the
    /// rims of its openings, too low where faces are narrow, as rims near an edge are not told from it.
    /// `None` where all points are of one primitive, which ends in the open.
    pub missing: Option<f64>,
}

impl Conditions {
    /// Measures a model. O(n log n), some 10 µs a point.
    pub fn of(cloud: &Cloud, truth: &Segmentation) -> Self {
        let places = Places::of(cloud, truth);
        let tree = KdTree::new(&places.points);
        let diagonal = Bounds::of(&places.points).diagonal();
        let relative = |length: f64| {
            let share = length / diagonal;
            (diagonal > 0.0 && share.is_finite()).then_some(share)
        };
        Self {
            noise: noise(cloud, truth).and_then(relative),
            spacing: spacing(&places.points, &tree).and_then(relative),
            missing: missing(&places, tree, truth),
        }
    }
}

/// The median over points of the root mean square distance of their primitive's points.
fn noise(cloud: &Cloud, truth: &Segmentation) -> Option<f64> {
    let of_primitives = truth.primitives.iter().filter_map(|primitive| {
        let surface = primitive.surface?;
        let points = primitive.points.iter();
        let known = points.filter_map(|&index| cloud.points().get(index as usize));
        let (mut squares, mut count) = (0.0, 0usize);
        for point in known {
            let distance = surface.distance(point);
            squares += distance * distance;
            count += 1;
        }
        (count > 0).then(|| ((squares / count as f64).sqrt(), count))
    });
    let mut errors: Vec<(f64, usize)> = of_primitives.collect();
    errors.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    let all: usize = errors.iter().map(|(_, count)| count).sum();
    let mut below = 0;
    let middle = errors.iter().find(|(_, count)| {
        below += count;
        2 * below >= all
    });
    middle.map(|&(error, _)| error)
}

fn spacing(points: &[Point], tree: &KdTree) -> Option<f64> {
    let step = points.len().div_ceil(LOOKED_AT).max(1);
    let mut found = Vec::new();
    let looked_at = tree.order().iter().step_by(step);
    let mut distances: Vec<f64> = looked_at
        .filter_map(|&index| {
            let point = points.get(index as usize)?;
            tree.nearest(point, 2, f64::INFINITY, |_| true, &mut found);
            let other = found.iter().find(|near| near.index != index)?;
            Some(other.distance_squared.sqrt())
        })
        .collect();
    distances.sort_by(f64::total_cmp);
    distances.get(distances.len() / 2).copied()
}

/// Whose a place is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Owner {
    Nobody,
    One(u32),
    Several,
}

impl Owner {
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Nobody, one) | (one, Self::Nobody) => one,
            (one, another) if one == another => one,
            _ => Self::Several,
        }
    }
}

/// The points of a cloud, those that coincide once: a tree of thousands in one place is none.
struct Places {
    points: Vec<Point>,
    owners: Vec<Owner>,
}

impl Places {
    fn of(cloud: &Cloud, truth: &Segmentation) -> Self {
        let mut owners = vec![Owner::Nobody; cloud.len()];
        for (number, primitive) in (0u32..).zip(&truth.primitives) {
            for &index in &primitive.points {
                if let Some(owner) = owners.get_mut(index as usize) {
                    *owner = owner.with(Owner::One(number));
                }
            }
        }
        let is_finite = |point: &Point| point.iter().all(|x| x.is_finite());
        let all = cloud.points().iter().copied().zip(owners);
        let mut all: Vec<(Point, Owner)> = all.filter(|(point, _)| is_finite(point)).collect();
        all.sort_by(|(one, _), (other, _)| {
            let axes = one.iter().zip(other.iter());
            let mut unequal = axes.map(|(a, b)| a.total_cmp(b)).filter(|it| it.is_ne());
            unequal.next().unwrap_or(Ordering::Equal)
        });
        all.dedup_by(|(again, owner), (point, first)| {
            let is_same = again == point;
            if is_same {
                *first = first.with(*owner);
            }
            is_same
        });
        let (points, owners) = all.into_iter().unzip();
        Self { points, owners }
    }

    /// Every so many in the order of the tree, in which near places follow each other.
    fn thinned(&self, tree: &KdTree, step: usize) -> Self {
        let chosen = tree.order().iter().step_by(step).filter_map(|&index| {
            let index = index as usize;
            Some((*self.points.get(index)?, *self.owners.get(index)?))
        });
        let (points, owners) = chosen.unzip();
        Self { points, owners }
    }
}

/// The share of the points that a whole model would have and this has not.
fn missing(places: &Places, tree: KdTree, truth: &Segmentation) -> Option<f64> {
    let first = places.owners.first()?;
    if places.owners.iter().all(|owner| owner == first) {
        return None;
    }
    let step = places.points.len().div_ceil(MOST);
    if step > 1 {
        let thinned = places.thinned(&tree, step);
        let tree = KdTree::new(&thinned.points);
        return Some(openings(&thinned, &tree, truth));
    }
    Some(openings(places, &tree, truth))
}

fn openings(places: &Places, tree: &KdTree, truth: &Segmentation) -> f64 {
    let mut around = Vec::new();
    let (mut rim, mut radii) = (Vec::new(), Vec::new());
    for &index in tree.order() {
        let place = index as usize;
        let (Some(point), Some(&Owner::One(number))) =
            (places.points.get(place), places.owners.get(place))
        else {
            continue;
        };
        let Some(surface) = truth
            .primitives
            .get(number as usize)
            .and_then(|primitive| primitive.surface)
        else {
            continue;
        };
        tree.nearest(point, 1 + AROUND, f64::INFINITY, |_| true, &mut around);
        radii.extend(around.last().map(|far| far.distance_squared.sqrt()));
        let is_alone = around.iter().all(|near| {
            let owner = places.owners.get(near.index as usize);
            owner == Some(&Owner::One(number))
        });
        if is_alone && has_gap(point, &surface, &around, &places.points) {
            rim.push(*point);
        }
    }
    radii.sort_by(f64::total_cmp);
    // The side of the square that a point has to itself.
    let radius = radii.get(radii.len() / 2).copied().unwrap_or(0.0);
    let step = radius * (PI / AROUND as f64).sqrt();
    let gone: f64 = rims(&rim, LINK * step)
        .filter(|&count| count >= LEAST)
        .map(|count| (count as f64 / ALONG).powi(2) / (4.0 * PI))
        .sum();
    gone / (gone + places.points.len() as f64)
}

/// Whether the neighbours of a point leave open a wide angle about the normal of its surface.
fn has_gap(point: &Point, surface: &Surface, around: &[Neighbour], points: &[Point]) -> bool {
    let normal = surface.normal(point);
    let u: Direction = across(&normal);
    let v = normal.cross(&u);
    let ways = around.iter().filter_map(|near| {
        let way = points.get(near.index as usize)? - point;
        (near.distance_squared > 0.0).then(|| libm::atan2(way.dot(&v), way.dot(&u)))
    });
    let mut angles: Vec<f64> = ways.collect();
    angles.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (angles.first(), angles.last()) else {
        return false;
    };
    let between = angles.windows(2).filter_map(|pair| match pair {
        [one, other] => Some(other - one),
        _ => None,
    });
    between.fold(first + TAU - last, f64::max) > GAP
}

/// How many points each rim has: points within reach of each other are of one.
fn rims(points: &[Point], reach: f64) -> impl Iterator<Item = usize> {
    /// Neighbours on a rim that are linked: twice as many as are within reach on both sides.
    const LINKED: usize = 32;
    let tree = KdTree::new(points);
    let mut sets = DisjointSets::new(points.len());
    let mut found = Vec::new();
    for (place, point) in points.iter().enumerate() {
        tree.nearest(point, LINKED, reach, |_| true, &mut found);
        for near in &found {
            sets.join(place, near.index as usize);
        }
    }
    let mut counts = vec![0; points.len()];
    for place in 0..points.len() {
        if let Some(count) = counts.get_mut(sets.root(place)) {
            *count += 1;
        }
    }
    counts.into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;
    use crate::model::{Model, Primitive};
    use crate::sample::{Degradation, Options, degraded, generate};
    use crate::surface::Plane;

    fn part(spacing: f64) -> Model {
        let options = Options {
            seed: 3,
            spacing,
            ..Options::default()
        };
        generate("housing", &options).unwrap()
    }

    fn measured(model: &Model, by: &Degradation) -> Conditions {
        let worse = degraded(model, by, 5).unwrap();
        Conditions::of(&worse.cloud, worse.truth.as_ref().unwrap())
    }

    #[test]
    fn the_noise_that_was_made_is_measured() {
        let model = part(0.02);
        let exact = measured(&model, &Degradation::default());
        assert!(exact.noise.unwrap() < 1e-9, "{exact:?}");
        for noise in [0.0005, 0.002, 0.01] {
            let by = Degradation {
                noise,
                ..Degradation::default()
            };
            let found = measured(&model, &by).noise.unwrap();
            // The box grows with the noise, and near edges another face may be meant.
            assert!((found / noise - 1.0).abs() < 0.1, "{found}, not {noise}");
        }
    }

    #[test]
    fn one_wrong_surface_is_not_the_noise_of_the_model() {
        let mut model = part(0.02);
        let truth = model.truth.as_mut().unwrap();
        let far = Plane::new(Point::new(0.0, 0.0, 100.0), Vector::z());
        truth.primitives[0].surface = Some(Surface::Plane(far));
        let noise = Conditions::of(&model.cloud, truth).noise.unwrap();
        assert!(noise < 1e-9, "{noise}");
    }

    #[test]
    fn half_the_spacing_is_half_the_spacing() {
        let at = |spacing| {
            measured(&part(spacing), &Degradation::default())
                .spacing
                .unwrap()
        };
        let ratio = at(0.03) / at(0.015);
        assert!((ratio - 2.0).abs() < 0.2, "{ratio}");
    }

    #[test]
    fn what_is_cut_away_leaves_openings_and_a_whole_model_has_none() {
        for model in [part(0.01), generate("flange", &Options::default()).unwrap()] {
            let missing = |missing| {
                let by = Degradation {
                    missing,
                    ..Degradation::default()
                };
                measured(&model, &by).missing.unwrap()
            };
            let whole = missing(0.0);
            assert!(whole < 0.002, "{}: {whole}", model.name);
            // Too low, as the faces are narrow and cuts straight; but no whole model is taken for one.
            for share in [0.1, 0.3] {
                let found = missing(share);
                assert!(0.01 < found && found < share, "{}: {found}", model.name);
            }
        }
    }

    #[test]
    fn a_round_hole_counts_for_the_points_that_it_had() {
        // A tray: 100 × 100 points with a wall around, whose hole of radius 20 had 1257 points.
        let grid = (0..10_000).map(|k| (f64::from(k % 100), f64::from(k / 100)));
        let is_left = |&(x, y): &(f64, f64)| libm::hypot(x - 50.0, y - 50.0) > 20.0;
        let floor: Vec<Point> = grid
            .filter(is_left)
            .map(|(x, y)| Point::new(x, y, 0.0))
            .collect();
        let side = |k: i32| {
            let at = f64::from(k % 100);
            match k / 100 {
                0 => (at, -1.0),
                1 => (at, 100.0),
                2 => (-1.0, at),
                _ => (100.0, at),
            }
        };
        let wall = (0..400).map(|k| Point::new(side(k).0, side(k).1, 1.0));
        let count = floor.len() as u32;
        let cloud = Cloud::new(floor.into_iter().chain(wall).collect());
        let plane = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
        let truth = Segmentation {
            primitives: vec![Primitive::on(plane, 1, (0..count).collect())],
        };
        let missing = Conditions::of(&cloud, &truth).missing.unwrap();
        let expected = 1257.0 / 10_400.0;
        // Of the rim of a lattice along the axes fewer points show than of any other.
        assert!((missing / expected - 1.0).abs() < 0.3, "{missing}");
    }

    #[test]
    fn one_segment_does_not_say_what_is_missing_and_one_place_says_nothing() {
        let (cloud, plane) = (
            Cloud::new(
                (0..50)
                    .map(|k| Point::new(f64::from(k), 0.0, 0.0))
                    .collect(),
            ),
            Surface::Plane(Plane::new(Point::origin(), Vector::z())),
        );
        let truth = |points: Vec<u32>| Segmentation {
            primitives: vec![Primitive::on(plane, 1, points)],
        };
        let found = Conditions::of(&cloud, &truth((0..50).collect()));
        assert_eq!(found.missing, None);
        assert_eq!((found.noise, found.spacing), (Some(0.0), Some(1.0 / 49.0)));
        let heap = Cloud::new(vec![Point::origin(); 5000]);
        let nothing = Conditions::of(&heap, &truth((0..5000).collect()));
        assert_eq!(nothing, Conditions::default());
        assert_eq!(
            Conditions::of(&Cloud::default(), &truth(Vec::new())),
            Conditions::default()
        );
    }

    #[test]
    fn the_order_of_the_points_changes_nothing() {
        let model = part(0.03);
        let by = Degradation {
            missing: 0.2,
            noise: 0.001,
            ..Degradation::default()
        };
        let worse = degraded(&model, &by, 5).unwrap();
        let truth = worse.truth.unwrap();
        let count = worse.cloud.len() as u32;
        let turned = Cloud::new(worse.cloud.points().iter().rev().copied().collect());
        let mut again = truth.clone();
        for primitive in &mut again.primitives {
            for index in &mut primitive.points {
                *index = count - 1 - *index;
            }
            primitive.points.sort_unstable();
        }
        let (one, other) = (
            Conditions::of(&worse.cloud, &truth),
            Conditions::of(&turned, &again),
        );
        assert_eq!((one.spacing, one.missing), (other.spacing, other.missing));
        assert!((one.noise.unwrap() - other.noise.unwrap()).abs() < 1e-12);
    }
}
