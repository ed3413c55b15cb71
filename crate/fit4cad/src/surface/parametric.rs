//! The parametric form (paper, appendix "Parametric representations"): evaluation and conversion
//! to and from the canonical form.
//!
//! What counts is the set of points, not the frame: `a = (-8, 0, 0), b = (0, -8, 0)` and an
//! oblique section both describe a circular cylinder and convert without misfit.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Matrix3;

use super::conversion::{Conversion, ConversionError, Defect, check_values};
use super::{
    Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, across, direction, magnitude,
};
use crate::cloud::{Direction, Point, Vector};

/// Sine of the angle below which two vectors count as parallel.
const PARALLEL: f64 = 1e-12;

impl Surface {
    /// The surface of a parametric vector in the paper's order.
    ///
    /// # Errors
    /// [`ConversionError`] where the vector has another length, holds no finite numbers or is so
    /// degenerate that no member of the family is near. A vector that merely misses the family
    /// gives the nearest member found with its [`misfit`](Conversion::misfit).
    ///
    /// ```
    /// use fit4cad::surface::{Surface, SurfaceType};
    /// // u, v and a point of the plane z = 2.
    /// let vector = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0];
    /// let found = Surface::from_parametric(SurfaceType::Plane, &vector)?;
    /// let Surface::Plane(plane) = found.surface else { unreachable!() };
    /// assert_eq!((plane.offset, plane.normal.z), (2.0, 1.0));
    /// # Ok::<(), fit4cad::surface::ConversionError>(())
    /// ```
    pub fn from_parametric(
        kind: SurfaceType,
        values: &[f64],
    ) -> Result<Conversion, ConversionError> {
        check_values(kind, values, kind.parametric_len())?;
        let form = Parametric { kind, values };
        let (surface, region) = form
            .surface()
            .map_err(|defect| ConversionError::Degenerate { kind, defect })?;
        Conversion::checked(surface, form.misfit(&surface, &region))
    }

    /// The parametric vector in the paper's order, with an orthogonal frame. The cone's starts at
    /// the apex (a = b = 0).
    ///
    /// ```
    /// use fit4cad::cloud::Point;
    /// use fit4cad::surface::{Sphere, Surface, SurfaceType};
    /// let ball = Surface::Sphere(Sphere::new(Point::new(1.0, 2.0, 3.0), 4.0));
    /// let again = Surface::from_parametric(SurfaceType::Sphere, &ball.to_parametric())?;
    /// assert_eq!(again.surface, ball);
    /// # Ok::<(), fit4cad::surface::ConversionError>(())
    /// ```
    pub fn to_parametric(&self) -> Vec<f64> {
        let columns: Vec<Vector> = match self {
            Self::Plane(plane) => {
                let (u, v) = frame(&plane.normal);
                vec![u, v, plane.centre().coords]
            }
            Self::Cylinder(cylinder) => {
                let (u, v) = frame(&cylinder.axis);
                let radius = cylinder.radius;
                let axis = cylinder.axis.into_inner();
                vec![u * radius, v * radius, axis, cylinder.centre.coords]
            }
            Self::Cone(cone) => {
                let (u, v) = frame(&cone.axis);
                let (sin, cos) = libm::sincos(cone.half_angle);
                let (zero, axis) = (Vector::zeros(), cone.axis.into_inner());
                vec![zero, zero, u * sin, v * sin, axis * cos, cone.apex.coords]
            }
            Self::Sphere(sphere) => {
                let axes = [Vector::x(), Vector::y(), Vector::z()];
                let mut columns: Vec<_> = axes.iter().map(|axis| axis * sphere.radius).collect();
                columns.push(sphere.centre.coords);
                columns
            }
            Self::Torus(torus) => {
                let (u, v) = frame(&torus.axis);
                let (major, minor) = (torus.major_radius, torus.minor_radius);
                let axis = torus.axis.into_inner();
                let centre = torus.centre.coords;
                vec![
                    u * major,
                    v * major,
                    u * minor,
                    v * minor,
                    axis * minor,
                    centre,
                ]
            }
        };
        // Sums turn `-0` into `0`, which files show more kindly.
        columns
            .iter()
            .flat_map(|column| [column.x + 0.0, column.y + 0.0, column.z + 0.0])
            .collect()
    }
}

/// The point of a parametric form at the parameters (u, v) of the paper's formulas, or `None`
/// where the vector has not the length of its type.
pub fn parametric_point(kind: SurfaceType, values: &[f64], u: f64, v: f64) -> Option<Point> {
    (values.len() == kind.parametric_len()).then(|| Parametric { kind, values }.at(u, v))
}

