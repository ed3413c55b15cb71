//! The torus.

use super::{axial, canonical_axis};
use crate::cloud::{Direction, Point, Vector};

/// The points at distance `minor_radius` from a circle of radius `major_radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    /// Centre of the circle.
    pub centre: Point,
    /// Unit direction across the circle's plane, canonical sign.
    pub axis: Direction,
    /// Radius of the circle, not negative.
    pub major_radius: f64,
    /// Radius of the tube, not negative. Where it exceeds the major radius the torus meets itself.
    pub minor_radius: f64,
}

impl Torus {
    /// The torus about the line through a centre along a vector of any length but zero.
    pub fn new(centre: Point, axis: Vector, major_radius: f64, minor_radius: f64) -> Self {
        Self {
            centre,
            axis: canonical_axis(axis),
            major_radius: major_radius.abs(),
            minor_radius: minor_radius.abs(),
        }
    }

    /// A half-plane through the axis cuts the torus in a circle and, where it meets itself, in
    /// part of the opposite one; the nearer of the two counts.
    pub(super) fn signed_distance(&self, point: &Point) -> f64 {
        let (height, radius, _) = axial(point, &self.centre, &self.axis);
        self.in_half_plane(radius, height).0
    }

    pub(super) fn normal(&self, point: &Point) -> Direction {
        let (height, radius, outward) = axial(point, &self.centre, &self.axis);
        let (_, across) = self.in_half_plane(radius, height);
        let radial = outward.into_inner() * (radius - across);
        let offset = radial + self.axis.into_inner() * height;
        // On the tube's centre line every direction across it is as good.
        Direction::try_new(offset, f64::MIN_POSITIVE).unwrap_or(outward)
    }

    /// Signed distance and the radial position of the tube centre it is measured from.
    fn in_half_plane(&self, radius: f64, height: f64) -> (f64, f64) {
        let near = libm::hypot(radius - self.major_radius, height) - self.minor_radius;
        let far = libm::hypot(radius + self.major_radius, height) - self.minor_radius;
        if far.abs() < near.abs() {
            (far, -self.major_radius)
        } else {
            (near, self.major_radius)
        }
    }
}
