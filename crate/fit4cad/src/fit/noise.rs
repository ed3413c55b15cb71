//! What a fit took the noise of a cloud to be, and how that is known.

use super::search::Search;

/// Where the noise of a fit comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// It was given.
    Given,
    /// It follows from the tolerance that was given.
    Tolerance,
    /// It was measured on the cloud.
    Measured,
}

impl Source {
    /// A word for results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Tolerance => "tolerance",
            Self::Measured => "measured",
        }
    }
}

/// What kind of noise it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// None that could be told from rounding of exact points.
    Exact,
    /// Every point lies off its surface at random.
    Scattered,
    /// Coordinates were rounded.
    Rounded,
    /// Some points are exact, the others are not.
    Mixed,
    /// The points are on no surfaces that could be told.
    Everywhere,
}

impl Kind {
    /// A word for results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Scattered => "scattered",
            Self::Rounded => "rounded",
            Self::Mixed => "mixed",
            Self::Everywhere => "everywhere",
        }
    }
}

/// The noise that a fit went by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation of the points off their surfaces, in the units of the cloud; 0 where none could be told.
    pub deviation: f64,
    /// How it is known.
    pub source: Source,
    /// Its kind; `None` where it was given, and not seen to be rounding.
    pub kind: Option<Kind>,
    /// Step to which the coordinates were rounded, 0 where they were not seen to be.
    pub step: f64,
}

impl Noise {
    /// The noise that a search went by, of the kind that its course tells.
    pub(super) fn of(search: &Search<'_>, kind: Kind) -> Self {
        let scale = &search.scale;
        let parameters = &search.parameters;
        let is_given = parameters.noise > 0.0;
        let source = if is_given {
            Source::Given
        } else if parameters.tolerance > 0.0 && kind != Kind::Exact {
            Source::Tolerance
        } else {
            Source::Measured
        };
        Self {
            deviation: if is_given {
                parameters.noise
            } else if kind == Kind::Everywhere || !scale.has_noise() {
                0.0
            } else {
                scale.noise
            },
            source,
            kind: match kind {
                Kind::Everywhere => Some(kind),
                _ if scale.step > 0.0 => Some(Kind::Rounded),
                _ if is_given => None,
                Kind::Scattered if !scale.has_noise() => Some(Kind::Exact),
                _ => Some(kind),
            },
            step: scale.step,
        }
    }
}
