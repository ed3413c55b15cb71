//! NVDNet's precision, recall and F1 of surfaces (Liu, Chen, Pan, Cohen-Or, Zhang and Huang 2024).

use std::cell::OnceCell;
use std::collections::BTreeMap;

use super::assignment::Table;
use crate::cloud::neighbours::KdTree;
use crate::cloud::{Bounds, Cloud, Point};
use crate::model::Segmentation;

/// The distances within which a pair is a hit, in sides of the unit cube.
pub const THRESHOLDS: [f64; 5] = [0.005, 0.01, 0.02, 0.05, 0.1];

/// Points up to which looking at every point of the other face costs less than building trees of both,
/// which takes some fifty looks a point.
const FEW: usize = 32;

/// Mean over the thresholds of the shares of hits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detection {
    /// Hits among the predicted primitives, 0 to 1.
    pub precision: f64,
    /// Hits among the true primitives, 0 to 1.
    pub recall: f64,
    /// Mean of the harmonic means, one a threshold.
    pub f1: f64,
}

/// **Definition.** The distance of two primitives is the mean distance of the points of each to the
/// nearest point of the other, both ways, halved. True and predicted primitives are matched one to
/// one so that the sum of distances is smallest; a pair is a hit at t where its distance is below t.
/// Precision, recall and F1 are means over t = 0.005, 0.01, 0.02, 0.05 and 0.1.
///
/// **Source.** `yilinliu77/NVDNet`, `src/evaluate/evaluate.cpp`: the block "Surfaces" and `pr_compute`
/// (without its additions of 10⁻⁶, so that the truth itself scores 1, and without rounding distances
/// to 10⁻⁴ before they are matched, which leaves ties to the solver).
///
/// **Labels.** Sets; primitives without points do not exist.
///
/// **Trap.** It needs a unit: here the longest side of the cloud's bounding box is 1. A thin face found
/// as part of its neighbour is a hit at the wide thresholds.
///
/// `None` without true primitives, where the cloud has no extent, or beyond 4 million pairs of
/// primitives; 0 without predictions. Distances are exact, but only of the pairs that could be in the
/// cheapest matching.
pub fn score(cloud: &Cloud, truth: &Segmentation, predicted: &Segmentation) -> Option<Detection> {
    let [truth, predicted] = [truth, predicted].map(|segmentation| {
        let lists = segmentation.primitives.iter();
        let lists = lists.map(|primitive| Face::new(cloud, &primitive.points));
        let faces: Vec<Face> = lists.filter(|face| !face.indices.is_empty()).collect();
        faces
    });
    let unit = cloud.bounds().longest_side();
    if truth.is_empty() || !(unit > 0.0 && unit.is_finite()) {
        return None;
    }
    if predicted.is_empty() {
        return Some(Detection {
            precision: 0.0,
            recall: 0.0,
            f1: 0.0,
        });
    }
    let distances = matched_distances(&truth, &predicted, unit)?;
    let at = |threshold: f64| {
        let hits = distances.iter().filter(|&&distance| distance < threshold);
        let hits = hits.count() as f64;
        Detection {
            precision: hits / predicted.len() as f64,
            recall: hits / truth.len() as f64,
            f1: 2.0 * hits / (truth.len() + predicted.len()) as f64,
        }
    };
    let found = THRESHOLDS.map(at);
    let mean = |of: fn(&Detection) -> f64| found.iter().map(of).sum::<f64>() / 5.0;
    Some(Detection {
        precision: mean(|found| found.precision),
        recall: mean(|found| found.recall),
        f1: mean(|found| found.f1),
    })
}

/// What is known of the distance of a pair, in units.
#[derive(Clone, Copy)]
enum Known {
    /// It is at least the mean distance of the points of each to the box of the other.
    Bounded,
    /// It is this.
    Measured(f64),
}

