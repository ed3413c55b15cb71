//! The implicit form (paper, appendix "Implicit representations"): conversion to and from the
//! canonical form, in closed form.

mod quadric;
mod torus;

use std::f64::consts::TAU;

use super::conversion::{Conversion, ConversionError, Defect, check_values};
use super::polynomial::Polynomial;
use super::{Plane, Surface, SurfaceType, magnitude};
use crate::cloud::{Point, Vector};

impl Surface {
    /// The surface of an implicit vector in the order of the files; its norm and sign are free.
    ///
    /// # Errors
    /// [`ConversionError`] where the vector has another length, holds no finite numbers or is so
    /// degenerate that no member of the family is near. A vector that merely misses the family
    /// gives the nearest member found with its [`misfit`](Conversion::misfit).
    pub fn from_implicit(kind: SurfaceType, values: &[f64]) -> Result<Conversion, ConversionError> {
        check_values(kind, values, kind.implicit_len())?;
        let surface = match kind {
            SurfaceType::Plane => plane(values),
            SurfaceType::Cylinder => quadric::cylinder(values),
            SurfaceType::Cone => quadric::cone(values),
            SurfaceType::Sphere => quadric::sphere(values),
            SurfaceType::Torus => torus::torus(values),
        }
        .map_err(|defect| ConversionError::Degenerate { kind, defect })?;
        let misfit = match Polynomial::from_implicit(kind, values) {
            Some(polynomial) if kind != SurfaceType::Plane => misfit(&polynomial, &surface),
            _ => 0.0,
        };
        Conversion::checked(surface, misfit)
    }

    /// The implicit vector in the order of the files: unit normal for a plane, second-order part
    /// I − wwᵀ for a cylinder about w (and alike for cones and spheres), norm 1 for a torus.
    pub fn to_implicit(&self) -> Vec<f64> {
        let values = match self {
            Self::Plane(plane) => {
                let normal = plane.normal.into_inner();
                vec![normal.x, normal.y, normal.z, -plane.offset]
            }
            Self::Cylinder(cylinder) => quadric::of_cylinder(cylinder),
            Self::Cone(cone) => quadric::of_cone(cone),
            Self::Sphere(sphere) => quadric::of_sphere(sphere),
            Self::Torus(shape) => torus::of_torus(shape),
        };
        // Sums turn `-0` into `0`, which files show more kindly.
        values.into_iter().map(|value| value + 0.0).collect()
    }
}

fn plane(values: &[f64]) -> Result<Surface, Defect> {
    let &[a, b, c, d] = values else {
        return Err(Defect::NoNormal);
    };
    let normal = Vector::new(a, b, c);
    let scale = magnitude(&normal);
    if scale == 0.0 {
        return Err(Defect::NoNormal);
    }
    let (normal, d) = (normal / scale, d / scale);
    let norm = normal.norm();
    let point = Point::from(normal / norm * (-d / norm));
    Ok(Surface::Plane(Plane::new(point, normal)))
}

/// Largest first-order distance of points of the surface to the zero set, over the surface's size.
fn misfit(polynomial: &Polynomial, surface: &Surface) -> f64 {
    const ROUND: u32 = 8;
    let vector = surface.to_parametric();
    let kind = surface.kind();
    let (heights, size): (Vec<f64>, f64) = match surface {
        Surface::Plane(_) => return 0.0,
        Surface::Cylinder(cylinder) => {
            let radius = cylinder.radius;
            (vec![-radius, 0.0, radius], radius)
        }
        // A cone has no size of its own.
        Surface::Cone(cone) => {
            let size = cone.apex.coords.norm().max(1.0);
            (vec![-size, size], size)
        }
        Surface::Sphere(sphere) => (vec![-1.0, 0.0, 1.0], sphere.radius),
        Surface::Torus(torus) => {
            let angles = (0..ROUND).map(|step| TAU * f64::from(step) / f64::from(ROUND));
            (angles.collect(), torus.minor_radius)
        }
    };
    let mut worst = 0.0;
    for v in heights {
        for step in 0..ROUND {
            let u = TAU * (f64::from(step) + 0.5) / f64::from(ROUND);
            let point = super::parametric_point(kind, &vector, u, v).unwrap_or_else(Point::origin);
            let distance = polynomial.first_order_distance(&point) / size;
            // Unlike f64::max, this keeps NaN.
            if distance > worst || distance.is_nan() {
                worst = distance;
            }
        }
    }
    worst
}
