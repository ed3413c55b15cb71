//! Approximate implicitization: the polynomial of given degree that best vanishes on points of a
//! parametric surface.
//!
//! Dokken (1997), "Aspects of intersection algorithms and approximation"; in its discrete form,
//! with the collocation matrix of the monomials at sampled points, Barrowclough and Dokken (2012),
//! "Approximate implicitization using linear algebra". It knows nothing of the five families, which
//! makes it a check on their closed forms and a way for surfaces that have none.

use nalgebra::DMatrix;

use super::polynomial::{Polynomial, monomials};
use crate::cloud::{Bounds, Point};
use crate::sorting::sort_by;

/// Highest degree that is fitted; monomials of higher degree are too much alike to tell apart in
/// double precision.
pub const MAX_DEGREE: u32 = 6;

/// A fitted polynomial and how sure it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Implicitization {
    /// The polynomial, in the coordinates of the points; coefficients of norm 1, sign free.
    pub polynomial: Polynomial,
    /// Root mean square of its values at the points, in the frame of the fit (the points' box
    /// centred and scaled to half-width 1, coefficients of norm 1).
    pub residual: f64,
    /// The same for the second-best polynomial. Where it is as small as the residual the
    /// polynomial is not unique: the degree is too high, or the points too few or too special.
    pub runner_up: f64,
}

/// Why nothing was fitted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ImplicitizationError {
    /// The degree is 0 or above [`MAX_DEGREE`].
    #[error("degree {degree} is not between 1 and {MAX_DEGREE}")]
    Degree {
        /// The degree asked for.
        degree: u32,
    },
    /// Fewer points than coefficients.
    #[error("{needed} points are needed, not {found}")]
    TooFewPoints {
        /// One for each coefficient.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// All points are one, or a coordinate is not finite.
    #[error("the points have no extent, or one that is not finite")]
    NoExtent,
    /// The singular value decomposition did not converge.
    #[error("the singular value decomposition did not converge")]
    NoConvergence,
}

