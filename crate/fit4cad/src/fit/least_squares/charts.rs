//! A local chart of each curved family: coordinates around one surface in which a small step is a
//! small change of the surface, with the distance of a point and its derivatives in closed form.
//!
//! Written in the cylindrical coordinates of a point x about the axis: height h, distance from the
//! axis ρ, outward direction u. Moving the axis by t changes ρ by -u·t and h by -a·t; tilting it
//! about the reference point by e changes ρ by -h u·e and h by ρ u·e.

mod torus;

pub(super) use torus::TorusChart;

use nalgebra::SVector;

use crate::cloud::{Direction, Vector};
use crate::surface::{Cone, Cylinder, Sphere, Surface, across};

/// A surface with a chart of N coordinates around it.
pub(super) trait Chart<const N: usize>: Copy {
    /// Signed distance of a point, and its derivatives by the coordinates.
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, N>);

    /// The surface at these coordinates, with a chart of its own.
    fn moved(&self, step: &SVector<f64, N>) -> Self;

    /// The surface in its canonical form; `None` where it has degenerated.
    fn surface(&self) -> Option<Surface>;
}

/// An axis with a reference point and two directions across it.
#[derive(Clone, Copy)]
struct AxisFrame {
    point: Vector,
    axis: Direction,
    first: Direction,
    second: Direction,
}

/// A point in cylindrical coordinates.
struct Axial {
    height: f64,
    radius: f64,
    /// Outward direction, in the two directions across the axis.
    outward: [f64; 2],
}

impl AxisFrame {
    fn new(point: Vector, axis: Direction) -> Self {
        let first = across(&axis);
        Self {
            point,
            axis,
            first,
            second: Direction::new_unchecked(axis.cross(&first)),
        }
    }

    fn axial(&self, point: &Vector) -> Axial {
        let offset = point - self.point;
        let (x, y) = (offset.dot(&self.first), offset.dot(&self.second));
        // Coordinates are of the order of one, so nothing is lost by the plain root, which is many
        // times faster than `hypot`.
        let radius = (x * x + y * y).sqrt();
        let outward = if radius > 0.0 {
            [x / radius, y / radius]
        } else {
            [1.0, 0.0]
        };
        Axial {
            height: offset.dot(&self.axis),
            radius,
            outward,
        }
    }

    /// Shifts the reference point across (and along) the axis, then tilts the axis about it.
    fn moved(&self, shift: [f64; 3], tilt: [f64; 2]) -> Self {
        let (first, second) = (self.first.into_inner(), self.second.into_inner());
        let along = self.axis.into_inner();
        let point = self.point + first * shift[0] + second * shift[1] + along * shift[2];
        Self::new(
            point,
            Direction::new_normalize(along + first * tilt[0] + second * tilt[1]),
        )
    }

    /// The same axis with the reference point nearest the origin, which is the centroid: a tilt
    /// about a distant point would be all but a shift, and the normal equations near singular.
    fn centred(self) -> Self {
        Self {
            point: self.point - self.axis.into_inner() * self.point.dot(&self.axis),
            ..self
        }
    }

    fn is_finite(&self) -> bool {
        self.point
            .iter()
            .chain(self.axis.iter())
            .all(|x| x.is_finite())
    }
}

/// Centre and radius.
#[derive(Clone, Copy)]
pub(super) struct SphereChart {
    centre: Vector,
    radius: f64,
}

impl SphereChart {
    pub(super) fn new(sphere: &Sphere) -> Self {
        Self {
            centre: sphere.centre.coords,
            radius: sphere.radius,
        }
    }
}

impl Chart<4> for SphereChart {
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, 4>) {
        let offset = point - self.centre;
        let length = offset.norm();
        let out = if length > 0.0 {
            offset / length
        } else {
            Vector::x()
        };
        (length - self.radius, [-out.x, -out.y, -out.z, -1.0].into())
    }

    fn moved(&self, step: &SVector<f64, 4>) -> Self {
        Self {
            centre: self.centre + step.fixed_rows::<3>(0),
            radius: self.radius + step[3],
        }
    }

    fn surface(&self) -> Option<Surface> {
        let finite = self.centre.iter().all(|x| x.is_finite()) && self.radius.is_finite();
        (finite && self.radius > 0.0)
            .then(|| Surface::Sphere(Sphere::new(self.centre.into(), self.radius)))
    }
}

/// Two shifts across the axis, two tilts, the radius.
#[derive(Clone, Copy)]
pub(super) struct CylinderChart {
    frame: AxisFrame,
    radius: f64,
}

impl CylinderChart {
    pub(super) fn new(cylinder: &Cylinder) -> Self {
        Self {
            frame: AxisFrame::new(cylinder.centre.coords, cylinder.axis).centred(),
            radius: cylinder.radius,
        }
    }
}

impl Chart<5> for CylinderChart {
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, 5>) {
        let Axial {
            height,
            radius,
            outward: [u, v],
        } = self.frame.axial(point);
        let gradient = [-u, -v, -height * u, -height * v, -1.0];
        (radius - self.radius, gradient.into())
    }

    fn moved(&self, step: &SVector<f64, 5>) -> Self {
        Self {
            frame: self
                .frame
                .moved([step[0], step[1], 0.0], [step[2], step[3]])
                .centred(),
            radius: self.radius + step[4],
        }
    }

    fn surface(&self) -> Option<Surface> {
        let valid = self.frame.is_finite() && self.radius.is_finite() && self.radius > 0.0;
        valid.then(|| {
            let axis = self.frame.axis.into_inner();
            Surface::Cylinder(Cylinder::new(self.frame.point.into(), axis, self.radius))
        })
    }
}

