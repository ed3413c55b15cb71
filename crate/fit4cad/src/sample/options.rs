//! How a part becomes a cloud.

use super::ranges::{MISSING, NOISE, OUTLIERS, SEED, SPACING};
use super::{Degradation, SampleError};

/// How a part becomes a cloud. All lengths are fractions of the diagonal of the part's bounding
/// box, so that the same options suit every part. [`OPTIONS`](super::OPTIONS) has ranges and defaults.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Seed of everything random.
    pub seed: u64,
    /// Median distance between nearest neighbours.
    pub spacing: f64,
    /// Standard deviation of the normal noise added to each coordinate.
    pub noise: f64,
    /// Outliers per point of the part: evenly distributed points of no primitive.
    pub outliers: f64,
    /// Fraction of the points cut away by balls and half-spaces.
    pub missing: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            // A whole number, exact as a float.
            seed: SEED.default as u64,
            spacing: SPACING.default,
            noise: NOISE.default,
            outliers: OUTLIERS.default,
            missing: MISSING.default,
        }
    }
}

impl Options {
    /// Whether every option is in its range.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`] names the first option that is not a number in its range.
    pub fn check(&self) -> Result<(), SampleError> {
        SPACING.check(self.spacing)?;
        self.degradation().check()
    }

    /// What is to be done to the clean cloud.
    pub fn degradation(&self) -> Degradation {
        Degradation {
            noise: self.noise,
            outliers: self.outliers,
            missing: self.missing,
            ..Degradation::default()
        }
    }
}
