//! Points, their extent, and what is near what.

mod ball;
mod bounds;
pub mod neighbours;
pub mod normals;

pub use ball::Ball;
pub use bounds::Bounds;

/// A point in the units of the file it came from.
pub type Point = nalgebra::Point3<f64>;
/// A direction or displacement in the units of the file it came from.
pub type Vector = nalgebra::Vector3<f64>;
/// A vector of length one.
pub type Direction = nalgebra::Unit<Vector>;

/// The points of one model, in the order of its file; a point's index is its identity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cloud {
    points: Vec<Point>,
    /// Kept, because measures ask for it once for every primitive.
    bounds: Bounds,
}

impl Cloud {
    /// A cloud of the given points, kept in their order. O(n).
    pub fn new(points: Vec<Point>) -> Self {
        let bounds = Bounds::of(&points);
        Self { points, bounds }
    }

    /// The points, index 0 being the file's point 1.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no point at all.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The axis-aligned box of all points; empty for an empty cloud. O(1).
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The length l over which distances of a group of points are given (paper, section
    /// "Approximation accuracy"): the diagonal of the group's own box, of the cloud's box where
    /// the group has none (one point, or equal points).
    pub fn length_of(&self, group: &Bounds) -> f64 {
        let own = group.diagonal();
        if own > 0.0 {
            own
        } else {
            self.bounds.diagonal()
        }
    }
}
