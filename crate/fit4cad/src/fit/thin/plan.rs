//! Plans: what is seen along a direction.

use super::profile::{Curve, Place};
use crate::cloud::{Direction, Point, Vector};
use crate::surface::{Cylinder, Plane, Surface, across};

/// The plane across a direction.
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    /// The direction.
    pub direction: Direction,
    origin: Point,
    axes: [Vector; 2],
}

impl Plan {
    /// The plane through a point.
    pub fn new(origin: Point, direction: Direction) -> Self {
        let first = across(&direction).into_inner();
        Self {
            direction,
            origin,
            axes: [first, direction.cross(&first)],
        }
    }

    /// Where a point is seen.
    pub fn place(&self, point: &Point) -> Place {
        let offset = point - self.origin;
        self.axes.map(|axis| offset.dot(&axis))
    }

    /// How far along the direction a point is.
    pub fn height(&self, point: &Point) -> f64 {
        (point - self.origin).dot(&self.direction)
    }

    /// The point of the plane at a place.
    pub fn point(&self, place: Place) -> Point {
        self.origin + self.axes[0] * place[0] + self.axes[1] * place[1]
    }

    /// The surface that a curve of the plane sweeps out along the direction.
    pub fn surface(&self, curve: &Curve) -> Surface {
        let direction = self.direction.into_inner();
        match *curve {
            Curve::Line(a, b) => {
                let (a, b) = (self.point(a), self.point(b));
                Surface::Plane(Plane::new(a, (b - a).cross(&direction)))
            }
            Curve::Circle(centre, radius) => {
                Surface::Cylinder(Cylinder::new(self.point(centre), direction, radius))
            }
        }
    }
}
