//! The chart of tori, by how they lie at one point of the patch.
//!
//! Centre, axis and radii are bad coordinates of a torus known from a small patch: they are far off,
//! and what the patch fixes well is a difference of things it fixes badly. The minimum lies at the
//! end of a long bent valley, along which sixty steps did not lead to an exact torus. Here the
//! coordinates are those that Marshall, Lukács and Martin (2001) call faithful: distance and normal
//! at a point of the patch, and curvatures. A small step changes the surface little over the patch.
//! Straight tubes are regular points of the chart.
//!
//! The tube has radius r = 1/k. Its spine, a circle, passes the base point at T = (ϱ - r) n, with n
//! the outward normal at the foot of the base point; there it runs along t with the curvature vector
//! c = c₁ n + c₂ b, where b = t × n. At arc length l from T it is at
//! p(l) = T + t sin(κl)/κ + c (1 - cos κl)/κ², κ = |c|.

use nalgebra::{Point3, Quaternion, SVector, UnitQuaternion};

use super::Chart;
use crate::cloud::Vector;
use crate::surface::{Surface, Torus, across};

/// A torus about a base point. Coordinates: ϱ, the turns about n, t and b, k, c₁, c₂.
#[derive(Clone, Copy)]
pub(in super::super) struct TorusChart {
    /// A point of the patch; fixed.
    base: Vector,
    /// Distance of the surface from the base point, along the normal.
    reach: f64,
    normal: Vector,
    along: Vector,
    beside: Vector,
    /// 1/r.
    bend: f64,
    /// c₁ and c₂.
    curl: [f64; 2],
    spine: Spine,
}

/// The circle that the coordinates stand for: taken once, not for every point.
#[derive(Clone, Copy)]
struct Spine {
    centre: Vector,
    axis: Vector,
    /// From the centre to T, a unit vector.
    outward: Vector,
    radius: f64,
}

impl TorusChart {
    /// The chart of a torus about that of the points which is nearest to their centroid, the origin.
    pub(in super::super) fn new(torus: &Torus, points: &[Vector]) -> Self {
        let squared = |p: &&Vector| p.norm_squared();
        let nearest = points
            .iter()
            .min_by(|a, b| squared(a).total_cmp(&squared(b)));
        let base = nearest.copied().unwrap_or_else(Vector::zeros);
        let axis = torus.axis.into_inner();
        let offset = base - torus.centre.coords;
        let radial = (offset - axis * offset.dot(&axis))
            .try_normalize(f64::MIN_POSITIVE)
            .unwrap_or_else(|| across(&torus.axis).into_inner());
        let beyond = offset - radial * torus.major_radius;
        let normal = beyond.try_normalize(f64::MIN_POSITIVE).unwrap_or(radial);
        let along = axis.cross(&radial);
        let beside = along.cross(&normal);
        let curl = -radial / torus.major_radius;
        Self {
            base,
            reach: torus.minor_radius - beyond.norm(),
            normal,
            along,
            beside,
            bend: 1.0 / torus.minor_radius,
            curl: [curl.dot(&normal), curl.dot(&beside)],
            spine: Spine {
                centre: torus.centre.coords,
                axis,
                outward: radial,
                radius: torus.major_radius,
            },
        }
    }
}

impl Chart<7> for TorusChart {
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, 7>) {
        let spine = &self.spine;
        let offset = point - spine.centre;
        let flat = offset - spine.axis * offset.dot(&spine.axis);
        let (x, y) = (flat.dot(&spine.outward), flat.dot(&self.along));
        let length = (x * x + y * y).sqrt();
        let (cos, sin) = if length > 0.0 {
            (x / length, y / length)
        } else {
            (1.0, 0.0)
        };
        let foot = spine.centre + (spine.outward * cos + self.along * sin) * spine.radius;
        let away = point - foot;
        let distance = away.norm();
        let out = if distance > 0.0 {
            away / distance
        } else {
            self.normal
        };
        let minor = 1.0 / self.bend;
        let turn = (point - self.base).cross(&out);
        let [first, second] = self.curl;
        let curl = self.normal * first + self.beside * second;
        // ∂p/∂cᵢ at fixed arc length; a shift along the spine is across `out` and does not matter.
        let angle = libm::atan2(sin, cos);
        let (swing, sweep) = bends(angle);
        let square = spine.radius * spine.radius;
        let common = -(out.dot(&curl) * square * swing
            + out.dot(&self.along) * spine.radius * sweep)
            * square;
        let own = -(1.0 - cos) * square;
        let gradient = [
            -out.dot(&self.normal),
            -turn.dot(&self.normal),
            -turn.dot(&self.along),
            -turn.dot(&self.beside),
            0.5 * minor * minor * (out - self.normal).norm_squared(),
            own * out.dot(&self.normal) + common * first,
            own * out.dot(&self.beside) + common * second,
        ];
        (distance - minor, gradient.into())
    }

    fn moved(&self, step: &SVector<f64, 7>) -> Self {
        let turn = self.normal * step[1] + self.along * step[2] + self.beside * step[3];
        // By Cayley's map: with the exponential's to second order, and of arithmetic alone.
        let rotation = UnitQuaternion::new_normalize(Quaternion::from_parts(1.0, 0.5 * turn));
        let normal = (rotation * self.normal).normalize();
        let along = rotation * self.along;
        let along = (along - normal * along.dot(&normal)).normalize();
        let beside = along.cross(&normal);
        let reach = self.reach + step[0];
        let bend = self.bend + step[4];
        let curl = [self.curl[0] + step[5], self.curl[1] + step[6]];
        let inward = normal * curl[0] + beside * curl[1];
        let curvature = inward.norm();
        let outward = -inward / curvature;
        let radius = 1.0 / curvature;
        // A tube turned inside out is none: a cost that is not a number sends the step back.
        let minor = if bend > 0.0 { 1.0 / bend } else { f64::NAN };
        Self {
            base: self.base,
            reach,
            normal,
            along,
            beside,
            bend,
            curl,
            spine: Spine {
                centre: self.base + normal * (reach - minor) - outward * radius,
                axis: outward.cross(&along),
                outward,
                radius,
            },
        }
    }

    fn surface(&self) -> Option<Surface> {
        let Spine {
            centre,
            axis,
            radius,
            ..
        } = self.spine;
        let minor = 1.0 / self.bend;
        let finite = centre.iter().chain(axis.iter()).all(|x| x.is_finite());
        let is_torus = finite && radius.is_finite() && minor.is_finite() && minor > 0.0;
        is_torus.then(|| Surface::Torus(Torus::new(Point3::from(centre), axis, radius, minor)))
    }
}

/// φ sin φ - 2 (1 - cos φ) and φ cos φ - sin φ, which are of order φ⁴ and φ³: by their series where
/// little would be left of the differences.
fn bends(angle: f64) -> (f64, f64) {
    let square = angle * angle;
    if square < 0.01 {
        let swing = square * square * (-1.0 / 12.0 + square * (1.0 / 180.0 - square / 6720.0));
        let sweep = angle * square * (-1.0 / 3.0 + square * (1.0 / 30.0 - square / 840.0));
        return (swing, sweep);
    }
    let (sin, cos) = libm::sincos(angle);
    (angle * sin - 2.0 * (1.0 - cos), angle * cos - sin)
}
