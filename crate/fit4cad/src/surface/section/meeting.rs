//! What a whole surface and a plane meet in, in closed form.

use std::fmt;

use super::CuttingPlane;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};

/// Directions whose sine or cosine is less than this are across or along each other.
const STRAIGHT: f64 = 1e-9;

/// The curve, or the curves, in which a whole surface and a plane meet. Lengths are those of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meeting {
    /// They do not meet, touch in a point or along a curve, or are the same plane.
    Nothing,
    /// One straight line.
    Line,
    /// Two straight lines.
    Lines,
    /// A circle of that radius.
    Circle(f64),
    /// Two circles of these radii, the larger one first.
    Circles(f64, f64),
    /// An ellipse of these half-axes, the larger one first.
    Ellipse(f64, f64),
    /// A parabola.
    Parabola,
    /// A branch of a hyperbola on either nappe.
    Hyperbola,
    /// A curve of the fourth degree (a toric section).
    Quartic,
}

impl Meeting {
    /// What a plane and a whole surface meet in. O(1).
    pub fn of(surface: &Surface, plane: &CuttingPlane) -> Self {
        match surface {
            Surface::Plane(other) => of_plane(other, plane),
            Surface::Cylinder(cylinder) => of_cylinder(cylinder, plane),
            Surface::Cone(cone) => of_cone(cone, plane),
            Surface::Sphere(sphere) => of_sphere(sphere, plane),
            Surface::Torus(torus) => of_torus(torus, plane),
        }
    }
}

impl fmt::Display for Meeting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let length = |value: f64| Short(value);
        match *self {
            Self::Nothing => f.write_str("nothing"),
            Self::Line => f.write_str("line"),
            Self::Lines => f.write_str("two lines"),
            Self::Circle(radius) => write!(f, "circle of radius {}", length(radius)),
            Self::Circles(large, small) if large == small => {
                write!(f, "two circles of radius {}", length(large))
            }
            Self::Circles(large, small) => {
                write!(
                    f,
                    "circles of radii {} and {}",
                    length(large),
                    length(small)
                )
            }
            Self::Ellipse(large, small) => {
                write!(
                    f,
                    "ellipse of half-axes {} and {}",
                    length(large),
                    length(small)
                )
            }
            Self::Parabola => f.write_str("parabola"),
            Self::Hyperbola => f.write_str("hyperbola"),
            Self::Quartic => f.write_str("curve of degree four"),
        }
    }
}

/// A number to five digits, without the zeros at its end.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scientific = format!("{:.4e}", self.0);
        match scientific.parse::<f64>() {
            Ok(rounded) if (1e-4..1e6).contains(&rounded.abs()) || rounded == 0.0 => {
                write!(f, "{rounded}")
            }
            _ => f.write_str(&scientific),
        }
    }
}

fn of_plane(other: &Plane, plane: &CuttingPlane) -> Meeting {
    if other.normal.cross(&plane.normal()).norm() < STRAIGHT {
        Meeting::Nothing
    } else {
        Meeting::Line
    }
}

fn of_cylinder(cylinder: &Cylinder, plane: &CuttingPlane) -> Meeting {
    let slant = cylinder.axis.dot(&plane.normal()).abs();
    let radius = cylinder.radius;
    if slant < STRAIGHT {
        return if plane.height(&cylinder.centre).abs() < radius {
            Meeting::Lines
        } else {
            Meeting::Nothing
        };
    }
    if cylinder.axis.cross(&plane.normal()).norm() < STRAIGHT {
        return Meeting::Circle(radius);
    }
    Meeting::Ellipse(radius / slant, radius)
}

/// By the angles that the axis makes with the plane and with the generators: the eccentricity is
/// the ratio of their cosines.
fn of_cone(cone: &Cone, plane: &CuttingPlane) -> Meeting {
    let along = cone.axis.dot(&plane.normal()).abs().min(1.0);
    let across = cone.axis.cross(&plane.normal()).norm().min(1.0);
    let height = plane.height(&cone.apex).abs();
    let (sin, cos) = libm::sincos(cone.half_angle);
    if height == 0.0 {
        return if along < sin {
            Meeting::Lines
        } else {
            Meeting::Nothing
        };
    }
    if across < STRAIGHT {
        return Meeting::Circle(height * sin / cos);
    }
    if (along - sin).abs() < STRAIGHT {
        return Meeting::Parabola;
    }
    if along < sin {
        return Meeting::Hyperbola;
    }
    // The generators that are steepest and flattest against the plane end on the larger axis.
    let turn = libm::atan2(across, along);
    let (near, far) = (
        libm::tan(turn - cone.half_angle),
        libm::tan(turn + cone.half_angle),
    );
    let large = height * (far - near).abs() / 2.0;
    let eccentricity = across / cos;
    let small = large * (1.0 - eccentricity * eccentricity).max(0.0).sqrt();
    Meeting::Ellipse(large, small)
}

fn of_sphere(sphere: &Sphere, plane: &CuttingPlane) -> Meeting {
    let height = plane.height(&sphere.centre).abs();
    if height < sphere.radius {
        Meeting::Circle(leg(sphere.radius, height))
    } else {
        Meeting::Nothing
    }
}

fn of_torus(torus: &Torus, plane: &CuttingPlane) -> Meeting {
    let (major, minor) = (torus.major_radius, torus.minor_radius);
    let height = plane.height(&torus.centre).abs();
    let along = torus.axis.dot(&plane.normal()).abs();
    if torus.axis.cross(&plane.normal()).norm() < STRAIGHT {
        if height >= minor {
            return Meeting::Nothing;
        }
        let half = leg(minor, height);
        return if half < major {
            Meeting::Circles(major + half, major - half)
        } else {
            Meeting::Circle(major + half)
        };
    }
    // How far the whole torus reaches along the plane's normal.
    let reach = minor + major * leg(1.0, along.min(1.0));
    if height >= reach {
        Meeting::Nothing
    } else if along < STRAIGHT && height < STRAIGHT * major {
        Meeting::Circles(minor, minor)
    } else {
        Meeting::Quartic
    }
}

/// The other leg of a right triangle.
fn leg(hypotenuse: f64, leg: f64) -> f64 {
    ((hypotenuse - leg) * (hypotenuse + leg)).max(0.0).sqrt()
}
