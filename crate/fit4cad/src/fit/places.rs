//! Places: a cloud as the fitters see it, each place once.
//!
//! A file may list every point several times, as the corners of the triangles of a mesh are, or
//! measured again and again with a little jitter. The nearest neighbours of a point are then its own
//! copies: they span no surface, no graph of them gets anywhere, and the distance to the nearest says
//! nothing about how far apart the points of a face are. So the copies are left out of the fit, and
//! get their labels from what was found without them. So are points whose coordinates are not finite,
//! without any label.
//!
//! Scan lines are thinned alike (`lines`), and so is a cloud of which only so many places are to be fitted.
//!
//! The places are in an order of their own, so that a fit does not hang on how a file lists them.

mod lines;
mod order;
mod unfolded;

pub use unfolded::Unfolded;

use super::holders::Holders;
use super::quantile::quantile;
use super::{Search, stages};
use crate::cloud::neighbours::KdTree;
use crate::cloud::normals::Spread;
use crate::cloud::{Cloud, Point};
use crate::model::Segmentation;
use crate::surface::Surface;

/// Points whose surroundings are looked at.
const LOOKED_AT: usize = 120;
/// Nearest points that are looked at around each.
const AROUND: usize = 64;
/// Ratio of the distances to successive neighbours that parts the copies of a point from the others.
/// Of evenly spread points the widest is about 1.5, and twice that at random.
const STEP: f64 = 8.0;
/// Points beyond the copies that tell how the surface runs.
const BEYOND: usize = 8;
/// Largest cosine between the normal and the way to a copy: above it the copy is on the other side of
/// a foil.
const OFF: f64 = 0.8;

/// The points of a cloud that a fit is made of, in an order that is theirs: however the cloud lists
/// its points, and wherever it stands, a fit finds the same.
#[derive(Debug, Clone)]
pub struct Places<'a> {
    all: &'a Cloud,
    kept: Kept,
    thinned: bool,
}

/// Some points of a cloud.
#[derive(Debug, Clone)]
struct Kept {
    cloud: Cloud,
    /// The position among them that stands for each point of the whole cloud, `u32::MAX` for none.
    place: Vec<u32>,
}

impl<'a> Places<'a> {
    /// Leaves out the points that repeat others, puts the rest in order, keeps at most so many of them, spread
    /// over the whole cloud, and makes their tree. O(n log n).
    pub fn of(all: &'a Cloud, most: usize) -> (Self, KdTree) {
        let mut kept = distinct(all.points());
        let mut tree = KdTree::new(kept.cloud.points());
        for reach in [reach_of_copies, lines::reach_along_lines] {
            let points = kept.cloud.points();
            if let Some(radius) = reach(points, &tree) {
                let apart = apart(points, &tree, radius);
                kept = kept.then(apart);
                tree = KdTree::new(kept.cloud.points());
            }
        }
        let thinned = kept.cloud.len() > most;
        if thinned {
            kept = kept.thinned(most);
            tree = KdTree::new(kept.cloud.points());
        }
        (Self { all, kept, thinned }, tree)
    }

    /// Whether there are more places than were to be kept.
    pub fn are_thinned(&self) -> bool {
        self.thinned
    }

    /// The points that the fit is made of.
    pub fn cloud(&self) -> &Cloud {
        &self.kept.cloud
    }

    /// The position in [`cloud`](Self::cloud) of the point that stands for each point of the whole
    /// cloud, `u32::MAX` for none.
    pub fn standing_for(&self) -> &[u32] {
        &self.kept.place
    }

    /// Turns what was found in [`cloud`](Self::cloud) into what that says about the whole cloud, largest
    /// first. A point that was left out is on those surfaces of the point that stands for it which pass
    /// through itself too; where none does, on those of the nearest neighbour that has such. Where a cloud is thinned,
    /// edges run between the points that are kept: there a point is also on a neighbour's surface which passes through
    /// itself, but not through what stands for it.
    pub fn unfold(&self, search: &Search<'_>, found: Segmentation) -> Segmentation {
        let kept = &self.kept;
        let mut primitives = found.primitives;
        let mut holders = Holders::with_room(kept.cloud.len(), 0);
        for (number, primitive) in (0u32..).zip(&mut primitives) {
            holders.add(number, &primitive.points);
            primitive.points.clear();
        }
        let mut through = Vec::new();
        for (index, (point, &place)) in (0u32..).zip(self.all.points().iter().zip(&kept.place)) {
            if place == u32::MAX {
                continue;
            }
            let stands_for_itself = search.point(place) == point;
            let near = search.graph.of(place).iter().copied();
            let passes = |number: u32, point: &Point| {
                let is_near = |it: Surface| it.distance(point) <= search.scale.tolerance;
                primitives[number as usize].surface.is_some_and(is_near)
            };
            through.clear();
            let mut first = None;
            for at in std::iter::once(place).chain(near) {
                for number in holders.of(at) {
                    let goes_on = |from: u32| passes(number, search.point(from));
                    let is_new = !through.contains(&number) && !first.is_some_and(goes_on);
                    if is_new && (stands_for_itself || passes(number, point)) {
                        through.push(number);
                    }
                }
                if stands_for_itself || (!through.is_empty() && !self.thinned) {
                    break;
                }
                if first.is_none() && !through.is_empty() {
                    first = Some(at);
                }
            }
            for &number in &through {
                primitives[number as usize].points.push(index);
            }
        }
        stages::ranked(primitives)
    }
}

