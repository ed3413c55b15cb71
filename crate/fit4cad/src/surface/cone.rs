//! The circular cone.

use super::{axial, canonical_axis};
use crate::cloud::{Direction, Point, Vector};

/// The points whose direction from the apex makes one angle with a line: both nappes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Where the nappes meet.
    pub apex: Point,
    /// Unit direction of the axis, canonical sign.
    pub axis: Direction,
    /// Angle between axis and surface in radians, between 0 and π/2.
    pub half_angle: f64,
}

impl Cone {
    /// The cone about the line through the apex along a vector of any length but zero.
    pub fn new(apex: Point, axis: Vector, half_angle: f64) -> Self {
        Self {
            apex,
            axis: canonical_axis(axis),
            half_angle: half_angle.abs(),
        }
    }

    /// In the half-plane of (distance from the axis, |height|) a nappe is a ray from the apex, and
    /// the foot of a point with both coordinates positive never falls behind the apex.
    pub(super) fn signed_distance(&self, point: &Point) -> f64 {
        let offset = point - self.apex;
        let height = offset.dot(&self.axis);
        let radius = (offset - self.axis.into_inner() * height).norm();
        let (sin, cos) = libm::sincos(self.half_angle);
        radius * cos - height.abs() * sin
    }

    pub(super) fn normal(&self, point: &Point) -> Direction {
        let (height, _, outward) = axial(point, &self.apex, &self.axis);
        let (sin, cos) = libm::sincos(self.half_angle);
        let along = self.axis.into_inner() * if height < 0.0 { -sin } else { sin };
        Direction::new_normalize(outward.into_inner() * cos - along)
    }
}