/// Points spread over a parametric form, enough of them to tell all polynomials up to the degree of
/// any family apart; none where the vector is no surface. Open directions are covered about as far
/// as the surface is wide, a cone on both nappes. All are finite.
pub fn sample_parametric(kind: SurfaceType, values: &[f64]) -> Vec<Point> {
    const STEPS: u32 = 15;
    let form = Parametric { kind, values };
    if check_values(kind, values, kind.parametric_len()).is_err() {
        return Vec::new();
    }
    match form.surface() {
        Ok((surface, region)) if surface.is_in_range() => {
            let finite = |point: &Point| point.iter().all(|value| value.is_finite());
            form.grid(&region, STEPS).filter(finite).collect()
        }
        _ => Vec::new(),
    }
}

/// Two unit vectors that make a right-handed frame with the axis.
fn frame(axis: &Direction) -> (Vector, Vector) {
    let v = across(axis).into_inner();
    (v.cross(axis), v)
}

/// A vector of checked length, seen as the columns a, b, c, … of the paper.
#[derive(Clone, Copy)]
struct Parametric<'a> {
    kind: SurfaceType,
    values: &'a [f64],
}

/// A region of the parameters that shows the surface as about as long as it is wide.
struct Region {
    u: [f64; 2],
    v: [f64; 2],
    /// Unit of the misfit.
    size: f64,
}

const TURN: [f64; 2] = [0.0, TAU];

impl<'a> Parametric<'a> {
    fn column(&self, index: usize) -> Vector {
        let from = 3 * index;
        match self.values.get(from..from + 3) {
            Some(&[x, y, z]) => Vector::new(x, y, z),
            _ => Vector::zeros(),
        }
    }

    fn at(&self, u: f64, v: f64) -> Point {
        let column = |index| self.column(index);
        let ((sin_u, cos_u), (sin_v, cos_v)) = (libm::sincos(u), libm::sincos(v));
        let ring = |first| column(first) * cos_u + column(first + 1) * sin_u;
        Point::from(match self.kind {
            SurfaceType::Plane => column(0) * u + column(1) * v + column(2),
            SurfaceType::Cylinder => ring(0) + column(2) * v + column(3),
            SurfaceType::Cone => ring(0) + (ring(2) + column(4)) * v + column(5),
            SurfaceType::Sphere => ring(0) * cos_v + column(2) * sin_v + column(3),
            SurfaceType::Torus => ring(0) + ring(2) * cos_v + column(4) * sin_v + column(5),
        })
    }

    /// The surface, and where to look at the form.
    fn surface(self) -> Result<(Surface, Region), Defect> {
        match self.kind {
            SurfaceType::Plane => plane(self),
            SurfaceType::Cylinder => cylinder(self),
            SurfaceType::Cone => cone(self),
            SurfaceType::Sphere => sphere(self),
            SurfaceType::Torus => torus(self),
        }
    }

    /// Points on a grid of the region, `steps` + 1 along either parameter, both ends included.
    fn grid(&self, region: &Region, steps: u32) -> impl Iterator<Item = Point> {
        let (u, v) = (region.u, region.v);
        let share = move |step: u32| f64::from(step) / f64::from(steps);
        let along = move |[from, to]: [f64; 2], step| from + (to - from) * share(step);
        let pairs = (0..=steps).flat_map(move |i| (0..=steps).map(move |j| (i, j)));
        pairs.map(move |(i, j)| self.at(along(u, i), along(v, j)))
    }

    fn misfit(&self, surface: &Surface, region: &Region) -> f64 {
        const STEPS: u32 = 8;
        let mut worst = 0.0;
        for point in self.grid(region, STEPS) {
            let distance = surface.distance(&point) / region.size;
            // Unlike f64::max, this keeps NaN.
            if distance > worst || distance.is_nan() {
                worst = distance;
            }
        }
        worst
    }
}

fn plane(form: Parametric) -> Result<(Surface, Region), Defect> {
    let (a, b, c) = (form.column(0), form.column(1), form.column(2));
    let normal = normal_of(&a, &b).ok_or(Defect::NoNormal)?;
    let surface = Surface::Plane(Plane::new(Point::from(c), normal));
    let across = length(&a) / length(&b);
    let region = Region {
        u: [-1.0, 1.0],
        v: [-across, across],
        // Whatever spans a plane spans it exactly.
        size: f64::INFINITY,
    };
    Ok((surface, region))
}

