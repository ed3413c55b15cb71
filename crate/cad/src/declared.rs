//! What the options of an import are, for every face that offers them.

use fit4cad_step as step;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// What kind of value an option has.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum OptionKind {
    /// A number in a range.
    Number {
        /// The least allowed.
        minimum: f64,
        /// The most allowed.
        maximum: f64,
        /// Whether it is whole.
        whole: bool,
    },
    /// One of some words, the first of them where none is given.
    Choice {
        /// The words.
        words: Vec<&'static str>,
    },
    /// Given or not.
    Flag,
}

/// An option of an import.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct OptionInfo {
    /// Its name.
    pub name: &'static str,
    /// What kind of value it has.
    pub value: OptionKind,
    /// What it is measured in; empty of what has no unit.
    pub unit: &'static str,
    /// The number that holds where none is given; `null` where what holds follows from the part.
    pub default: Option<f64>,
    /// What it does, with what holds where it is not given.
    pub explanation: String,
}

impl From<step::OptionValue> for OptionKind {
    fn from(value: step::OptionValue) -> Self {
        match value {
            step::OptionValue::Number {
                minimum,
                maximum,
                whole,
            } => Self::Number {
                minimum,
                maximum,
                whole,
            },
            step::OptionValue::Choice { words } => Self::Choice { words },
            step::OptionValue::Flag => Self::Flag,
        }
    }
}

impl From<step::OptionInfo> for OptionInfo {
    fn from(info: step::OptionInfo) -> Self {
        Self {
            name: info.name,
            value: info.value.into(),
            unit: info.unit,
            default: info.default,
            explanation: info.explanation,
        }
    }
}

/// The options of an import.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen(js_name = importOptions, unchecked_return_type = "OptionInfo[]")]
pub fn import_options() -> Result<Vec<Ts<OptionInfo>>, JsError> {
    let options = step::import_options().into_iter().map(OptionInfo::from);
    options
        .map(|option| option.into_ts().map_err(JsError::from))
        .collect()
}
