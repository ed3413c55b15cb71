//! The sample generator's options.

use fit4cad::sample;
use serde::Deserialize;
use tsify::Tsify;

/// How a part becomes a cloud; lengths are fractions of the diagonal of its bounding box.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Tsify)]
pub struct SampleOptions {
    /// Seed of everything random; 1 by default.
    #[serde(default)]
    #[tsify(optional)]
    pub seed: Option<u64>,
    /// Median distance between nearest neighbours; that of the benchmark's clouds by default.
    #[serde(default)]
    #[tsify(optional)]
    pub spacing: Option<f64>,
    /// Standard deviation of the normal noise added to each coordinate; 0 by default.
    #[serde(default)]
    #[tsify(optional)]
    pub noise: Option<f64>,
    /// Outliers per point of the part; 0 by default.
    #[serde(default)]
    #[tsify(optional)]
    pub outliers: Option<f64>,
    /// Fraction of the points cut away; 0 by default.
    #[serde(default)]
    #[tsify(optional)]
    pub missing: Option<f64>,
}

/// What is done to the points of a model, and the seed that decides where; nothing by default.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Tsify)]
pub struct Wear {
    /// Seed of everything random; 1 by default.
    #[serde(default)]
    #[tsify(optional)]
    pub seed: Option<u64>,
    /// Standard deviation of the normal noise added to each coordinate, of the diagonal.
    #[serde(default)]
    #[tsify(optional)]
    pub noise: Option<f64>,
    /// Outliers per point that is left.
    #[serde(default)]
    #[tsify(optional)]
    pub outliers: Option<f64>,
    /// Fraction of the points cut away.
    #[serde(default)]
    #[tsify(optional)]
    pub missing: Option<f64>,
    /// How many times as dense points are left at one end as at the other.
    #[serde(default)]
    #[tsify(optional)]
    pub density: Option<f64>,
}

impl From<Wear> for sample::Degradation {
    fn from(wear: Wear) -> Self {
        let default = Self::default();
        Self {
            noise: wear.noise.unwrap_or(default.noise),
            outliers: wear.outliers.unwrap_or(default.outliers),
            missing: wear.missing.unwrap_or(default.missing),
            density: wear.density.unwrap_or(default.density),
        }
    }
}

impl From<SampleOptions> for sample::Options {
    fn from(options: SampleOptions) -> Self {
        let default = Self::default();
        Self {
            seed: options.seed.unwrap_or(default.seed),
            spacing: options.spacing.unwrap_or(default.spacing),
            noise: options.noise.unwrap_or(default.noise),
            outliers: options.outliers.unwrap_or(default.outliers),
            missing: options.missing.unwrap_or(default.missing),
        }
    }
}
