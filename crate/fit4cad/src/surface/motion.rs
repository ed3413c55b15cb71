//! Surfaces moved and scaled.

use nalgebra::Isometry3;

use super::{Cone, Cylinder, Plane, Sphere, Surface, Torus};
use crate::cloud::{Direction, Point};

impl Surface {
    /// The surface after a rotation and translation of space.
    pub fn moved(&self, motion: &Isometry3<f64>) -> Self {
        let turned = |axis: &Direction| motion * axis.into_inner();
        match self {
            Self::Plane(plane) => {
                Self::Plane(Plane::new(motion * plane.centre(), turned(&plane.normal)))
            }
            Self::Cylinder(shape) => Self::Cylinder(Cylinder::new(
                motion * shape.centre,
                turned(&shape.axis),
                shape.radius,
            )),
            Self::Cone(shape) => Self::Cone(Cone::new(
                motion * shape.apex,
                turned(&shape.axis),
                shape.half_angle,
            )),
            Self::Sphere(shape) => Self::Sphere(Sphere::new(motion * shape.centre, shape.radius)),
            Self::Torus(shape) => Self::Torus(Torus::new(
                motion * shape.centre,
                turned(&shape.axis),
                shape.major_radius,
                shape.minor_radius,
            )),
        }
    }

    /// The surface after scaling space about the origin by a positive factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let at = |point: Point| point * factor;
        match *self {
            Self::Plane(plane) => Self::Plane(Plane {
                offset: plane.offset * factor,
                ..plane
            }),
            Self::Cylinder(shape) => Self::Cylinder(Cylinder {
                centre: at(shape.centre),
                radius: shape.radius * factor,
                ..shape
            }),
            Self::Cone(shape) => Self::Cone(Cone {
                apex: at(shape.apex),
                ..shape
            }),
            Self::Sphere(shape) => Self::Sphere(Sphere {
                centre: at(shape.centre),
                radius: shape.radius * factor,
            }),
            Self::Torus(shape) => Self::Torus(Torus {
                centre: at(shape.centre),
                major_radius: shape.major_radius * factor,
                minor_radius: shape.minor_radius * factor,
                ..shape
            }),
        }
    }
}
