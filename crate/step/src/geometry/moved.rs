//! Copies of curves and surfaces elsewhere, as replicas are.

use super::curve::Curve;
use super::shape::{Ring, Shape};
use super::spline::{SplineCurve, SplineSurface};
use crate::placement::{Frame, Motion};

impl Frame {
    /// The frame moved; one that is mirrored keeps its first two axes.
    fn moved(&self, by: &Motion) -> Self {
        let x = by.vector(&self.x) / by.scale();
        let y = by.vector(&self.y) / by.scale();
        Self {
            origin: by.point(&self.origin),
            x,
            y,
            z: x.cross(&y),
        }
    }

    /// As [`Frame::moved`]; one that is mirrored keeps its first and third axes.
    fn moved_about(&self, by: &Motion) -> Self {
        let x = by.vector(&self.x) / by.scale();
        let z = by.vector(&self.z) / by.scale();
        Self {
            origin: by.point(&self.origin),
            x,
            y: z.cross(&x),
            z,
        }
    }
}

impl Curve {
    /// The curve moved.
    pub fn moved(self, by: &Motion) -> Self {
        let scale = by.scale();
        match self {
            Self::Line(origin, along) => Self::Line(by.point(&origin), by.vector(&along)),
            Self::Ellipse(frame, a, b) => Self::Ellipse(frame.moved(by), a * scale, b * scale),
            Self::Parabola(frame, focal) => Self::Parabola(frame.moved(by), focal * scale),
            Self::Hyperbola(frame, a, b) => Self::Hyperbola(frame.moved(by), a * scale, b * scale),
            Self::Spline(SplineCurve { knots, points }) => {
                let points = points.iter().map(|each| by.weighted(*each)).collect();
                Self::Spline(SplineCurve { knots, points })
            }
            Self::Polyline(points) => {
                Self::Polyline(points.iter().map(|point| by.point(point)).collect())
            }
            Self::Joined(pieces) => {
                let moved = pieces
                    .into_iter()
                    .map(|(curve, range)| (curve.moved(by), range));
                Self::Joined(moved.collect())
            }
            Self::Offset(basis, distance, reference) => {
                let moved = Box::new(basis.moved(by));
                Self::Offset(moved, distance * scale, by.vector(&reference) / scale)
            }
        }
    }
}

impl Shape {
    /// The surface moved.
    pub fn moved(self, by: &Motion) -> Self {
        let scale = by.scale();
        match self {
            Self::Plane(frame) => Self::Plane(frame.moved(by)),
            Self::Cylinder(frame, radius) => Self::Cylinder(frame.moved_about(by), radius * scale),
            Self::Cone(frame, angle) => Self::Cone(frame.moved_about(by), angle),
            Self::Sphere(frame, radius) => Self::Sphere(frame.moved_about(by), radius * scale),
            Self::Torus(ring) => Self::Torus(Ring {
                frame: ring.frame.moved_about(by),
                major: ring.major * scale,
                minor: ring.minor * scale,
                inner: ring.inner,
            }),
            Self::Spline(SplineSurface { u, v, points }) => {
                let points = points.iter().map(|each| by.weighted(*each)).collect();
                Self::Spline(SplineSurface { u, v, points })
            }
            Self::Extruded(curve, along) => Self::Extruded(curve.moved(by), by.vector(&along)),
            Self::Revolved(curve, frame) => Self::Revolved(curve.moved(by), frame.moved_about(by)),
            Self::Offset(basis, distance) => {
                Self::Offset(Box::new(basis.moved(by)), distance * scale)
            }
        }
    }
}
