//! What swept surfaces and splines have in common: how they end and close.

use fit4cad::cloud::{Point, Vector};

use super::axis::Axis;
use super::curve::Curve;
use super::spline::SplineSurface;
use crate::placement::Frame;

/// How exactly ends must meet to be one, over the size of the surface.
const CLOSED: f64 = 1e-6;

/// How a surface ends along one parameter.
pub(super) struct Ends {
    closed: bool,
    poles: [bool; 2],
}

impl Ends {
    pub fn axis(&self, [low, high]: [f64; 2]) -> Axis {
        Axis {
            range: [low, high],
            period: self.closed.then_some(high - low),
            poles: self.poles,
        }
    }
}

/// Looks at both ends of one parameter, at shares of the other.
pub(super) fn ends(at: impl Fn(bool, f64) -> Point, size: f64) -> Ends {
    let shares: Vec<f64> = (0..=12).map(|k| f64::from(k) / 12.0).collect();
    let row = |end: bool| -> Vec<Point> { shares.iter().map(|&share| at(end, share)).collect() };
    let (low, high) = (row(false), row(true));
    let near = |a: &Point, b: &Point| (a - b).norm() <= CLOSED * size;
    let pole = |row: &[Point]| row.iter().all(|point| near(point, &row[0]));
    let poles = [pole(&low), pole(&high)];
    let meet = low.iter().zip(&high).all(|(a, b)| near(a, b));
    Ends {
        closed: meet && !poles[0],
        poles,
    }
}

/// A length that says how large a spline surface is.
pub(super) fn size(spline: &SplineSurface) -> f64 {
    let ([u0, u1], [v0, v1]) = (spline.u.range(), spline.v.range());
    let first = spline.at(u0, v0).0;
    let mut size = 0.0_f64;
    for k in 0..=8 {
        for l in 0..=8 {
            let (s, t) = (f64::from(k) / 8.0, f64::from(l) / 8.0);
            let point = spline.at(u0 + (u1 - u0) * s, v0 + (v1 - v0) * t).0;
            size = size.max((point - first).norm());
        }
    }
    size
}

/// The parameter along a swept curve.
pub(super) fn along(curve: &Curve) -> Axis {
    match (curve.range(), curve.period()) {
        (Some([low, _]), Some(period)) => Axis::around(low, period),
        (Some([low, high]), None) => Axis::from(low, high),
        (None, _) => Axis::ENDLESS,
    }
}

/// The parameter along a curve that is turned about an axis, at which it may end.
pub(super) fn profile(curve: &Curve, frame: &Frame) -> Axis {
    let mut axis = along(curve);
    if axis.period.is_none() && axis.range.iter().all(|end| end.is_finite()) {
        let size = curve.length();
        axis.poles = axis.range.map(|end| {
            let [x, y, _] = frame.enter(&curve.at(end).0);
            libm::hypot(x, y) <= CLOSED * size
        });
    }
    axis
}

/// A curve turned about the axis of a frame.
pub(super) fn revolved(curve: &Curve, frame: &Frame, [u, v]: [f64; 2]) -> (Point, Vector, Vector) {
    let (point, tangent) = curve.at(v);
    let (sin, cos) = libm::sincos(u);
    let turn = |[x, y, z]: [f64; 3]| [cos * x - sin * y, sin * x + cos * y, z];
    let [x, y, z] = turn(frame.enter(&point));
    let along = [
        tangent.dot(&frame.x),
        tangent.dot(&frame.y),
        tangent.dot(&frame.z),
    ];
    (
        frame.leave([x, y, z]),
        frame.vector([-y, x, 0.0]),
        frame.vector(turn(along)),
    )
}

/// A curve as seen in the half-plane of an axis: distance from it and height.
pub(super) fn seen(curve: &Curve, frame: &Frame, t: f64) -> (Point, Vector) {
    let (point, tangent) = curve.at(t);
    let [x, y, z] = frame.enter(&point);
    let radius = libm::hypot(x, y);
    let (tx, ty) = (tangent.dot(&frame.x), tangent.dot(&frame.y));
    let outward = if radius > 0.0 {
        (x * tx + y * ty) / radius
    } else {
        libm::hypot(tx, ty)
    };
    let along = Vector::new(outward, tangent.dot(&frame.z), 0.0);
    (Point::new(radius, z, 0.0), along)
}

/// A curve as seen along a direction.
pub(super) fn flattened(curve: &Curve, direction: &Vector, t: f64) -> (Point, Vector) {
    let (point, tangent) = curve.at(t);
    let unit = direction / direction.norm();
    (
        point - unit * point.coords.dot(&unit),
        tangent - unit * tangent.dot(&unit),
    )
}
