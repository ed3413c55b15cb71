//! Where things are: frames of coordinates, and motions between them.

use fit4cad::cloud::{Point, Vector};
use nalgebra::Matrix3;

use crate::error::{Got, Trouble};
use crate::file::File;

/// An origin and three unit axes, right-handed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The origin.
    pub origin: Point,
    /// First axis.
    pub x: Vector,
    /// Second axis.
    pub y: Vector,
    /// Third axis: that of revolution, or the normal.
    pub z: Vector,
}

impl Frame {
    /// The frame of an axis and, roughly, a first direction: what is wanted of it is its part across
    /// the axis. Where it has none, or is omitted, the standard's choice stands in: x, or y where the
    /// axis is parallel to x. `None` for an axis without a direction.
    pub fn new(origin: Point, axis: Vector, reference: Option<Vector>) -> Option<Self> {
        let z = axis.try_normalize(1e-300)?;
        let across = |direction: Vector| {
            let direction = direction.try_normalize(1e-300)?;
            (direction - z * direction.dot(&z)).try_normalize(1e-7)
        };
        let x = reference
            .and_then(across)
            .or_else(|| across(Vector::x()))
            .or_else(|| across(Vector::y()))?;
        // Once more: the first pass leaves an error of as many digits as were cancelled.
        let x = (x - z * x.dot(&z)).normalize();
        let y = z.cross(&x);
        Some(Self { origin, x, y, z })
    }

    /// The coordinates of a place in this frame.
    pub fn enter(&self, point: &Point) -> [f64; 3] {
        let offset = point - self.origin;
        [
            offset.dot(&self.x),
            offset.dot(&self.y),
            offset.dot(&self.z),
        ]
    }

    /// The place with these coordinates in this frame.
    pub fn leave(&self, [x, y, z]: [f64; 3]) -> Point {
        self.origin + self.vector([x, y, z])
    }

    /// The vector with these components in this frame.
    pub fn vector(&self, [x, y, z]: [f64; 3]) -> Vector {
        self.x * x + self.y * y + self.z * z
    }

    /// The frame with its lengths multiplied.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            origin: self.origin * factor,
            ..*self
        }
    }

    /// The same axes turned over, so that the third points the other way.
    pub(crate) fn flipped(&self) -> Self {
        Self {
            y: -self.y,
            z: -self.z,
            ..*self
        }
    }

    /// Reads a placement, its lengths as they are in the file.
    pub(crate) fn read(file: &File, id: u64) -> Got<Self> {
        let fields = file.fields(id)?;
        let origin = point(file, fields.reference(1)?)?;
        let given = |place| match fields.optional(place)? {
            Some(id) => direction(file, id).map(Some),
            None => Ok(None),
        };
        if file.is(id, "AXIS2_PLACEMENT_2D") {
            let reference = given(2)?;
            return Self::new(origin, Vector::z(), reference)
                .ok_or_else(|| Trouble::new(id, "has no direction"));
        }
        let axis = given(2)?.unwrap_or_else(Vector::z);
        // An axis alone has no third attribute.
        let reference = given(3)?;
        Self::new(origin, axis, reference)
            .ok_or_else(|| Trouble::new(id, "has an axis without a direction"))
    }
}

/// A motion, with a change of size and perhaps a reflection: p ↦ linear · p + shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    linear: Matrix3<f64>,
    shift: Vector,
    scale: f64,
}

impl Motion {
    /// The motion that moves nothing.
    pub fn identity() -> Self {
        Self {
            linear: Matrix3::identity(),
            shift: Vector::zeros(),
            scale: 1.0,
        }
    }

    /// The motion that takes one frame to another.
    pub fn between(from: &Frame, to: &Frame) -> Self {
        let columns = |frame: &Frame| Matrix3::from_columns(&[frame.x, frame.y, frame.z]);
        let linear = columns(to) * columns(from).transpose();
        Self {
            linear,
            shift: to.origin.coords - linear * from.origin.coords,
            scale: 1.0,
        }
    }

