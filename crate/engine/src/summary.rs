//! Measures over many models.

use std::collections::BTreeMap;

use fit4cad::metrics::{self, Measure, Score};
use js_sys::{Float64Array, Uint32Array};
use serde::{Deserialize, Serialize};
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

impl From<metrics::Distribution> for Distribution {
    fn from(found: metrics::Distribution) -> Self {
        Self {
            count: found.count as u32,
            mean: found.mean,
            min: found.min,
            lower_quartile: found.lower_quartile,
            median: found.median,
            upper_quartile: found.upper_quartile,
            max: found.max,
        }
    }
}

/// What a summary takes of many reports: a row for each, in one call for all of them.
#[derive(Debug, Clone, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Scores {
    /// The names of the methods.
    pub methods: Vec<String>,
    /// The method of each report, as its place among them.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub method: Uint32Array,
    /// The measures of each report, row after row, in the order of the list of measures; NaN where
    /// one cannot be had.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float64Array")]
    pub measures: Float64Array,
    /// The type errors of each report.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub type_errors: Uint32Array,
}

/// One method over the models it was scored on.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(hashmap_as_object)]
pub struct MethodSummary {
    /// The method.
    pub method: String,
    /// Number of models it was scored on.
    pub models: u32,
    /// Type errors on all of them.
    pub type_errors: u32,
    /// Each measure over the models that have it; absent for one that none has.
    #[tsify(type = "Partial<Record<Measure, Distribution>>")]
    pub over: BTreeMap<&'static str, Distribution>,
}

/// Sums up reports method by method, in the order in which the methods first appear. O(n log n).
///
/// # Errors
/// If the argument is not of the declared type, or its lists are not of as many reports.
#[wasm_bindgen]
pub fn summarise(scores: Ts<Scores>) -> Result<Vec<Ts<MethodSummary>>, JsError> {
    let scores = scores.to_rust()?;
    let (rows, type_errors) = (scores.measures.to_vec(), scores.type_errors.to_vec());
    let rows = rows_of(&rows)?;
    let methods = scores.method.to_vec();
    if rows.len() != methods.len() || type_errors.len() != methods.len() {
        return Err(JsError::new(
            "a row and a number of type errors for each method are needed",
        ));
    }
    let named = |place: u32| scores.methods.get(place as usize).map(String::as_str);
    let reports = methods.into_iter().zip(rows).zip(type_errors);
    let scores = reports.filter_map(|((method, row), type_errors)| {
        Some(Score {
            method: named(method)?,
            measures: row.map(known),
            type_errors: type_errors as usize,
        })
    });
    let summaries = metrics::summarise(scores).into_iter();
    summaries
        .map(|summary| {
            // One by one: to be collected they would be sorted, by code of their own.
            let mut over = BTreeMap::new();
            for measure in Measure::ALL {
                if let Some(distribution) = summary.over(measure) {
                    over.insert(measure.name(), Distribution::from(distribution));
                }
            }
            hand_over(&MethodSummary {
                over,
                models: summary.models as u32,
                type_errors: summary.type_errors as u32,
                method: summary.method.clone(),
            })
        })
        .collect()
}

const MEASURES: usize = Measure::ALL.len();

/// Measures row after row, in the order of [`Measure::ALL`].
pub(crate) fn rows_of(flat: &[f64]) -> Result<&[[f64; MEASURES]], JsError> {
    match flat.as_chunks() {
        (rows, []) => Ok(rows),
        _ => Err(JsError::new(&format!(
            "every row is made of {MEASURES} measures"
        ))),
    }
}

/// NaN stands for a figure that cannot be had.
pub(crate) fn known(value: f64) -> Option<f64> {
    (!value.is_nan()).then_some(value)
}
