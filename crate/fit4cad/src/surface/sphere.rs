//! The sphere.

use crate::cloud::{Direction, Point, Vector};

/// The points at one distance from a centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// The centre.
    pub centre: Point,
    /// Distance of the surface from the centre, not negative.
    pub radius: f64,
}

impl Sphere {
    /// The sphere about a centre.
    pub fn new(centre: Point, radius: f64) -> Self {
        Self {
            centre,
            radius: radius.abs(),
        }
    }

    pub(super) fn signed_distance(&self, point: &Point) -> f64 {
        (point - self.centre).norm() - self.radius
    }

    pub(super) fn normal(&self, point: &Point) -> Direction {
        Direction::try_new(point - self.centre, f64::MIN_POSITIVE).unwrap_or_else(Vector::z_axis)
    }
}
