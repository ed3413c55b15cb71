//! Curves in space.

use fit4cad::cloud::{Point, Vector};
use std::f64::consts::TAU;

use super::nearest::nearest;
use super::spline::SplineCurve;
use crate::placement::Frame;

/// A curve with its parameter as the standard defines it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Curve {
    /// A straight line: a place and what one unit of the parameter adds.
    Line(Point, Vector),
    /// An ellipse, of two radii along the first two axes; a circle where they are one.
    Ellipse(Frame, f64, f64),
    /// A parabola of a focal length.
    Parabola(Frame, f64),
    /// A branch of a hyperbola, of two semi-axes.
    Hyperbola(Frame, f64, f64),
    /// A B-spline.
    Spline(SplineCurve),
    /// Straight from place to place, one unit of the parameter each.
    Polyline(Vec<Point>),
    /// Pieces of curves, one unit of the parameter each, from one of their own parameters to another.
    Joined(Vec<(Self, [f64; 2])>),
    /// At a distance from a curve, across it and a direction.
    Offset(Box<Self>, f64, Vector),
}

impl Curve {
    /// Place and derivative at a parameter.
    pub fn at(&self, t: f64) -> (Point, Vector) {
        match self {
            Self::Line(origin, direction) => (origin + direction * t, *direction),
            Self::Ellipse(frame, a, b) => {
                let (sin, cos) = libm::sincos(t);
                let tangent = frame.vector([-a * sin, b * cos, 0.0]);
                (frame.leave([a * cos, b * sin, 0.0]), tangent)
            }
            Self::Parabola(frame, focal) => {
                let point = frame.leave([focal * t * t, 2.0 * focal * t, 0.0]);
                (point, frame.vector([2.0 * focal * t, 2.0 * focal, 0.0]))
            }
            Self::Hyperbola(frame, a, b) => {
                let (cosh, sinh) = (libm::cosh(t), libm::sinh(t));
                let tangent = frame.vector([a * sinh, b * cosh, 0.0]);
                (frame.leave([a * cosh, b * sinh, 0.0]), tangent)
            }
            Self::Spline(spline) => spline.at(self.wrapped(t)),
            Self::Polyline(points) => {
                let (k, share) = piece(t, points.len().saturating_sub(1));
                let (from, to) = (points[k], points[(k + 1).min(points.len() - 1)]);
                (from + (to - from) * share, to - from)
            }
            Self::Joined(pieces) => {
                let (k, share) = piece(self.wrapped(t), pieces.len());
                let (curve, [from, to]) = &pieces[k];
                let (point, tangent) = curve.at(from + (to - from) * share);
                (point, tangent * (to - from))
            }
            Self::Offset(basis, distance, reference) => {
                let offset = |t: f64| {
                    let (point, tangent) = basis.at(t);
                    let across = reference.cross(&tangent);
                    point + across.try_normalize(0.0).unwrap_or_default() * *distance
                };
                let step = 1e-5 * self.range().map_or(1.0, |[from, to]| to - from);
                let tangent = (offset(t + step) - offset(t - step)) / (2.0 * step);
                (offset(t), tangent)
            }
        }
    }

    /// The range of the parameter, where the curve has ends.
    pub fn range(&self) -> Option<[f64; 2]> {
        match self {
            Self::Line(..) | Self::Parabola(..) | Self::Hyperbola(..) => None,
            Self::Ellipse(..) => Some([0.0, TAU]),
            Self::Spline(spline) => Some(spline.knots.range()),
            Self::Polyline(points) => Some([0.0, points.len().saturating_sub(1) as f64]),
            Self::Joined(pieces) => Some([0.0, pieces.len() as f64]),
            Self::Offset(basis, ..) => basis.range(),
        }
    }

    /// After how much of the parameter the curve is where it was.
    pub fn period(&self) -> Option<f64> {
        let [from, to] = self.range()?;
        match self {
            Self::Ellipse(..) => Some(TAU),
            Self::Offset(basis, ..) => basis.period(),
            _ => {
                let (start, end) = (self.at_end(from), self.at_end(to));
                (to > from && (start - end).norm() <= 1e-6 * self.length()).then_some(to - from)
            }
        }
    }

    /// The place at one of the ends, without wrapping.
    fn at_end(&self, t: f64) -> Point {
        match self {
            Self::Spline(spline) => spline.at(t).0,
            Self::Joined(pieces) => {
                let (k, share) = piece(t, pieces.len());
                let (curve, [from, to]) = &pieces[k];
                curve.at(from + (to - from) * share).0
            }
            _ => self.at(t).0,
        }
    }

    /// A length that says how large the curve is.
    pub fn length(&self) -> f64 {
        let Some([from, to]) = self.range() else {
            return f64::INFINITY;
        };
        let at = |k: u32| self.at_end(from + (to - from) * f64::from(k) / 16.0);
        (0..16).map(|k| (at(k + 1) - at(k)).norm()).sum()
    }

    /// The parameter within the range, for curves that close.
    fn wrapped(&self, t: f64) -> f64 {
        match self.range() {
            Some([from, to]) if t < from || t > to => {
                let around = t - (to - from) * ((t - from) / (to - from)).floor();
                if self.period().is_some() {
                    around
                } else {
                    t.clamp(from, to)
                }
            }
            _ => t,
        }
    }

    /// Where the curve may have a kink, or its description changes, within its range.
    pub fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Spline(spline) => spline.knots.breaks(),
            Self::Polyline(points) => (0..points.len()).map(|k| k as f64).collect(),
            Self::Joined(pieces) => (0..=pieces.len()).map(|k| k as f64).collect(),
            Self::Offset(basis, ..) => basis.breaks(),
            _ => Vec::new(),
        }
    }

    /// The parameter of the point nearest to a place: exact for lines and circles on whose axis the
    /// place is not.
    pub fn parameter(&self, place: &Point) -> f64 {
        match self {
            Self::Line(origin, direction) => {
                (place - origin).dot(direction) / direction.norm_squared()
            }
            Self::Ellipse(frame, a, b) => {
                let [x, y, _] = frame.enter(place);
                let start = libm::atan2(y * a, x * b);
                if a == b {
                    return start;
                }
                // The angle is that of a place on the ellipse; off it, the nearest is beside.
                nearest(|t| self.at(t), [start - 0.1, start + 0.1], 4, place)
            }
            Self::Parabola(frame, focal) => frame.enter(place)[1] / (2.0 * focal),
            Self::Hyperbola(frame, _, b) => libm::asinh(frame.enter(place)[1] / b),
            _ => {
                let range = self.range().unwrap_or([0.0, 1.0]);
                let pieces = self.breaks().len().max(2) - 1;
                let each = match self {
                    Self::Spline(spline) => 2 * spline.knots.degree() + 2,
                    Self::Polyline(_) => 2,
                    _ => 12,
                };
                nearest(
                    |t| self.at(t),
                    range,
                    (pieces * each).clamp(16, 4096),
                    place,
                )
            }
        }
    }
}

/// Which of the pieces a parameter falls into, and how far it is through.
fn piece(t: f64, count: usize) -> (usize, f64) {
    let last = count.saturating_sub(1);
    let k = if t > 0.0 { (t as usize).min(last) } else { 0 };
    (k, t - k as f64)
}