/// The polynomial of the given total degree with the least sum of squares at the points: the last
/// right singular vector of the matrix of monomials. O(points · m²) for m coefficients.
///
/// # Errors
/// [`ImplicitizationError`].
pub fn implicitize(points: &[Point], degree: u32) -> Result<Implicitization, ImplicitizationError> {
    const ITERATIONS: usize = 10_000;
    if !(1..=MAX_DEGREE).contains(&degree) {
        return Err(ImplicitizationError::Degree { degree });
    }
    let needed = monomials(degree).count();
    if points.len() < needed {
        return Err(ImplicitizationError::TooFewPoints {
            needed,
            found: points.len(),
        });
    }
    let bounds = Bounds::of(points);
    let (origin, scale) = (bounds.centre(), bounds.size().amax() / 2.0);
    let finite = points
        .iter()
        .flat_map(Point::iter)
        .all(|value| value.is_finite());
    if !(finite && scale > 0.0 && scale.is_finite()) {
        return Err(ImplicitizationError::NoExtent);
    }
    let rows = points.iter().flat_map(|point| {
        let at = (point - origin) / scale;
        monomials(degree)
            .map(move |[p, q, r]| at.x.powi(p as i32) * at.y.powi(q as i32) * at.z.powi(r as i32))
    });
    let matrix = DMatrix::from_row_iterator(points.len(), needed, rows);
    let svd = matrix
        .try_svd(false, true, f64::EPSILON, ITERATIONS)
        .ok_or(ImplicitizationError::NoConvergence)?;
    let basis = svd.v_t.ok_or(ImplicitizationError::NoConvergence)?;
    let mut order: Vec<usize> = (0..needed).collect();
    sort_by(&mut order, |&a, &b| {
        svd.singular_values[a].total_cmp(&svd.singular_values[b])
    });
    let &[best, second, ..] = order.as_slice() else {
        return Err(ImplicitizationError::NoConvergence);
    };
    let coefficients = basis.row(best).iter().copied().collect();
    let in_frame =
        Polynomial::new(degree, coefficients).ok_or(ImplicitizationError::NoConvergence)?;
    let root_of_count = (points.len() as f64).sqrt();
    Ok(Implicitization {
        polynomial: in_frame.out_of_frame(&origin, scale).normalised(),
        residual: svd.singular_values[best] / root_of_count,
        runner_up: svd.singular_values[second] / root_of_count,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;
    use crate::surface::{
        Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, sample_parametric,
    };

    /// Largest difference of entries of two vectors scaled to norm 1, whatever their sign.
    fn difference(v: &[f64], w: &[f64]) -> f64 {
        let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (v_norm, w_norm) = (norm(v), norm(w));
        let with_sign = |sign: f64| {
            let pairs = v.iter().zip(w);
            pairs.fold(0.0, |worst: f64, (v, w)| {
                worst.max((v / v_norm - sign * w / w_norm).abs())
            })
        };
        with_sign(1.0).min(with_sign(-1.0))
    }

    #[test]
    fn all_five_families_agree_with_their_closed_forms() {
        let (at, axis) = (Point::new(3.0, -2.0, 1.0), Vector::new(1.0, 2.0, -0.5));
        for surface in [
            Surface::Plane(Plane::new(at, axis)),
            Surface::Cylinder(Cylinder::new(at, axis, 2.0)),
            Surface::Cone(Cone::new(at, axis, 0.6)),
            Surface::Sphere(Sphere::new(at, 4.0)),
            Surface::Torus(Torus::new(at, axis, 5.0, 2.0)),
        ] {
            let kind = surface.kind();
            let points = sample_parametric(kind, &surface.to_parametric());
            let fitted = implicitize(&points, kind.implicit_degree()).unwrap();
            let vector = fitted.polynomial.to_implicit(kind).unwrap();
            let distance = difference(&vector, &surface.to_implicit());
            assert!(distance < 1e-9, "{kind}: {distance:e}");
            assert!(fitted.residual < 1e-14, "{kind}: {:e}", fitted.residual);
            assert!(fitted.runner_up > 1e-4, "{kind}: {:e}", fitted.runner_up);
        }
    }

    #[test]
    fn the_files_frame_with_a_ring_away_from_the_apex_serves_as_well() {
        let s = 0.5f64.sqrt();
        let vector = [
            -13.5, 0., 0., 0., 13.5, 0., -s, 0., 0., 0., s, 0., 0., 0., -s, 0., 0., 26.5,
        ];
        let points = sample_parametric(SurfaceType::Cone, &vector);
        let fitted = implicitize(&points, 2).unwrap();
        let fitted = fitted.polynomial.to_implicit(SurfaceType::Cone).unwrap();
        let exact = [1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 40.0, -1600.0];
        assert!(difference(&fitted, &exact) < 1e-9);
    }

    #[test]
    fn a_degree_too_low_leaves_a_residual_and_one_too_high_is_not_unique() {
        let torus = Surface::Torus(Torus::new(Point::origin(), Vector::z(), 3.0, 1.0));
        let points = sample_parametric(SurfaceType::Torus, &torus.to_parametric());
        assert!(implicitize(&points, 2).unwrap().residual > 1e-2);
        let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
        let points = sample_parametric(SurfaceType::Sphere, &sphere.to_parametric());
        let fitted = implicitize(&points, 3).unwrap();
        assert!(fitted.residual < 1e-14 && fitted.runner_up < 1e-14);
    }

    #[test]
    fn what_cannot_be_fitted_is_refused_with_the_reason() {
        let lone = [Point::origin(); 12];
        assert_eq!(implicitize(&lone, 2), Err(ImplicitizationError::NoExtent));
        assert_eq!(
            implicitize(&lone, 4),
            Err(ImplicitizationError::TooFewPoints {
                needed: 35,
                found: 12
            })
        );
        for degree in [0, MAX_DEGREE + 1] {
            let refused = Err(ImplicitizationError::Degree { degree });
            assert_eq!(implicitize(&lone, degree), refused);
        }
        assert!(sample_parametric(SurfaceType::Sphere, &[0.0; 12]).is_empty());
    }
}
