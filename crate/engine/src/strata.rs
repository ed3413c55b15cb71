//! What true primitives are told apart by, and under what conditions a model is scored.

use fit4cad::metrics::field;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;

/// What true primitives are told apart by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum By {
    /// How large they are.
    Size,
    /// Their type.
    Type,
    /// The noise of their model.
    Noise,
    /// How dense the points of their model are.
    Density,
    /// How much of their model is missing.
    Missing,
}

impl From<field::By> for By {
    fn from(by: field::By) -> Self {
        match by {
            field::By::Size => Self::Size,
            field::By::Type => Self::Type,
            field::By::Noise => Self::Noise,
            field::By::Density => Self::Density,
            field::By::Missing => Self::Missing,
        }
    }
}

impl From<By> for field::By {
    fn from(by: By) -> Self {
        match by {
            By::Size => Self::Size,
            By::Type => Self::Type,
            By::Noise => Self::Noise,
            By::Density => Self::Density,
            By::Missing => Self::Missing,
        }
    }
}

/// Strata in words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct StrataInfo {
    /// Name by which they are asked for.
    pub name: By,
    /// Head of their column.
    pub title: &'static str,
    /// How the stratum of a primitive is had.
    pub how: &'static str,
    /// Whether it is a condition of a model, measured or declared, and no property of a primitive.
    pub is_condition: bool,
    /// What they are called, in the order to show them.
    pub strata: Vec<&'static str>,
}

impl From<field::By> for StrataInfo {
    fn from(by: field::By) -> Self {
        Self {
            name: by.into(),
            title: by.title(),
            how: by.how(),
            is_condition: by.is_condition(),
            strata: by.strata(),
        }
    }
}

/// A condition under which a model is scored.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Condition {
    /// Which.
    pub by: By,
    /// Noise and spacing in diagonals of the cloud's box, missing as a share; `null` where it cannot be
    /// had.
    pub value: Option<f64>,
    /// Its stratum.
    pub stratum: &'static str,
    /// Whether it is declared by what came with the model, and not measured.
    pub declared: bool,
}

impl Condition {
    /// `None` for what is no condition.
    fn new(by: field::By, value: Option<f64>, declared: bool) -> Option<Self> {
        by.of_value(value).map(|stratum| Self {
            by: by.into(),
            value,
            stratum,
            declared,
        })
    }
}

/// A condition whose value is known from elsewhere: noise and spacing in diagonals of the cloud's box,
/// missing as a share. Absent for what is no condition.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen(js_name = declaredCondition)]
pub fn declared_condition(by: Ts<By>, value: f64) -> Result<Option<Ts<Condition>>, JsError> {
    let found = Condition::new(by.to_rust()?.into(), Some(value), true);
    found.map(|found| hand_over(&found)).transpose()
}

#[wasm_bindgen]
impl Model {
    /// Measures the conditions under which the model is scored, from its points and its truth.
    ///
    /// # Errors
    /// If the model has no truth.
    pub fn conditions(&self) -> Result<Vec<Ts<Condition>>, JsError> {
        let measured = field::Conditions::of(&self.model.cloud, self.segmentation(None)?);
        let all = field::By::ALL.into_iter();
        let conditions = all.filter_map(|by| Condition::new(by, measured.value(by), false));
        conditions.map(|condition| hand_over(&condition)).collect()
    }
}
