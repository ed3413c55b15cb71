//! The five families of surfaces: canonical form, exact distance, foot point, normal.
//!
//! Each family has one canonical form (unit axis, centre, radii, half-angle) and one file. An
//! axis has no direction of its own, so its sign is chosen: the first component that is not
//! negligible is positive. A point along an axis is chosen as the one nearest the origin.

mod cone;
mod conversion;
mod cylinder;
mod implicit;
pub mod implicitization;
mod motion;
mod parametric;
pub mod patch;
mod plane;
pub mod polynomial;
pub mod section;
mod sphere;
mod torus;

use std::fmt;

pub use cone::Cone;
pub use conversion::{Conversion, ConversionError, Defect, Form};
pub use cylinder::Cylinder;
pub use parametric::{parametric_point, sample_parametric};
pub use plane::Plane;
pub use polynomial::Polynomial;
pub use sphere::Sphere;
pub use torus::Torus;

use crate::cloud::{Direction, LARGEST, Point, SMALLEST, Vector};

/// The family a surface belongs to, simplest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SurfaceType {
    /// A plane.
    Plane,
    /// A circular cylinder, without end.
    Cylinder,
    /// A circular cone, both nappes.
    Cone,
    /// A sphere.
    Sphere,
    /// A torus.
    Torus,
}

impl SurfaceType {
    /// All five, simplest first.
    pub const ALL: [Self; 5] = [
        Self::Plane,
        Self::Cylinder,
        Self::Cone,
        Self::Sphere,
        Self::Torus,
    ];

    /// The name used in the files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plane => "Plane",
            Self::Cylinder => "Cylinder",
            Self::Cone => "Cone",
            Self::Sphere => "Sphere",
            Self::Torus => "Torus",
        }
    }

    /// Place of its colour among those of segments: of the first six the five that are told apart
    /// best beside each other.
    pub const fn colour(self) -> u8 {
        match self {
            Self::Plane => 0,
            Self::Cylinder => 1,
            Self::Cone => 2,
            Self::Sphere => 3,
            Self::Torus => 5,
        }
    }

    /// The type of that name, in any case.
    pub fn from_name(name: &[u8]) -> Option<Self> {
        let is_named = |kind: &Self| kind.name().as_bytes().eq_ignore_ascii_case(name);
        Self::ALL.into_iter().find(is_named)
    }

    /// How many numbers its parametric vector has (paper, appendix "Parametric representations").
    pub const fn parametric_len(self) -> usize {
        match self {
            Self::Plane => 9,
            Self::Cylinder | Self::Sphere => 12,
            Self::Cone | Self::Torus => 18,
        }
    }

    /// How many numbers its implicit vector has (paper, appendix "Implicit representations").
    pub const fn implicit_len(self) -> usize {
        match self {
            Self::Plane => 4,
            Self::Cylinder | Self::Cone | Self::Sphere => 10,
            Self::Torus => 35,
        }
    }
}

/// What stands in the place of a type's name for a primitive of none of the five; nothing reads it but
/// as unknown.
pub const OTHER: &str = "Other";

impl fmt::Display for SurfaceType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A surface of one of the five families: the paper's 𝒮. It is always the whole surface (an
/// endless cylinder, a double cone), never the patch that the points cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// A plane.
    Plane(Plane),
    /// A circular cylinder.
    Cylinder(Cylinder),
    /// A circular cone.
    Cone(Cone),
    /// A sphere.
    Sphere(Sphere),
    /// A torus.
    Torus(Torus),
}

/// Calls the same method of whichever family it is.
macro_rules! each_family {
    ($surface:expr, $shape:ident => $call:expr) => {
        match $surface {
            Surface::Plane($shape) => $call,
            Surface::Cylinder($shape) => $call,
            Surface::Cone($shape) => $call,
            Surface::Sphere($shape) => $call,
            Surface::Torus($shape) => $call,
        }
    };
}

impl Surface {
    /// The family.
    pub fn kind(&self) -> SurfaceType {
        match self {
            Self::Plane(_) => SurfaceType::Plane,
            Self::Cylinder(_) => SurfaceType::Cylinder,
            Self::Cone(_) => SurfaceType::Cone,
            Self::Sphere(_) => SurfaceType::Sphere,
            Self::Torus(_) => SurfaceType::Torus,
        }
    }