/// Two shifts, two tilts, the slope φ against the axis and the distance s of the surface from the
/// reference point, so that d = ρ cos φ - h sin φ - s. A cylinder is the regular point φ = 0, and
/// a search may pass through it. Only the nappe that holds most points is fitted.
#[derive(Clone, Copy)]
pub(super) struct ConeChart {
    frame: AxisFrame,
    slope: f64,
    /// Sine and cosine of the slope: taken once, not for every point.
    sin_cos: (f64, f64),
    reach: f64,
}

impl ConeChart {
    pub(super) fn new(cone: &Cone, points: &[Vector]) -> Self {
        let apex = cone.apex.coords;
        let above = points
            .iter()
            .filter(|&p| (p - apex).dot(&cone.axis) > 0.0)
            .count();
        let slope = if 2 * above >= points.len() {
            cone.half_angle
        } else {
            -cone.half_angle
        };
        let frame = AxisFrame::new(apex, cone.axis).centred();
        let height = (frame.point - apex).dot(&frame.axis);
        Self {
            frame,
            slope,
            sin_cos: libm::sincos(slope),
            reach: height * libm::sin(slope),
        }
    }

    /// The cone of half-angle zero.
    pub(super) fn from_cylinder(cylinder: &Cylinder) -> Self {
        Self {
            frame: AxisFrame::new(cylinder.centre.coords, cylinder.axis).centred(),
            slope: 0.0,
            sin_cos: (0.0, 1.0),
            reach: cylinder.radius,
        }
    }
}

impl Chart<6> for ConeChart {
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, 6>) {
        let Axial {
            height,
            radius,
            outward: [u, v],
        } = self.frame.axial(point);
        let (sin, cos) = self.sin_cos;
        let tilt = -(cos * height + sin * radius);
        let turn = -(radius * sin + height * cos);
        let gradient = [-cos * u, -cos * v, tilt * u, tilt * v, turn, -1.0];
        (radius * cos - height * sin - self.reach, gradient.into())
    }

    fn moved(&self, step: &SVector<f64, 6>) -> Self {
        let frame = self
            .frame
            .moved([step[0], step[1], 0.0], [step[2], step[3]]);
        let slope = self.slope + step[4];
        let reach = self.reach + step[5];
        let centred = frame.centred();
        let shift = (centred.point - frame.point).dot(&frame.axis);
        Self {
            frame: centred,
            slope,
            sin_cos: libm::sincos(slope),
            reach: reach + shift * libm::sin(slope),
        }
    }

    fn surface(&self) -> Option<Surface> {
        let slope = self.slope.abs();
        // Flatter than this against the axis, the apex lies beyond ten thousand patch sizes.
        const LEAST: f64 = 1e-4;
        let valid = self.frame.is_finite() && self.reach.is_finite();
        if !valid || !(LEAST..std::f64::consts::FRAC_PI_2 - LEAST).contains(&slope) {
            return None;
        }
        let axis = self.frame.axis.into_inner();
        let apex = self.frame.point - axis * (self.reach / libm::sin(self.slope));
        Some(Surface::Cone(Cone::new(apex.into(), axis, slope)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Torus;
    use nalgebra::Point3;

    /// Central differences along every coordinate.
    fn assert_derivatives<const N: usize>(chart: impl Chart<N>) {
        let points = [
            Vector::new(0.9, 0.2, 0.4),
            Vector::new(-0.5, 0.8, -0.3),
            Vector::new(0.3, -1.1, 0.7),
        ];
        for point in points {
            let gradient = chart.distance(&point).1;
            for i in 0..N {
                let mut step = SVector::<f64, N>::zeros();
                step[i] = 1e-6;
                let ahead = chart.moved(&step).distance(&point).0;
                let behind = chart.moved(&-step).distance(&point).0;
                let numeric = (ahead - behind) / 2e-6;
                assert!(
                    (numeric - gradient[i]).abs() < 1e-8,
                    "{i}: {numeric} {}",
                    gradient[i]
                );
            }
        }
    }

    fn tilted() -> Vector {
        Vector::new(0.3, -0.2, 1.0)
    }

    #[test]
    fn derivatives_of_the_distance_agree_with_differences() {
        let centre = Point3::new(0.1, 0.2, -0.3);
        assert_derivatives(SphereChart::new(&Sphere::new(centre, 0.8)));
        assert_derivatives(CylinderChart::new(&Cylinder::new(centre, tilted(), 0.7)));
        assert_derivatives(ConeChart::new(&Cone::new(centre * 4.0, tilted(), 0.4), &[]));
        let torus = Torus::new(centre, tilted(), 0.9, 0.3);
        assert_derivatives(TorusChart::new(&torus, &[Vector::new(0.7, 0.4, 0.2)]));
        assert_derivatives(TorusChart::new(&torus, &[Vector::new(0.1, -0.6, 0.1)]));
    }

    #[test]
    fn a_cone_survives_entering_and_leaving_its_chart() {
        let cone = Cone::new(Point3::new(0.3, 0.1, -2.0), tilted(), 0.4);
        let points = [Vector::zeros()];
        let Some(Surface::Cone(back)) = ConeChart::new(&cone, &points).surface() else {
            panic!("not a cone");
        };
        assert!((back.apex - cone.apex).norm() < 1e-14);
        assert!((back.half_angle - cone.half_angle).abs() < 1e-15);
    }
}
