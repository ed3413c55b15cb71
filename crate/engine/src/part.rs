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
