//! The two forms of a surface in the files, what reading a vector of them gives, and why it can fail.

use super::{Surface, SurfaceType};

/// How a vector of numbers gives a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// Paper, appendix "Parametric representations".
    Parametric,
    /// Paper, appendix "Implicit representations".
    Implicit,
}

impl Form {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Parametric, Self::Implicit];

    /// The word for it in the names of files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Parametric => "parametric",
            Self::Implicit => "implicit",
        }
    }

    /// How many numbers the vector of a type has.
    pub const fn len(self, kind: SurfaceType) -> usize {
        match self {
            Self::Parametric => kind.parametric_len(),
            Self::Implicit => kind.implicit_len(),
        }
    }

    /// The other one.
    pub const fn other(self) -> Self {
        match self {
            Self::Parametric => Self::Implicit,
            Self::Implicit => Self::Parametric,
        }
    }
}

impl Surface {
    /// The surface of a vector in either form, see [`Surface::from_parametric`] and
    /// [`Surface::from_implicit`].
    ///
    /// # Errors
    /// [`ConversionError`] as they have it.
    pub fn from_form(
        form: Form,
        kind: SurfaceType,
        values: &[f64],
    ) -> Result<Conversion, ConversionError> {
        match form {
            Form::Parametric => Self::from_parametric(kind, values),
            Form::Implicit => Self::from_implicit(kind, values),
        }
    }
}

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

    /// Refuses results with numbers that cannot be computed with.
    pub(super) fn checked(surface: Surface, misfit: f64) -> Result<Self, ConversionError> {
        if !surface.is_in_range() {
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