    /// This motion after another.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            linear: self.linear * first.linear,
            shift: self.linear * first.shift + self.shift,
            scale: self.scale * first.scale,
        }
    }

    /// The motion back.
    pub fn inverse(&self) -> Self {
        let linear = self.linear.transpose() / (self.scale * self.scale);
        Self {
            linear,
            shift: -(linear * self.shift),
            scale: 1.0 / self.scale,
        }
    }

    /// Where a place goes.
    pub fn point(&self, point: &Point) -> Point {
        Point::from(self.linear * point.coords + self.shift)
    }

    /// What becomes of a vector.
    pub fn vector(&self, vector: &Vector) -> Vector {
        self.linear * vector
    }

    /// Where a control point goes that is written times its weight.
    pub(crate) fn weighted(&self, [x, y, z, weight]: [f64; 4]) -> [f64; 4] {
        let moved = self.linear * Vector::new(x, y, z) + self.shift * weight;
        [moved.x, moved.y, moved.z, weight]
    }

    /// By how much lengths grow.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Whether two motions are one, for places up to `reach` from the origin.
    pub(crate) fn is_like(&self, other: &Self, reach: f64) -> bool {
        (self.linear - other.linear).amax() < 1e-9
            && (self.shift - other.shift).amax() < 1e-9 * reach
    }

    /// Reads a `CARTESIAN_TRANSFORMATION_OPERATOR_3D`, its lengths multiplied by `unit`.
    pub(crate) fn read_operator(file: &File, id: u64, unit: f64) -> Got<Self> {
        let base = file.part(id, "CARTESIAN_TRANSFORMATION_OPERATOR", usize::MAX);
        let last = file.part(id, "CARTESIAN_TRANSFORMATION_OPERATOR_3D", usize::MAX);
        // Written as one, the five attributes come after the names: the last five there are.
        let (own, start, third) = match (base, last) {
            (Some(own), Some(last)) if own.len() > 0 => (own, 0, last.optional(0)?),
            _ => {
                let own = file.fields(id)?;
                let start = own.len().checked_sub(5);
                let start = start.ok_or_else(|| Trouble::new(id, "is no transformation"))?;
                let third = own.optional(start + 4)?;
                (own, start, third)
            }
        };
        let axis = |given: Option<u64>| given.map(|id| direction(file, id)).transpose();
        let (first, second) = (axis(own.optional(start)?)?, axis(own.optional(start + 1)?)?);
        let third = axis(third)?;
        let origin = point(file, own.reference(start + 2)?)?;
        let scale = own.number(start + 3).unwrap_or(1.0);
        if scale <= 0.0 {
            return Err(Trouble::new(
                id,
                "has a scale that is not greater than zero",
            ));
        }
        let z = third.or_else(|| Some(first?.cross(&second?)));
        let frame = Frame::new(origin * unit, z.unwrap_or_else(Vector::z), first)
            .ok_or_else(|| Trouble::new(id, "has an axis without a direction"))?;
        let mirrored = second.is_some_and(|second| second.dot(&frame.y) < 0.0);
        let y = if mirrored { -frame.y } else { frame.y };
        Ok(Self {
            linear: Matrix3::from_columns(&[frame.x, y, frame.z]) * scale,
            shift: frame.origin.coords,
            scale,
        })
    }
}

/// Reads a point, its lengths as they are in the file; what has two coordinates lies at height zero.
pub(crate) fn point(file: &File, id: u64) -> Got<Point> {
    if !file.is(id, "CARTESIAN_POINT") {
        return Err(Trouble::new(
            id,
            format!("is {}, not a point", file.name(id)),
        ));
    }
    let [x, y, z] = three(file, id)?;
    Ok(Point::new(x, y, z))
}

/// Reads a direction, of whatever length it is written.
pub(crate) fn direction(file: &File, id: u64) -> Got<Vector> {
    if !file.is(id, "DIRECTION") {
        return Err(Trouble::new(
            id,
            format!("is {}, not a direction", file.name(id)),
        ));
    }
    let [x, y, z] = three(file, id)?;
    Ok(Vector::new(x, y, z))
}

/// Reads a vector: a direction times its length.
pub(crate) fn vector(file: &File, id: u64) -> Got<Vector> {
    let fields = file.fields(id)?;
    let direction = direction(file, fields.reference(1)?)?;
    let unit = direction
        .try_normalize(1e-300)
        .ok_or_else(|| Trouble::new(id, "has no direction"))?;
    Ok(unit * fields.number(2)?)
}

fn three(file: &File, id: u64) -> Got<[f64; 3]> {
    let values = file.fields(id)?.numbers(1)?;
    match values[..] {
        [x, y, z] => Ok([x, y, z]),
        [x, y] => Ok([x, y, 0.0]),
        _ => Err(Trouble::new(id, "has neither two nor three coordinates")),
    }
}
