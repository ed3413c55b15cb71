//! The plane.

use super::canonical_axis;
use crate::cloud::{Direction, Point, Vector};

/// The points x with n·x = offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Unit normal n, canonical sign.
    pub normal: Direction,
    /// Signed distance of the plane from the origin along the normal.
    pub offset: f64,
}

impl Plane {
    /// The plane through a point, across a vector of any length but zero.
    pub fn new(point: Point, normal: Vector) -> Self {
        let normal = canonical_axis(normal);
        Self {
            normal,
            offset: point.coords.dot(&normal),
        }
    }

    /// The point of the plane nearest the origin.
    pub fn centre(&self) -> Point {
        Point::from(self.normal.into_inner() * self.offset)
    }

    pub(super) fn signed_distance(&self, point: &Point) -> f64 {
        point.coords.dot(&self.normal) - self.offset
    }

    pub(super) fn normal(&self, _point: &Point) -> Direction {
        self.normal
    }
}
