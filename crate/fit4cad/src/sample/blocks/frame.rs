//! Where a solid stands.

use crate::cloud::{Point, Vector};

/// A right-handed frame, given by its origin and two directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The origin.
    pub origin: [f64; 3],
    /// Direction of the z axis, of any length but zero.
    pub z: [f64; 3],
    /// A direction not along z: the x axis is the one across z nearest to it.
    pub x: [f64; 3],
}

impl Frame {
    /// The frame of the world.
    pub const WORLD: Self = Self {
        origin: [0.0; 3],
        z: [0.0, 0.0, 1.0],
        x: [1.0, 0.0, 0.0],
    };

    /// The unit axes, if the directions span a frame.
    pub(in crate::sample) fn placement(&self) -> Option<Placement> {
        let z = Vector::from(self.z).try_normalize(0.0)?;
        let x = Vector::from(self.x).try_normalize(0.0)?;
        let across = x - z * x.dot(&z);
        let x = across.try_normalize(1e-6)?;
        let axes = [x, z.cross(&x), z];
        let origin = Point::from(self.origin);
        let mut numbers = axes.iter().flatten().chain(&origin.coords);
        let finite = numbers.all(|x| x.is_finite());
        finite.then_some(Placement { origin, axes })
    }
}

/// A frame with unit axes: maps between a solid's own coordinates and the world's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::sample) struct Placement {
    pub origin: Point,
    pub axes: [Vector; 3],
}

impl Placement {
    pub fn to_world(self, local: &Point) -> Point {
        self.origin + self.vector_to_world(&local.coords)
    }

    pub fn vector_to_world(self, local: &Vector) -> Vector {
        let [x, y, z] = self.axes;
        x * local.x + y * local.y + z * local.z
    }

    pub fn to_local(self, world: &Point) -> Point {
        let offset = world - self.origin;
        Point::from(self.axes.map(|axis| axis.dot(&offset)))
    }
}