impl Kept {
    /// So many of them, at equal steps along their order, which runs through the cloud without leaps: where there are
    /// more, more are kept. The nearest of these stands for each of the others.
    fn thinned(self, most: usize) -> Self {
        let points = self.cloud.points();
        let count = points.len() as u64;
        let steps = (0..most as u64).map(|step| (step * count / most.max(1) as u64) as usize);
        let some: Vec<Point> = steps.map(|at| points[at]).collect();
        let tree = KdTree::new(&some);
        let mut found = Vec::with_capacity(1);
        let nearest = points.iter().map(|point| {
            tree.nearest(point, 1, f64::INFINITY, |_| true, &mut found);
            found.first().map_or(u32::MAX, |nearest| nearest.index)
        });
        let next = Self {
            place: nearest.collect(),
            cloud: Cloud::new(some),
        };
        self.then(next)
    }

    /// Those kept of these.
    fn then(self, next: Self) -> Self {
        let on = |&place: &u32| next.place.get(place as usize).copied();
        let places = self.place.iter();
        Self {
            place: places.map(|it| on(it).unwrap_or(u32::MAX)).collect(),
            cloud: next.cloud,
        }
    }
}

/// The points that are finite, each place once, in [`order`]. O(n log n).
fn distinct(points: &[Point]) -> Kept {
    let point = |index: &u32| &points[*index as usize];
    let mut listed: Vec<u32> = (0u32..).take(points.len()).collect();
    listed.retain(|index| point(index).iter().all(|x| x.is_finite()));
    listed.sort_unstable_by(|a, b| order::by_coordinates(point(a), point(b)));
    let are_equal = |a: &u32, b: &u32| order::by_coordinates(point(a), point(b)).is_eq();
    let copies: Vec<&[u32]> = listed.chunk_by(are_equal).collect();
    // The negative zero is no other place than zero.
    let once: Vec<Point> = copies
        .iter()
        .map(|it| point(&it[0]).map(|x| x + 0.0))
        .collect();
    let order = order::along_curve(&once);
    let mut place = vec![u32::MAX; points.len()];
    for (position, &at) in (0u32..).zip(&order) {
        for &index in copies[at as usize] {
            place[index as usize] = position;
        }
    }
    Kept {
        cloud: Cloud::new(order.iter().map(|&at| once[at as usize]).collect()),
        place,
    }
}

/// The distance that parts the copies of a point from the others, where most points have copies.
fn reach_of_copies(points: &[Point], tree: &KdTree) -> Option<f64> {
    let stride = points.len().div_ceil(LOOKED_AT).max(1);
    let mut found = Vec::new();
    let looked_at = points.iter().step_by(stride);
    let count = looked_at.len();
    let mut reaches: Vec<f64> = looked_at
        .filter_map(|point| {
            // The nearest of all is the point itself.
            tree.nearest(point, AROUND + 1, f64::INFINITY, |_| true, &mut found);
            let near: Vec<u32> = found.iter().skip(1).map(|it| it.index).collect();
            let distance = |index: u32| (points[index as usize] - point).norm();
            let step = |pair: &[u32]| distance(pair[1]) / distance(pair[0]);
            let steps = near.windows(2).map(step).enumerate();
            let (last, widest) = steps.max_by(|a, b| a.1.total_cmp(&b.1))?;
            let beyond = near[last + 1..].iter().take(BEYOND);
            let beyond = beyond.map(|&index| &points[index as usize]);
            let spread = Spread::of(beyond.chain(std::iter::once(point)))?;
            let way = points[near[last] as usize] - point;
            let is_copy = way.dot(&spread.normal()).abs() <= OFF * way.norm();
            let [inner, outer] = [near[last], near[last + 1]].map(distance);
            (widest >= STEP && is_copy).then(|| (inner * outer).sqrt())
        })
        .collect();
    (2 * reaches.len() > count).then(|| quantile(&mut reaches, 0.5))
}

/// Points no two of which are nearer each other than a radius; each of the others is stood for by one
/// of them within it. Of copies beside each other those on the same side are kept. O(n log n).
fn apart(points: &[Point], tree: &KdTree, radius: f64) -> Kept {
    let mut stand_in = vec![u32::MAX; points.len()];
    let mut found = Vec::with_capacity(2);
    for index in order::swept(points) {
        let is_kept = |other: u32| stand_in[other as usize] == other;
        tree.nearest(&points[index as usize], 1, radius, is_kept, &mut found);
        stand_in[index as usize] = found.first().map_or(index, |nearest| nearest.index);
    }
    let mut place = vec![u32::MAX; points.len()];
    let mut kept = Vec::new();
    for (index, &point) in (0u32..).zip(points) {
        if stand_in[index as usize] == index {
            place[index as usize] = kept.len() as u32;
            kept.push(point);
        }
    }
    Kept {
        cloud: Cloud::new(kept),
        place: stand_in
            .iter()
            .map(|&other| place[other as usize])
            .collect(),
    }
}

#[cfg(test)]
mod tests;
