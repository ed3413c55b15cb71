//! Surfaces with their parameters.

use fit4cad::cloud::{Point, Vector};
use fit4cad::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::axis::Axis;
use super::curve::Curve;
use super::spline::SplineSurface;
use super::swept;
use crate::placement::{Frame, Motion};

/// A surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// Parameters are the coordinates in the frame.
    Plane(Frame),
    /// Of a radius about the third axis; angle and height.
    Cylinder(Frame, f64),
    /// Apex at the origin, opening along the third axis with a half-angle; angle and height.
    Cone(Frame, f64),
    /// Of a radius; longitude and latitude.
    Sphere(Frame, f64),
    /// Angle about the axis and angle about the tube.
    Torus(Ring),
    /// A B-spline.
    Spline(SplineSurface),
    /// A curve moved along a vector; its parameter, and the share of the vector.
    Extruded(Curve, Vector),
    /// A curve turned about the third axis; the angle, and its parameter.
    Revolved(Curve, Frame),
    /// At a distance from a surface along its normal; the parameters of that surface.
    Offset(Box<Self>, f64),
}

/// A torus about the third axis of its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ring {
    pub frame: Frame,
    /// Radius of the circle that the tube follows.
    pub major: f64,
    /// Radius of the tube.
    pub minor: f64,
    /// Of a torus that meets itself, whether this is the inner part, the lemon.
    pub inner: bool,
}

impl Ring {
    /// The angle about the tube at which a torus that meets itself does so.
    fn pole(&self) -> Option<f64> {
        let cos = -self.major / self.minor;
        (cos >= -1.0).then(|| libm::acos(cos))
    }

    fn invert(&self, place: &Point) -> [f64; 2] {
        let [x, y, z] = self.frame.enter(place);
        let radius = libm::hypot(x, y);
        let around = libm::atan2(y, x);
        // Seen in a half-plane through the axis, the tube and, from beyond the axis, its other side.
        let beyond = self.pole().is_some() && self.inner;
        let (across, turn) = if beyond { (-radius, PI) } else { (radius, 0.0) };
        [around + turn, libm::atan2(z, across - self.major)]
    }
}

impl Shape {
    /// Place and both derivatives.
    pub fn at(&self, [u, v]: [f64; 2]) -> (Point, Vector, Vector) {
        match self {
            Self::Plane(frame) => (frame.leave([u, v, 0.0]), frame.x, frame.y),
            Self::Cylinder(frame, radius) => {
                let (sin, cos) = libm::sincos(u);
                let tangent = frame.vector([-radius * sin, radius * cos, 0.0]);
                (
                    frame.leave([radius * cos, radius * sin, v]),
                    tangent,
                    frame.z,
                )
            }
            Self::Cone(frame, angle) => {
                let ((sin, cos), tan) = (libm::sincos(u), libm::tan(*angle));
                let tangent = frame.vector([-v * tan * sin, v * tan * cos, 0.0]);
                let along = frame.vector([tan * cos, tan * sin, 1.0]);
                (frame.origin + along * v, tangent, along)
            }
            Self::Sphere(frame, radius) => turned(frame, 0.0, *radius, [u, v]),
            Self::Torus(ring) => turned(&ring.frame, ring.major, ring.minor, [u, v]),
            Self::Spline(spline) => spline.at(u, v),
            Self::Extruded(curve, direction) => {
                let (point, tangent) = curve.at(u);
                (point + direction * v, tangent, *direction)
            }
            Self::Revolved(curve, frame) => swept::revolved(curve, frame, [u, v]),
            Self::Offset(basis, distance) => {
                let offset = |u, v| {
                    let (point, along_u, along_v) = basis.at([u, v]);
                    let normal = along_u.cross(&along_v).try_normalize(0.0);
                    point + normal.unwrap_or_default() * *distance
                };
                let [du, dv] = basis.steps();
                let along_u = (offset(u + du, v) - offset(u - du, v)) / (2.0 * du);
                let along_v = (offset(u, v + dv) - offset(u, v - dv)) / (2.0 * dv);
                (offset(u, v), along_u, along_v)
            }
        }
    }

    /// Steps of both parameters that are small, to see how the surface changes.
    fn steps(&self) -> [f64; 2] {
        let length = |[low, high]: [f64; 2]| 1e-5 * (high - low);
        match self {
            Self::Spline(spline) => [length(spline.u.range()), length(spline.v.range())],
            Self::Extruded(curve, _) => [curve.range().map_or(1e-5, length), 1e-5],
            Self::Revolved(curve, _) => [1e-5, curve.range().map_or(1e-5, length)],
            Self::Offset(basis, _) => basis.steps(),
            _ => [1e-5; 2],
        }
    }

    /// Where both parameters meet a new piece of the surface, ascending.
    pub fn breaks(&self) -> [Vec<f64>; 2] {
        match self {
            Self::Spline(spline) => [spline.u.breaks(), spline.v.breaks()],
            Self::Extruded(curve, _) => [curve.breaks(), Vec::new()],
            Self::Revolved(curve, _) => [Vec::new(), curve.breaks()],
            Self::Offset(basis, _) => basis.breaks(),
            _ => [Vec::new(), Vec::new()],
        }
    }

