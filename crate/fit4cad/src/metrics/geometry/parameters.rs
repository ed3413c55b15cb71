//! Parameter by parameter: axis, radius, half-angle.

use crate::cloud::Direction;
use crate::surface::Surface;

/// The angle between two lines along unit vectors, in degrees, 0 to 90.
pub(super) fn between(one: &Direction, other: &Direction) -> f64 {
    // With the cross product, as the arc cosine loses half the digits of small angles.
    let (sine, cosine) = (one.cross(other).norm(), one.dot(other).abs());
    libm::atan2(sine, cosine).to_degrees()
}

/// How far two surfaces of one type are apart; `None` for what the type has not, and all `None` of
/// different types.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Differences {
    /// Between the axes (of planes the normals), in degrees, 0 to 90; 0 of spheres.
    pub axis: Option<f64>,
    /// Of the radii, in the units of the cloud.
    pub radius: Option<f64>,
    /// Of the half-angles of cones, in degrees.
    pub half_angle: Option<f64>,
}

pub(super) fn compare(truth: &Surface, predicted: &Surface) -> Differences {
    let none = Differences::default();
    match (truth, predicted) {
        (Surface::Plane(one), Surface::Plane(other)) => Differences {
            axis: Some(between(&one.normal, &other.normal)),
            ..none
        },
        (Surface::Cylinder(one), Surface::Cylinder(other)) => Differences {
            axis: Some(between(&one.axis, &other.axis)),
            radius: Some((one.radius - other.radius).abs()),
            ..none
        },
        (Surface::Cone(one), Surface::Cone(other)) => Differences {
            axis: Some(between(&one.axis, &other.axis)),
            half_angle: Some((one.half_angle - other.half_angle).abs().to_degrees()),
            ..none
        },
        (Surface::Sphere(one), Surface::Sphere(other)) => Differences {
            axis: Some(0.0),
            radius: Some((one.radius - other.radius).abs()),
            ..none
        },
        (Surface::Torus(one), Surface::Torus(other)) => {
            let major = (one.major_radius - other.major_radius).abs();
            let minor = (one.minor_radius - other.minor_radius).abs();
            Differences {
                axis: Some(between(&one.axis, &other.axis)),
                radius: Some(0.5 * (major + minor)),
                ..none
            }
        }
        _ => none,
    }
}
