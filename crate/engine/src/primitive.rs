//! Primitives and their surfaces as plain objects.

use fit4cad::cloud::{Cloud, Direction, Point};
use fit4cad::metrics::accuracy::fit_accuracy;
use fit4cad::{model, surface};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// The family a surface belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
pub enum SurfaceType {
    /// A plane.
    Plane,
    /// A circular cylinder.
    Cylinder,
    /// A circular cone.
    Cone,
    /// A sphere.
    Sphere,
    /// A torus.
    Torus,
}

impl From<surface::SurfaceType> for SurfaceType {
    fn from(kind: surface::SurfaceType) -> Self {
        match kind {
            surface::SurfaceType::Plane => Self::Plane,
            surface::SurfaceType::Cylinder => Self::Cylinder,
            surface::SurfaceType::Cone => Self::Cone,
            surface::SurfaceType::Sphere => Self::Sphere,
            surface::SurfaceType::Torus => Self::Torus,
        }
    }
}

impl From<SurfaceType> for surface::SurfaceType {
    fn from(kind: SurfaceType) -> Self {
        match kind {
            SurfaceType::Plane => Self::Plane,
            SurfaceType::Cylinder => Self::Cylinder,
            SurfaceType::Cone => Self::Cone,
            SurfaceType::Sphere => Self::Sphere,
            SurfaceType::Torus => Self::Torus,
        }
    }
}

/// A surface in canonical form: unit axis, centre, radii, half-angle in radians, in the units and
/// coordinates of the files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(tag = "type", rename_all_fields = "camelCase")]
#[allow(missing_docs, reason = "each field is said in `fit4cad::surface`")]
pub enum SurfaceInfo {
    /// The points x with normal·x = offset.
    Plane { normal: [f64; 3], offset: f64 },
    /// The points at one distance from a line.
    Cylinder {
        centre: [f64; 3],
        axis: [f64; 3],
        radius: f64,
    },
    /// The points whose direction from the apex makes one angle with a line.
    Cone {
        apex: [f64; 3],
        axis: [f64; 3],
        half_angle: f64,
    },
    /// The points at one distance from a centre.
    Sphere { centre: [f64; 3], radius: f64 },
    /// The points at one distance from a circle.
    Torus {
        centre: [f64; 3],
        axis: [f64; 3],
        major_radius: f64,
        minor_radius: f64,
    },
}

impl From<&surface::Surface> for SurfaceInfo {
    fn from(surface: &surface::Surface) -> Self {
        let point = |point: Point| [point.x, point.y, point.z];
        let direction = |direction: Direction| [direction.x, direction.y, direction.z];
        match *surface {
            surface::Surface::Plane(plane) => Self::Plane {
                normal: direction(plane.normal),
                offset: plane.offset,
            },
            surface::Surface::Cylinder(cylinder) => Self::Cylinder {
                centre: point(cylinder.centre),
                axis: direction(cylinder.axis),
                radius: cylinder.radius,
            },
            surface::Surface::Cone(cone) => Self::Cone {
                apex: point(cone.apex),
                axis: direction(cone.axis),
                half_angle: cone.half_angle,
            },
            surface::Surface::Sphere(sphere) => Self::Sphere {
                centre: point(sphere.centre),
                radius: sphere.radius,
            },
            surface::Surface::Torus(torus) => Self::Torus {
                centre: point(torus.centre),
                axis: direction(torus.axis),
                major_radius: torus.major_radius,
                minor_radius: torus.minor_radius,
            },
        }
    }
}

/// One primitive without its points.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct PrimitiveInfo {
    /// The number the file gives it.
    pub number: u32,
    /// Its type, where it is one of the five.
    #[serde(rename = "type", skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub size: u32,
    /// Its surface, where a file gives a usable one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub surface: Option<SurfaceInfo>,
    /// Mean fitting error of its points to its surface, where both are there.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub mfe: Option<f64>,
}

impl PrimitiveInfo {
    pub(crate) fn new(cloud: &Cloud, primitive: &model::Primitive) -> Self {
        let surface = primitive.surface.as_ref();
        let accuracy = surface.and_then(|it| fit_accuracy(cloud, &primitive.points, it));
        Self {
            number: primitive.number,
            kind: primitive.kind.map(SurfaceType::from),
            size: primitive.points.len() as u32,
            surface: surface.map(SurfaceInfo::from),
            mfe: accuracy.map(|accuracy| accuracy.mfe),
        }
    }
}
