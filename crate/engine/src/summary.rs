//! A measure over many models.

use fit4cad::metrics;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;

/// How values are spread: what a box plot shows. Quartiles lie between the two nearest values in
/// proportion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Distribution {
    /// Number of values that are numbers; at least one.
    pub count: u32,
    /// Arithmetic mean.
    pub mean: f64,
    /// Smallest value.
    pub min: f64,
    /// First quartile.
    pub lower_quartile: f64,
    /// Second quartile.
    pub median: f64,
    /// Third quartile.
    pub upper_quartile: f64,
    /// Largest value.
    pub max: f64,
}

/// The distribution of the values that are numbers (models without the measure have NaN); nothing
/// where there are none.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen]
pub fn distribution(values: &[f64]) -> Result<Option<Ts<Distribution>>, JsError> {
    let found = metrics::Distribution::of(values.iter().copied());
    found
        .map(|found| {
            hand_over(&Distribution {
                count: found.count as u32,
                mean: found.mean,
                min: found.min,
                lower_quartile: found.lower_quartile,
                median: found.median,
                upper_quartile: found.upper_quartile,
                max: found.max,
            })
        })
        .transpose()
}
