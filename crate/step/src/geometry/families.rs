//! Swept surfaces that are of one of the five families.

use fit4cad::cloud::Vector;

use super::curve::Curve;
use super::shape::{Ring, Shape};
use crate::placement::Frame;

/// The surface that a line or circle sweeps along a vector, where it is one of the five families.
pub(crate) fn extruded(curve: Curve, direction: Vector) -> Shape {
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

/// The surface that a line or circle sweeps about an axis, where it is one of the five families.
pub(crate) fn turned(curve: Curve, frame: Frame) -> Shape {
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
                    let origin = frame.leave([0.0, 0.0, z]);
                    return Shape::Torus(Ring {
                        frame: Frame { origin, ..frame },
                        major,
                        minor: *a,
                        inner: false,
                    });
                }
            }
        }
        _ => {}
    }
    Shape::Revolved(curve, frame)
}
