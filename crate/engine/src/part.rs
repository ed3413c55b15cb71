//! The sample generator's parts and options.

use fit4cad::sample;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;

/// A part that can be generated.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct PartInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// What it is and what is hard about it.
    pub description: &'static str,
}

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

/// The parts that can be generated.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen]
pub fn parts() -> Result<Vec<Ts<PartInfo>>, JsError> {
    let parts = sample::parts().iter();
    parts
        .map(|part| {
            hand_over(&PartInfo {
                name: part.name,
                title: part.title,
                description: part.description,
            })
        })
        .collect()
}
