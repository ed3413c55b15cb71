//! The torus as a quartic.
//!
//! With y = x − c the torus of centre c, axis w and radii R, r is
//! |y|⁴ + yᵀBy + (R² − r²)² = 0, where B = 4R² wwᵀ − 2(R² + r²) I.
//! In powers of x: |x|⁴ − 4|x|²(c·x) + xᵀ(B + 4ccᵀ + 2|c|²I)x − 2(2|c|²c + Bc)·x + constant.
//! The fourth-degree terms give the scale, the third the centre, the second B, and the
//! eigenvalues of B the axis and the radii.

use nalgebra::{Matrix3, Vector3};

use super::super::conversion::Defect;
use super::super::polynomial::monomials;
use super::super::{Surface, Torus};
use super::quadric::Revolution;
use crate::cloud::Point;

pub(super) fn torus(values: &[f64]) -> Result<Surface, Defect> {
    let of = |exponents: [u32; 3]| -> f64 {
        let terms = monomials(4).zip(values);
        terms
            .filter(|(monomial, _)| *monomial == exponents)
            .map(|(_, value)| *value)
            .sum()
    };
    let square = |axis: usize| unit(axis).map(|exponent| 2 * exponent);
    let mut lead = 0.0;
    for axis in 0..3 {
        let next = (axis + 1) % 3;
        lead += of(square(axis).map(|e| 2 * e)) + of(sum(square(axis), square(next))) / 2.0;
    }
    lead /= 6.0;
    if lead == 0.0 {
        return Err(Defect::NoLeadingTerms);
    }
    let centre = Vector3::from_fn(|axis, _| {
        let cubic: f64 = (0..3).map(|other| of(sum(unit(axis), square(other)))).sum();
        -cubic / (12.0 * lead)
    });
    let second = Matrix3::from_fn(|row, column| {
        let coefficient = of(sum(unit(row), unit(column)));
        coefficient / lead * if row == column { 1.0 } else { 0.5 }
    });
    let b = second - quadratic_of_quartic(&centre);
    let Revolution {
        axis,
        along,
        across,
    } = Revolution::of(b)?;
    let major = (along - across) / 4.0;
    let minor = -across / 2.0 - major;
    for square in [major, minor] {
        if square < 0.0 {
            return Err(Defect::Imaginary { square });
        }
    }
    if minor == 0.0 {
        return Err(Defect::NoRadius);
    }
    Ok(Surface::Torus(Torus::new(
        Point::from(centre),
        axis.into_inner(),
        major.sqrt(),
        minor.sqrt(),
    )))
}

pub(super) fn of_torus(torus: &Torus) -> Vec<f64> {
    let (axis, centre) = (torus.axis.into_inner(), torus.centre.coords);
    let (major, minor) = (torus.major_radius.powi(2), torus.minor_radius.powi(2));
    let b = axis * axis.transpose() * (4.0 * major) - Matrix3::identity() * (2.0 * (major + minor));
    let second = b + quadratic_of_quartic(&centre);
    let distance = centre.norm_squared();
    let first = (centre * (2.0 * distance) + b * centre) * -2.0;
    let between =
        (torus.major_radius - torus.minor_radius) * (torus.major_radius + torus.minor_radius);
    let constant = distance * distance + centre.dot(&(b * centre)) + between * between;
    let mut values: Vec<f64> = monomials(4)
        .map(|exponents| {
            let odd = (0..3).find(|&axis| exponents[axis] % 2 == 1);
            let axes: Vec<usize> = (0..3).filter(|&axis| exponents[axis] > 0).collect();
            match (exponents.iter().sum::<u32>(), odd, axes.as_slice()) {
                (4, None, [_]) => 1.0,
                (4, None, _) => 2.0,
                // |x|²(c·x) holds x c_x with each of the three squares.
                (3, Some(axis), _) if exponents.iter().filter(|e| **e % 2 == 1).count() == 1 => {
                    -4.0 * centre[axis]
                }
                (2, _, &[axis]) => second[(axis, axis)],
                (2, _, &[row, column]) => 2.0 * second[(row, column)],
                (1, Some(axis), _) => first[axis],
                (0, ..) => constant,
                _ => 0.0,
            }
        })
        .collect();
    let norm = values.iter().map(|value| value * value).sum::<f64>().sqrt();
    for value in &mut values {
        *value /= norm;
    }
    values
}

/// Second-degree part in x of |x − c|⁴.
fn quadratic_of_quartic(centre: &Vector3<f64>) -> Matrix3<f64> {
    centre * centre.transpose() * 4.0 + Matrix3::identity() * (2.0 * centre.norm_squared())
}

/// Exponents of the monomial of one coordinate.
fn unit(axis: usize) -> [u32; 3] {
    let mut exponents = [0; 3];
    if let Some(exponent) = exponents.get_mut(axis) {
        *exponent = 1;
    }
    exponents
}

/// Exponents of a product.
fn sum(a: [u32; 3], b: [u32; 3]) -> [u32; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