/// The distances of the pairs of the cheapest matching, in units.
///
/// Every pair begins with the distance of its two boxes, which costs nearly nothing, and is looked at closer,
/// a step at a time, while the cheapest matching takes it. Once that takes measured pairs alone, every
/// other matching costs at least its lower bounds, and no less than this one.
fn matched_distances(truth: &[Face], predicted: &[Face], unit: f64) -> Option<Vec<f64>> {
    let mut table = Table::new(truth.len(), predicted.len())?;
    for (row, face) in truth.iter().enumerate() {
        for (column, other) in predicted.iter().enumerate() {
            table.set(row, column, -face.bounds.gap_to(&other.bounds) / unit);
        }
    }
    let mut known: BTreeMap<(usize, usize), Known> = BTreeMap::new();
    loop {
        let chosen = table.largest();
        let pairs = chosen.iter().enumerate();
        let pairs: Vec<(usize, usize)> = pairs.filter_map(|(row, &at)| Some((row, at?))).collect();
        let mut is_new = false;
        for &(row, column) in &pairs {
            let (Some(face), Some(other)) = (truth.get(row), predicted.get(column)) else {
                continue;
            };
            let (least, news) = match known.get(&(row, column)) {
                Some(Known::Measured(_)) => continue,
                Some(Known::Bounded) => {
                    let distance = face.distance(other) / unit;
                    (distance, Known::Measured(distance))
                }
                None => (face.at_least(other) / unit, Known::Bounded),
            };
            table.set(row, column, -least);
            known.insert((row, column), news);
            is_new = true;
        }
        if !is_new {
            let measured = |pair: &(usize, usize)| match known.get(pair) {
                Some(Known::Measured(distance)) => Some(*distance),
                Some(Known::Bounded) | None => None,
            };
            return Some(pairs.iter().filter_map(measured).collect());
        }
    }
}

/// The points of a primitive.
struct Face {
    /// Places in the cloud, ascending.
    indices: Vec<u32>,
    points: Vec<Point>,
    bounds: Bounds,
    /// Built when it is first asked for.
    tree: OnceCell<KdTree>,
}

impl Face {
    fn new(cloud: &Cloud, indices: &[u32]) -> Self {
        let known = indices.iter().filter_map(|&index| {
            let point = cloud.points().get(index as usize)?;
            Some((index, *point))
        });
        let (indices, points): (Vec<u32>, Vec<Point>) = known.unzip();
        Self {
            bounds: Bounds::of(&points),
            indices,
            points,
            tree: OnceCell::new(),
        }
    }

    /// A lower bound of the distance to another.
    fn at_least(&self, other: &Self) -> f64 {
        let one_way = |from: &Self, to: &Self| {
            let points = from.points.iter();
            let sum: f64 = points
                .map(|point| to.bounds.distance_squared_to(point).sqrt())
                .sum();
            sum / from.points.len() as f64
        };
        0.5 * (one_way(self, other) + one_way(other, self))
    }

    /// The distance to another.
    fn distance(&self, other: &Self) -> f64 {
        0.5 * (self.mean_to(other) + other.mean_to(self))
    }

    /// The tree of its points.
    fn tree(&self) -> &KdTree {
        self.tree.get_or_init(|| KdTree::new(&self.points))
    }

    /// Mean distance of its points to the nearest of another. Those that the other lists as well are
    /// at none.
    fn mean_to(&self, other: &Self) -> f64 {
        let mut shared = other.indices.iter().copied().peekable();
        let is_own = self.indices.iter().map(|index| {
            while shared.next_if(|other| other < index).is_some() {}
            shared.peek() != Some(index)
        });
        let is_own: Vec<bool> = is_own.collect();
        let count = is_own.iter().filter(|own| **own).count();
        let sum = if count <= FEW {
            let own = self.points.iter().zip(&is_own).filter(|(_, own)| **own);
            own.map(|(point, _)| other.nearest_of_all(point)).sum()
        } else {
            self.sum_to(other, &is_own)
        };
        sum / self.points.len() as f64
    }

    /// Distance of a point to the nearest, by looking at every one.
    fn nearest_of_all(&self, point: &Point) -> f64 {
        let squares = self.points.iter().map(|own| (own - point).norm_squared());
        squares.fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Sum of the distances of the points that are its own to the nearest of another. In the order of
    /// the tree, where a point follows one near it: how far the nearest of that one is bounds the search,
    /// of faces far apart to a few points beside it.
    fn sum_to(&self, other: &Self, is_own: &[bool]) -> f64 {
        let mut sum = 0.0;
        let mut before: Option<&Point> = None;
        for &place in self.tree().order() {
            let place = place as usize;
            let (Some(point), Some(true)) = (self.points.get(place), is_own.get(place)) else {
                continue;
            };
            let bound = before.map_or(f64::INFINITY, |near| nalgebra::distance(near, point));
            // A little more, so that rounding does not leave out what set the bound.
            let found = other.tree().closest(point, bound * (1.0 + 1e-6));
            // None is nearer than a point in the same place.
            let distance = found.map_or(bound, |near| near.distance_squared.sqrt());
            let nearest = found.and_then(|near| other.points.get(near.index as usize));
            before = nearest.or(before);
            sum += distance;
        }
        sum
    }
}
