//! The circular cylinder.

use super::{axial, canonical_axis, nearest_to_origin};
use crate::cloud::{Direction, Point, Vector};

/// The points at one distance from a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Point of the axis nearest the origin.
    pub centre: Point,
    /// Unit direction of the axis, canonical sign.
    pub axis: Direction,
    /// Distance of the surface from the axis, not negative.
    pub radius: f64,
}

impl Cylinder {
    /// The cylinder about the line through a point along a vector of any length but zero.
    pub fn new(point: Point, axis: Vector, radius: f64) -> Self {
        let axis = canonical_axis(axis);
        Self {
            centre: nearest_to_origin(point, &axis),
            axis,
            radius: radius.abs(),
        }
    }

    pub(super) fn signed_distance(&self, point: &Point) -> f64 {
        let offset = point - self.centre;
        let height = offset.dot(&self.axis);
        (offset - self.axis.into_inner() * height).norm() - self.radius
    }

    pub(super) fn normal(&self, point: &Point) -> Direction {
        axial(point, &self.centre, &self.axis).2
    }
}
