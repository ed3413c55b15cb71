//! Swept surfaces that are of one of the five families, and on which side of them their normals are.

use fit4cad::cloud::Vector;

use super::curve::Curve;
use super::shape::{Ring, Shape};
use crate::placement::Frame;

/// A surface, and whether its normal is against the one that the file means: the same sphere may be
/// described by a circle turned about its axis that runs up, or down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sided {
    /// The surface.
    pub shape: Shape,
    /// Whether its normal is turned over.
    pub turned: bool,
}

impl From<Shape> for Sided {
    fn from(shape: Shape) -> Self {
        Self {
            shape,
            turned: false,
        }
    }
}

/// What a swept surface turns out to be, its normal compared where the curve has its parameter zero: a
/// whole circle about a place of the axis covers its sphere twice, and the half about zero is meant.
fn sided(found: Shape, swept: Shape) -> Sided {
    if found == swept {
        return swept.into();
    }
    let normal = |shape: &Shape, at: [f64; 2]| {
        let (_, u, v) = shape.at(at);
        u.cross(&v)
    };
    // A line may meet the axis at its zero, and the surface has no normal there.
    let probes = [0.01, 0.73].map(|t| match swept {
        Shape::Extruded(..) => [t, 0.0],
        _ => [0.0, t],
    });
    let turned = probes.into_iter().find_map(|probe| {
        let at = found.invert(&swept.at(probe).0)?;
        let dot = normal(&found, at).dot(&normal(&swept, probe));
        (dot != 0.0).then_some(dot < 0.0)
    });
    Sided {
        shape: found,
        turned: turned.unwrap_or(false),
    }
}

/// The surface that a line or circle sweeps along a vector, one of the five families where it is.
pub(crate) fn extruded(curve: Curve, direction: Vector) -> Sided {
    let found = family_extruded(curve.clone(), direction);
    sided(found, Shape::Extruded(curve, direction))
}

/// The surface that a line or circle sweeps about an axis, one of the five families where it is.
pub(crate) fn turned(curve: Curve, frame: Frame) -> Sided {
    let found = family_turned(curve.clone(), frame);
    sided(found, Shape::Revolved(curve, frame))
}

fn family_extruded(curve: Curve, direction: Vector) -> Shape {
    let unit = direction.normalize();
    match &curve {
        Curve::Line(origin, along) => {
            let normal = along.cross(&direction);
            if normal.norm() > 1e-9 * along.norm() * direction.norm()
                && let Some(frame) = Frame::new(*origin, normal, Some(*along))
            {
                return Shape::Plane(frame);
            }
        }
        Curve::Ellipse(frame, a, b) if a == b && frame.z.cross(&unit).norm() < 1e-9 => {
            return Shape::Cylinder(*frame, *a);
        }
        _ => {}
    }
    Shape::Extruded(curve, direction)
}

fn family_turned(curve: Curve, frame: Frame) -> Shape {
    // Of the lengths at hand: places a billionth of them apart are one.
    const ONE: f64 = 1e-9;
    match &curve {
        Curve::Line(origin, along) => {
            let unit = along.normalize();
            let [x, y, z] = frame.enter(origin);
            let radius = libm::hypot(x, y);
            let rise = unit.dot(&frame.z);
            if rise.abs() < ONE {
                let origin = frame.leave([0.0, 0.0, z]);
                return Shape::Plane(Frame { origin, ..frame });
            }
            if rise.abs() > 1.0 - ONE * ONE && radius > 0.0 {
                return Shape::Cylinder(frame, radius);
            }
            // Where the line meets the axis: its distance from it changes as its height does.
            let outward = unit - frame.z * rise;
            let offset = frame.vector([x, y, 0.0]);
            let away = -offset.dot(&outward) / outward.norm_squared();
            let miss = (offset + outward * away).norm();
            if miss <= ONE * (radius + away.abs()).max(f64::MIN_POSITIVE) {
                let apex = frame.leave([0.0, 0.0, z + rise * away]);
                let angle = libm::atan2(outward.norm(), rise.abs());
                // The nappe is chosen by the face, which knows where its edges are.
                return Shape::Cone(
                    Frame {
                        origin: apex,
                        ..frame
                    },
                    angle,
                );
            }
        }
        Curve::Ellipse(circle, a, b) if a == b => {
            let [x, y, z] = frame.enter(&circle.origin);
            let major = libm::hypot(x, y);
            let size = major + a;
            if major <= ONE * size {
                // Any circle about a place of the axis through which its plane goes along it.
                if circle.z.dot(&frame.z).abs() < ONE {
                    let origin = frame.leave([0.0, 0.0, z]);
                    return Shape::Sphere(Frame { origin, ..frame }, *a);
                }
            } else {
                let outward = frame.vector([x, y, 0.0]) / major;
                let in_plane =
                    circle.z.dot(&frame.z).abs() < ONE && circle.z.dot(&outward).abs() < ONE;
                if in_plane {
                    // Of a circle that cuts the axis, the part about its zero.
                    let here = frame.enter(&curve.at(0.0).0);
                    let across = libm::hypot(here[0], here[1]);
                    let off = |major: f64| (libm::hypot(across - major, here[2] - z) - a).abs();
                    let origin = frame.leave([0.0, 0.0, z]);
                    return Shape::Torus(Ring {
                        frame: Frame { origin, ..frame },
                        major,
                        minor: *a,
                        inner: *a > major && off(-major) < off(major),
                    });
                }
            }
        }
        _ => {}
    }
    Shape::Revolved(curve, frame)
}