    /// The ranges of both parameters.
    pub fn axes(&self) -> [Axis; 2] {
        let around = Axis::around(-PI, TAU);
        match self {
            Self::Plane(_) => [Axis::ENDLESS; 2],
            Self::Cylinder(..) => [around, Axis::ENDLESS],
            Self::Cone(..) => {
                let poles = [true, false];
                let along = Axis::from(0.0, f64::INFINITY);
                [around, Axis { poles, ..along }]
            }
            Self::Sphere(..) => {
                let poles = [true; 2];
                let along = Axis::from(-FRAC_PI_2, FRAC_PI_2);
                [around, Axis { poles, ..along }]
            }
            Self::Torus(ring) => match ring.pole() {
                None => [around, around],
                Some(pole) => {
                    let (low, high) = if ring.inner {
                        (pole, TAU - pole)
                    } else {
                        (-pole, pole)
                    };
                    let poles = [true; 2];
                    let along = Axis::from(low, high);
                    [around, Axis { poles, ..along }]
                }
            },
            Self::Spline(spline) => {
                let ([u0, u1], [v0, v1]) = (spline.u.range(), spline.v.range());
                let ends = |along_u: bool| {
                    swept::ends(
                        |end: bool, share: f64| {
                            let at = |[low, high]: [f64; 2], share: f64| low + (high - low) * share;
                            let side = f64::from(u8::from(end));
                            let (u, v) = if along_u {
                                (side, share)
                            } else {
                                (share, side)
                            };
                            spline.at(at([u0, u1], u), at([v0, v1], v)).0
                        },
                        swept::size(spline),
                    )
                };
                [ends(true).axis([u0, u1]), ends(false).axis([v0, v1])]
            }
            Self::Extruded(curve, _) => [swept::along(curve), Axis::ENDLESS],
            Self::Revolved(curve, frame) => [around, swept::profile(curve, frame)],
            Self::Offset(basis, _) => basis.axes(),
        }
    }

    /// The parameters of a place on or near the surface, where they follow from a formula.
    pub fn invert(&self, place: &Point) -> Option<[f64; 2]> {
        match self {
            Self::Plane(frame) => {
                let [x, y, _] = frame.enter(place);
                Some([x, y])
            }
            Self::Cylinder(frame, _) => {
                let [x, y, z] = frame.enter(place);
                Some([libm::atan2(y, x), z])
            }
            Self::Cone(frame, angle) => {
                let [x, y, z] = frame.enter(place);
                // The foot on the line of the cone: height alone would leave a place beside it there.
                let (sin, cos) = libm::sincos(*angle);
                let along = z * cos + libm::hypot(x, y) * sin;
                Some([libm::atan2(y, x), along.max(0.0) * cos])
            }
            Self::Sphere(frame, _) => {
                let [x, y, z] = frame.enter(place);
                Some([libm::atan2(y, x), libm::atan2(z, libm::hypot(x, y))])
            }
            Self::Torus(ring) => {
                let [u, v] = ring.invert(place);
                let v = if ring.inner && v < 0.0 { v + TAU } else { v };
                Some([u, v])
            }
            _ => None,
        }
    }

    /// Of the five families, the area below a second parameter per unit of the first: the integral
    /// of the density from `axes()[1]`'s middle. `None` for all others.
    pub fn cumulative(&self, v: f64) -> Option<f64> {
        Some(match self {
            Self::Plane(_) => v,
            Self::Cylinder(_, radius) => radius * v,
            Self::Cone(_, angle) => {
                let (sin, cos) = libm::sincos(*angle);
                0.5 * v * v * sin / (cos * cos)
            }
            Self::Sphere(_, radius) => radius * radius * libm::sin(v),
            Self::Torus(ring) => {
                let signed = ring.minor * (ring.major * v + ring.minor * libm::sin(v));
                // Beyond the axis the distance from it, and with it the formula, changes sign.
                if ring.inner { -signed } else { signed }
            }
            _ => return None,
        })
    }

    /// The surface of one of the five families, in its place.
    pub fn surface(&self, motion: &Motion) -> Option<Surface> {
        let point = |frame: &Frame| motion.point(&frame.origin);
        let axis = |frame: &Frame| motion.vector(&frame.z);
        let scale = motion.scale();
        Some(match self {
            Self::Plane(frame) => {
                // The normal of a mirrored plane is not the mirrored normal's sign, but its line.
                Surface::Plane(Plane::new(point(frame), axis(frame)))
            }
            Self::Cylinder(frame, radius) => {
                Surface::Cylinder(Cylinder::new(point(frame), axis(frame), radius * scale))
            }
            Self::Cone(frame, angle) => Surface::Cone(Cone::new(point(frame), axis(frame), *angle)),
            Self::Sphere(frame, radius) => {
                Surface::Sphere(Sphere::new(point(frame), radius * scale))
            }
            Self::Torus(ring) => Surface::Torus(Torus::new(
                point(&ring.frame),
                axis(&ring.frame),
                ring.major * scale,
                ring.minor * scale,
            )),
            _ => return None,
        })
    }
}

/// A circle of radius `minor`, at `major` from the axis, turned about it.
fn turned(frame: &Frame, major: f64, minor: f64, [u, v]: [f64; 2]) -> (Point, Vector, Vector) {
    let ((sin_u, cos_u), (sin_v, cos_v)) = (libm::sincos(u), libm::sincos(v));
    let radius = major + minor * cos_v;
    let point = frame.leave([radius * cos_u, radius * sin_u, minor * sin_v]);
    let along_u = frame.vector([-radius * sin_u, radius * cos_u, 0.0]);
    let (across, up) = (-minor * sin_v, minor * cos_v);
    let along_v = frame.vector([across * cos_u, across * sin_u, up]);
    (point, along_u, along_v)
}
