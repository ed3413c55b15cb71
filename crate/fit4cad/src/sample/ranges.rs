//! What can be chosen of how a part becomes a cloud: name, range, default and explanation of each option in one table, which
//! the checks, the command line and the page all read.

use super::SampleError;

/// What is to be known about one option.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OptionInfo {
    /// Field name.
    pub name: &'static str,
    /// Unit, empty for a plain number.
    pub unit: &'static str,
    /// Smallest value allowed.
    pub minimum: f64,
    /// Largest value allowed.
    pub maximum: f64,
    /// Value when nothing is said.
    pub default: f64,
    /// Whether only whole numbers make sense.
    pub whole: bool,
    /// What it does.
    pub explanation: &'static str,
}

pub(super) static SPACING: OptionInfo = OptionInfo {
    name: "spacing",
    unit: "of the diagonal",
    minimum: 0.0005,
    maximum: 0.1,
    // The median of the benchmark's clouds.
    default: 0.0077,
    whole: false,
    explanation: "Median distance between neighbouring points.",
};

pub(super) static NOISE: OptionInfo = OptionInfo {
    name: "noise",
    unit: "of the diagonal",
    minimum: 0.0,
    maximum: 0.1,
    default: 0.0,
    whole: false,
    explanation: "Standard deviation of the noise added to each coordinate.",
};

pub(super) static OUTLIERS: OptionInfo = OptionInfo {
    name: "outliers",
    unit: "per point",
    minimum: 0.0,
    maximum: 1.0,
    default: 0.0,
    whole: false,
    explanation: "Points of no primitive, strewn through the bounding box.",
};

pub(super) static MISSING: OptionInfo = OptionInfo {
    name: "missing",
    unit: "share",
    minimum: 0.0,
    maximum: 0.95,
    default: 0.0,
    whole: false,
    explanation: "Points cut away in balls and half-spaces.",
};

pub(super) static DENSITY: OptionInfo = OptionInfo {
    name: "density",
    unit: "",
    minimum: 1.0,
    maximum: 1000.0,
    default: 1.0,
    whole: false,
    explanation: "How many times as dense points are left at one end of the cloud as at the other.",
};

/// The seed, which both lists share.
pub static SEED: OptionInfo = OptionInfo {
    name: "seed",
    unit: "",
    minimum: 0.0,
    maximum: u32::MAX as f64,
    default: 1.0,
    whole: true,
    explanation: "Of everything random: the same seed gives the same sample.",
};

/// Every option of making a part, in the order to show them.
pub static OPTIONS: [&OptionInfo; 5] = [&SPACING, &NOISE, &OUTLIERS, &MISSING, &SEED];

/// What can be done to the points of any model, beside the seed, in the order to show it.
pub static WEAR: [&OptionInfo; 4] = [&NOISE, &OUTLIERS, &MISSING, &DENSITY];

impl OptionInfo {
    /// Whether a value is in the range.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`] if it is not a number in it.
    pub(super) fn check(&self, value: f64) -> Result<(), SampleError> {
        if (self.minimum..=self.maximum).contains(&value) {
            return Ok(());
        }
        Err(SampleError::OutOfRange {
            option: self.name,
            value,
            min: self.minimum,
            max: self.maximum,
        })
    }
}