fn cylinder(form: Parametric) -> Result<(Surface, Region), Defect> {
    let along = form.column(2);
    let axis = direction(&along).ok_or(Defect::NoAxis)?;
    let radius = mean_radius(&form.column(0), &form.column(1), &axis);
    if radius <= 0.0 {
        return Err(Defect::NoRadius);
    }
    let point = Point::from(form.column(3));
    let surface = Surface::Cylinder(Cylinder::new(point, along, radius));
    let rise = radius / length(&along);
    let region = Region {
        u: TURN,
        v: [-rise, rise],
        size: radius,
    };
    Ok((surface, region))
}

/// The rings a cos u + b sin u + v (c cos u + d sin u) close at v₀ = −a·c/c·c, the apex.
fn cone(form: Parametric) -> Result<(Surface, Region), Defect> {
    let column = |index| form.column(index);
    let (a, b, c, d, e) = (column(0), column(1), column(2), column(3), column(4));
    let growth = c.norm_squared() + d.norm_squared();
    if growth <= 0.0 || e.norm_squared() <= 0.0 {
        return Err(Defect::NoOpening);
    }
    // The longer vectors give the direction with more digits.
    let along = if 2.0 * e.norm_squared() >= growth {
        e
    } else {
        normal_of(&c, &d).ok_or(Defect::NoAxis)?
    };
    let axis = direction(&along).ok_or(Defect::NoAxis)?;
    let half_angle = libm::atan2(mean_radius(&c, &d, &axis), e.dot(&axis).abs());
    if !(half_angle > 0.0 && e.dot(&axis) != 0.0) {
        return Err(Defect::NoOpening);
    }
    let closing = -(a.dot(&c) + b.dot(&d)) / growth;
    let apex = Point::from(column(5) + e * closing);
    let surface = Surface::Cone(Cone::new(apex, along, half_angle));
    // At v = 0, where the patches of the files begin, unless the apex is there.
    let span = if closing == 0.0 { 1.0 } else { closing.abs() };
    let region = Region {
        u: TURN,
        v: [closing - span, closing + span],
        size: span * (growth / 2.0 + e.norm_squared()).sqrt(),
    };
    Ok((surface, region))
}

fn sphere(form: Parametric) -> Result<(Surface, Region), Defect> {
    let columns = [form.column(0), form.column(1), form.column(2)];
    // One so small that its square vanishes is no zero: it is told of as too small.
    if columns.iter().all(|column| column.amax() == 0.0) {
        return Err(Defect::NoRadius);
    }
    let radius = Matrix3::from_columns(&columns).singular_values().mean();
    let surface = Surface::Sphere(Sphere::new(Point::from(form.column(3)), radius));
    let region = Region {
        u: TURN,
        v: [-FRAC_PI_2, FRAC_PI_2],
        size: radius,
    };
    Ok((surface, region))
}

fn torus(form: Parametric) -> Result<(Surface, Region), Defect> {
    let column = |index| form.column(index);
    let (a, b, c, d, e) = (column(0), column(1), column(2), column(3), column(4));
    // A small error of direction matters most on the larger circle.
    let along = normal_of(&a, &b).unwrap_or(e);
    let axis = direction(&along).ok_or(Defect::NoAxis)?;
    let major = mean_radius(&a, &b, &axis);
    let minor = (2.0 * mean_radius(&c, &d, &axis) + e.norm()) / 3.0;
    if minor <= 0.0 {
        return Err(Defect::NoRadius);
    }
    let surface = Surface::Torus(Torus::new(Point::from(column(5)), along, major, minor));
    let region = Region {
        u: TURN,
        v: TURN,
        size: minor,
    };
    Ok((surface, region))
}

/// The length of a vector that is not zero, though its square may be no double.
fn length(vector: &Vector) -> f64 {
    let scale = magnitude(vector);
    scale * (vector / scale).norm()
}

/// The unit normal of two vectors, if they are not parallel.
fn normal_of(a: &Vector, b: &Vector) -> Option<Vector> {
    let (a, b) = (direction(a)?.into_inner(), direction(b)?.into_inner());
    a.cross(&b).try_normalize(PARALLEL)
}

/// The mean of the half-axes of the ellipse a cos u + b sin u, seen along the axis.
fn mean_radius(a: &Vector, b: &Vector, axis: &Direction) -> f64 {
    let seen = |vector: &Vector| vector - axis.into_inner() * vector.dot(axis);
    let (a, b) = (seen(a), seen(b));
    let (aa, bb, ab) = (a.norm_squared(), b.norm_squared(), a.dot(&b));
    let longer = ((aa + bb + libm::hypot(aa - bb, 2.0 * ab)) / 2.0).sqrt();
    if longer > 0.0 {
        (longer + a.cross(&b).norm() / longer) / 2.0
    } else {
        0.0
    }
}