    /// Euclidean distance d(x, 𝒮) of a point to the nearest point of the surface. Closed form, O(1).
    pub fn distance(&self, point: &Point) -> f64 {
        self.signed_distance(point).abs()
    }

    /// Distance, negative on the inner side (towards the axis or centre; for a plane, against its
    /// normal).
    pub fn signed_distance(&self, point: &Point) -> f64 {
        each_family!(self, shape => shape.signed_distance(point))
    }

    /// The nearest point of the surface; one of them where there are several (on an axis).
    pub fn foot(&self, point: &Point) -> Point {
        point - self.normal(point).into_inner() * self.signed_distance(point)
    }

    /// Whether every parameter is a number that can be computed with: places and radii up to
    /// [`LARGEST`], and no radius, but for the major one of a torus, below [`SMALLEST`]. Whatever is
    /// derived from such a surface and points up to there is finite.
    pub fn is_in_range(&self) -> bool {
        // Not `amax`, for which what is no number is the smallest there is.
        let lies = |point: &Point, axis: &Direction| {
            point.iter().all(|value| value.abs() <= LARGEST)
                && axis.iter().all(|value| value.is_finite())
        };
        let opens = |radius: f64| (SMALLEST..=LARGEST).contains(&radius);
        let z = Vector::z_axis();
        match self {
            Self::Plane(shape) => {
                lies(&Point::origin(), &shape.normal) && shape.offset.abs() <= LARGEST
            }
            Self::Cylinder(shape) => lies(&shape.centre, &shape.axis) && opens(shape.radius),
            Self::Cone(shape) => lies(&shape.apex, &shape.axis) && shape.half_angle.is_finite(),
            Self::Sphere(shape) => lies(&shape.centre, &z) && opens(shape.radius),
            Self::Torus(shape) => {
                let round = (0.0..=LARGEST).contains(&shape.major_radius);
                lies(&shape.centre, &shape.axis) && round && opens(shape.minor_radius)
            }
        }
    }

    /// Unit normal at the foot of the point, pointing to the outer side.
    pub fn normal(&self, point: &Point) -> Direction {
        each_family!(self, shape => shape.normal(point))
    }
}

/// The axis with its canonical sign: the first component that is not negligible is positive.
fn canonical_axis(axis: Vector) -> Direction {
    const NEGLIGIBLE: f64 = 1e-9;
    let axis = direction(&axis).unwrap_or_else(Vector::z_axis);
    let axis = match axis.iter().find(|component| component.abs() > NEGLIGIBLE) {
        Some(&component) if component < 0.0 => -axis,
        _ => axis,
    };
    // A sum turns `-0` into `0`, so that equal axes also print alike.
    Direction::new_unchecked(axis.map(|component| component + 0.0))
}

/// The direction of a vector, whatever its length; `None` of a zero vector.
fn direction(vector: &Vector) -> Option<Direction> {
    Direction::try_new(vector / magnitude(vector), 0.0)
}

/// A divisor that brings a vector to a length whose square neither overflows nor vanishes: 1 where
/// it has one, so that nothing is rounded twice.
fn magnitude(vector: &Vector) -> f64 {
    let largest = vector.amax();
    if (1e-100..1e100).contains(&largest) {
        1.0
    } else {
        largest
    }
}

/// The point of the line nearest the origin.
fn nearest_to_origin(point: Point, axis: &Direction) -> Point {
    point - axis.into_inner() * point.coords.dot(axis)
}

/// Any unit vector across the given one.
pub(crate) fn across(axis: &Direction) -> Direction {
    let helper = if axis.x.abs() < 0.6 {
        Vector::x()
    } else {
        Vector::y()
    };
    Direction::new_normalize(axis.cross(&helper))
}

/// Position of a point relative to an axis: height along it, distance from it and the outward
/// unit direction across it (any, for a point on the axis).
fn axial(point: &Point, origin: &Point, axis: &Direction) -> (f64, f64, Direction) {
    let offset = point - origin;
    let height = offset.dot(axis);
    let radial = offset - axis.into_inner() * height;
    let radius = radial.norm();
    let outward = Direction::try_new(radial, f64::MIN_POSITIVE).unwrap_or_else(|| across(axis));
    (height, radius, outward)
}
