//! Points, their extent, and what is near what.

mod ball;
mod bounds;
mod cells;
pub mod curve;
pub mod neighbours;
pub mod normals;
mod numbering;

pub use ball::Ball;
pub use bounds::Bounds;
pub use cells::Cells;
pub use numbering::{Numbering, PointNumber};

use nalgebra::{Quaternion, UnitQuaternion};

/// A point in the units of the file it came from.
pub type Point = nalgebra::Point3<f64>;
/// A direction or displacement in the units of the file it came from.
pub type Vector = nalgebra::Vector3<f64>;
/// A vector of length one.
pub type Direction = nalgebra::Unit<Vector>;

/// Largest magnitude of a coordinate, radius or offset that is computed with. No formula takes more
/// than its ninth power (the norm of a torus's implicit coefficients, which are fourth powers, their
/// squares and a sum), so that whatever is derived from numbers up to here is finite. The diameter
/// of the universe is 10²⁷ m.
pub const LARGEST: f64 = 1e30;
/// Smallest radius that is computed with: as far below 1 as [`LARGEST`] is above.
pub const SMALLEST: f64 = 1e-30;

/// The turn about an axis by an angle in radians, to the same digits everywhere: nalgebra's own has
/// its sine from the platform.
pub fn turn(axis: &Direction, angle: f64) -> UnitQuaternion<f64> {
    let (sin, cos) = libm::sincos(0.5 * angle);
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, axis.into_inner() * sin))
}

/// The points of one model, in the order of its file; a point's index is its identity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cloud {
    points: Vec<Point>,
    /// Kept, because measures ask for it once for every primitive.
    bounds: Bounds,
    numbering: Numbering,
}

impl Cloud {
    /// A cloud of the given points, kept in their order and numbered in it. O(n).
    ///
    /// ```
    /// use fit4cad::cloud::{Cloud, Point};
    /// let cloud = Cloud::new(vec![Point::new(0.0, 0.0, 0.0), Point::new(3.0, 4.0, 0.0)]);
    /// assert_eq!((cloud.len(), cloud.bounds().diagonal()), (2, 5.0));
    /// ```
    pub fn new(points: Vec<Point>) -> Self {
        let numbering = Numbering::of(points.len());
        Self::numbered(points, numbering)
    }

    /// A cloud of the rows of a file that could be read, and the numbers of all. O(n).
    pub(crate) fn numbered(points: Vec<Point>, numbering: Numbering) -> Self {
        let bounds = Bounds::of(&points);
        Self {
            points,
            bounds,
            numbering,
        }
    }

    /// What numbers files give the points.
    pub fn numbering(&self) -> &Numbering {
        &self.numbering
    }

    /// The points; [`Cloud::numbering`] tells what number each has in files.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The points alone.
    pub(crate) fn into_points(self) -> Vec<Point> {
        self.points
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
