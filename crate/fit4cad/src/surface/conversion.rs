//! What a conversion between the forms of a surface gives, and why it can fail.

use super::{Surface, SurfaceType};

/// The member of a family that a vector of numbers stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conversion {
    /// The surface in canonical form; the nearest member found where the vector is no member.
    pub surface: Surface,
    /// How far the form that was given and `surface` lie apart: the largest distance over sample
    /// points, as a share of the surface's size (radius, minor radius of a torus, distance from
    /// the apex of a cone). Rounding for a member; large where radii are unequal, the frame is
    /// skew or a quartic is no torus. `∞` where it cannot be measured.
    pub misfit: f64,
}

impl Conversion {
    /// Misfit up to which a vector passes as a member of its family. Files carry six digits, and
    /// radii and apexes are differences of larger numbers, so two thirds of the digits may go.
    pub const TOLERANCE: f64 = 1e-2;

    /// The surface, if the misfit is within the tolerance.
    ///
    /// # Errors
    /// [`ConversionError::NotInFamily`] with the misfit.
    pub fn within(self, tolerance: f64) -> Result<Surface, ConversionError> {
        if self.misfit <= tolerance {
            Ok(self.surface)
        } else {
            Err(ConversionError::NotInFamily {
                kind: self.surface.kind(),
                misfit: self.misfit,
            })
        }
    }

    /// Refuses results that overflowed.
    pub(super) fn checked(surface: Surface, misfit: f64) -> Result<Self, ConversionError> {
        if !surface.is_finite() {
            return Err(ConversionError::Degenerate {
                kind: surface.kind(),
                defect: Defect::Overflow,
            });
        }
        let misfit = if misfit.is_nan() {
            f64::INFINITY
        } else {
            misfit
        };
        Ok(Self { surface, misfit })
    }
}

/// Why a vector cannot be read as a surface of its family.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ConversionError {
    /// Another count of numbers than the form has.
    #[error("a {kind} has {expected} numbers in this form, not {found}")]
    WrongLength {
        /// The family.
        kind: SurfaceType,
        /// Count the form has.
        expected: usize,
        /// Count that was given.
        found: usize,
    },
    /// A number is infinite or not a number.
    #[error("number {position} is not finite")]
    NotFinite {
        /// Which number, counted from 1.
        position: usize,
    },
    /// There is no surface of this family anywhere near.
    #[error("this is no {kind}: {defect}")]
    Degenerate {
        /// The family.
        kind: SurfaceType,
        /// What is missing.
        defect: Defect,
    },
    /// The nearest member is farther away than was tolerated.
    #[error("this is no {kind}: the nearest one lies {:.3} % of its size away", misfit * 100.0)]
    NotInFamily {
        /// The family.
        kind: SurfaceType,
        /// See [`Conversion::misfit`].
        misfit: f64,
    },
}

/// What a degenerate vector lacks.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Defect {
    /// The normal of a plane is zero, or its spanning vectors are parallel.
    #[error("it has no normal")]
    NoNormal,
    /// The vectors that should give the axis are zero or parallel.
    #[error("it has no axis")]
    NoAxis,
    /// A radius is zero.
    #[error("its radius is zero")]
    NoRadius,
    /// The half-angle of a cone is 0 or π/2.
    #[error("its half-angle is 0° or 90°")]
    NoOpening,
    /// The terms of highest degree are all zero.
    #[error("its terms of highest degree are zero")]
    NoLeadingTerms,
    /// The square of a radius or of the tangent of a half-angle comes out negative.
    #[error("the square of its radius or slope is {square:.6e}")]
    Imaginary {
        /// The negative square.
        square: f64,
    },
    /// The numbers are too large or too small to compute with.
    #[error("its numbers are too large or too small to compute with")]
    Overflow,
}

/// The values, if they are finite and as many as the form has.
pub(super) fn check_values(
    kind: SurfaceType,
    values: &[f64],
    expected: usize,
) -> Result<(), ConversionError> {
    if values.len() != expected {
        return Err(ConversionError::WrongLength {
            kind,
            expected,
            found: values.len(),
        });
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(ConversionError::NotFinite {
            position: index + 1,
        }),
        None => Ok(()),
    }
}
