//! The points of primitives, and how far the points of one are from those of another.

use std::cell::OnceCell;

use crate::cloud::curve::{Curve, CurveTree};
use crate::cloud::{Bounds, Cloud, Point};
use crate::model::Segmentation;

/// Points up to which looking at every point of the other face costs less than building a tree of it, which takes
/// some ten looks a point.
const FEW: usize = 10;

/// Takes the points of primitives from a cloud, along one curve.
pub(super) struct Faces<'a> {
    cloud: &'a Cloud,
    curve: Curve,
}

impl<'a> Faces<'a> {
    pub(super) fn of(cloud: &'a Cloud) -> Self {
        Self {
            cloud,
            curve: Curve::through(cloud.points()),
        }
    }

    /// The primitives of a segmentation that have points.
    pub(super) fn among(&self, segmentation: &Segmentation) -> Vec<Face> {
        let lists = segmentation.primitives.iter();
        let lists = lists.map(|primitive| self.face(&primitive.points));
        lists.filter(|face| !face.places.is_empty()).collect()
    }

    fn face(&self, indices: &[u32]) -> Face {
        let places = indices.iter().filter_map(|&index| self.curve.place(index));
        let mut places: Vec<u32> = places.collect();
        places.sort_unstable();
        let known = places.iter().filter_map(|&place| {
            let (cell, index) = self.curve.at(place)?;
            Some((cell, *self.cloud.points().get(index as usize)?))
        });
        let (cells, points): (Vec<u32>, Vec<Point>) = known.unzip();
        Face {
            bounds: Bounds::of(&points),
            places,
            cells,
            points,
            tree: OnceCell::new(),
        }
    }
}

/// The points of a primitive, along the curve.
pub(super) struct Face {
    /// Places on the curve, ascending.
    places: Vec<u32>,
    /// The cell of each.
    cells: Vec<u32>,
    /// The point at each.
    points: Vec<Point>,
    pub(super) bounds: Bounds,
    /// Built when it is first asked for.
    tree: OnceCell<CurveTree>,
}

impl Face {
    /// A lower bound of the distance to another.
    pub(super) fn at_least(&self, other: &Self) -> f64 {
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
    pub(super) fn distance(&self, other: &Self) -> f64 {
        0.5 * (self.mean_to(other) + other.mean_to(self))
    }

    /// Mean distance of its points to the nearest of another. Those that the other has as well are at none.
    fn mean_to(&self, other: &Self) -> f64 {
        let is_few = self.own(other).nth(FEW).is_none();
        let sum = if is_few {
            let own = self.own(other);
            own.map(|point| other.nearest_of_all(point)).sum()
        } else {
            self.sum_to(other)
        };
        sum / self.points.len() as f64
    }

    /// The points that the other has not.
    fn own<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a Point> {
        let mut others = other.places.iter().peekable();
        let rows = self.places.iter().zip(&self.points);
        rows.filter_map(move |(place, point)| {
            while others.next_if(|other| *other < place).is_some() {}
            (others.peek() != Some(&place)).then_some(point)
        })
    }

    /// Distance of a point to the nearest, by looking at every one.
    fn nearest_of_all(&self, point: &Point) -> f64 {
        let squares = self.points.iter().map(|own| (own - point).norm_squared());
        squares.fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Sum of the distances of the points that are its own to the nearest of another. Along the curve a point
    /// follows one near it: how far the nearest of that one is bounds the search, of faces far apart to a few
    /// points beside it.
    fn sum_to(&self, other: &Self) -> f64 {
        let tree = other.tree();
        let mut sum = 0.0;
        let mut nearest: Option<&Point> = None;
        for point in self.own(other) {
            let bound = nearest.map_or(f64::INFINITY, |near| (near - point).norm_squared());
            // None is nearer than what set the bound.
            let found = tree.closest(point, bound);
            sum += found.map_or(bound, |(_, square)| square).sqrt();
            nearest = found.map(|(near, _)| near).or(nearest);
        }
        sum
    }

    /// The tree of its points.
    fn tree(&self) -> &CurveTree {
        let make = || CurveTree::new(self.points.clone(), &self.cells);
        self.tree.get_or_init(make)
    }
}
