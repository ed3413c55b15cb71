//! What models hold, in numbers, as plain objects.

use fit4cad::metrics::Distribution;
use fit4cad::statistics::{self, TypeCounts};
use fit4cad::surface::SurfaceType;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::{Model, hand_over};

/// Number of true primitives of each type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "PascalCase")]
#[allow(
    missing_docs,
    reason = "each is a type, and Other any that is none of the five"
)]
pub struct Types {
    pub plane: u32,
    pub cylinder: u32,
    pub cone: u32,
    pub sphere: u32,
    pub torus: u32,
    pub other: u32,
}

/// Share of true primitives of each type, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "PascalCase")]
#[allow(
    missing_docs,
    reason = "each is a type, and Other any that is none of the five"
)]
pub struct TypeShares {
    pub plane: f64,
    pub cylinder: f64,
    pub cone: f64,
    pub sphere: f64,
    pub torus: f64,
    pub other: f64,
}

impl From<[f64; 6]> for TypeShares {
    fn from([plane, cylinder, cone, sphere, torus, other]: [f64; 6]) -> Self {
        Self {
            plane,
            cylinder,
            cone,
            sphere,
            torus,
            other,
        }
    }
}

impl From<TypeCounts> for Types {
    fn from(counts: TypeCounts) -> Self {
        let [plane, cylinder, cone, sphere, torus, other] = counts.map(|count| count as u32);
        Self {
            plane,
            cylinder,
            cone,
            sphere,
            torus,
            other,
        }
    }
}

impl From<Types> for TypeCounts {
    fn from(types: Types) -> Self {
        const _: () = assert!(SurfaceType::ALL.len() == 5);
        let Types {
            plane,
            cylinder,
            cone,
            sphere,
            torus,
            other,
        } = types;
        [plane, cylinder, cone, sphere, torus, other].map(|count| count as usize)
    }
}

/// One model in numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Tsify)]
pub struct ModelStatistics {
    /// Its name.
    pub name: String,
    /// Number of points.
    pub points: u32,
    /// Number of true primitives.
    pub primitives: u32,
    /// Number of points that a true primitive lists; absent without truth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub segmented: Option<u32>,
    /// Share of the points that no true primitive lists; absent without points or truth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub unsegmented: Option<f64>,
    /// Number of points that several true primitives list.
    pub shared: u32,
    /// True primitives by type.
    pub types: Types,
}

impl From<&statistics::ModelStatistics> for ModelStatistics {
    fn from(model: &statistics::ModelStatistics) -> Self {
        Self {
            name: model.name.clone(),
            points: model.points as u32,
            primitives: model.primitives() as u32,
            segmented: model.segmented.map(|points| points as u32),
            unsegmented: model.unsegmented(),
            shared: model.shared as u32,
            types: model.types.into(),
        }
    }
}

impl From<ModelStatistics> for statistics::ModelStatistics {
    fn from(model: ModelStatistics) -> Self {
        Self {
            name: model.name,
            points: model.points as usize,
            segmented: model.segmented.map(|points| points as usize),
            shared: model.shared as usize,
            types: model.types.into(),
        }
    }
}

/// How a figure is spread over models.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct Spread {
    /// Smallest.
    pub min: f64,
    /// The middle one.
    pub median: f64,
    /// Largest.
    pub max: f64,
}

impl From<Distribution> for Spread {
    fn from(figure: Distribution) -> Self {
        let Distribution {
            min, median, max, ..
        } = figure;
        Self { min, median, max }
    }
}

/// A set of models in numbers; `null` where one cannot be had.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct DatasetStatistics {
    /// Number of models.
    pub models: u32,
    /// Number of points of all models.
    pub points: f64,
    /// Number of true primitives of all models.
    pub primitives: u32,
    /// True primitives by type: a bar chart of the paper.
    pub types: Types,
    /// The share of each type in all true primitives; `null` without any.
    pub type_shares: Option<TypeShares>,
    /// Number of points that several true primitives list.
    pub shared: f64,
    /// Share of all points that no true primitive lists.
    pub unsegmented: Option<f64>,
    /// Points of a model.
    pub points_per_model: Option<Spread>,
    /// True primitives of a model.
    pub primitives_per_model: Option<Spread>,
    /// Share of a model's points that no true primitive lists.
    pub unsegmented_per_model: Option<Spread>,
}

#[wasm_bindgen]
impl Model {
    /// Counts the model's points and true primitives.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn statistics(&self) -> Result<Ts<ModelStatistics>, JsError> {
        hand_over(&ModelStatistics::from(&statistics::ModelStatistics::of(
            &self.model,
        )))
    }

    /// Counts the primitives of a method, or of the truth, by type.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn types(&self, method: Option<String>) -> Result<Ts<Types>, JsError> {
        let segmentation = self.segmentation(method.as_deref())?;
        hand_over(&Types::from(statistics::types_of(segmentation)))
    }
}

/// Sums up what [`Model::statistics`] gave for each of a set of models.
///
/// # Errors
/// Only if the argument is not of the declared type.
#[wasm_bindgen(js_name = datasetStatistics)]
pub fn dataset_statistics(
    models: Vec<Ts<ModelStatistics>>,
) -> Result<Ts<DatasetStatistics>, JsError> {
    let models = models
        .iter()
        .map(|model| model.to_rust().map(statistics::ModelStatistics::from))
        .collect::<Result<Vec<_>, _>>()?;
    let set = statistics::DatasetStatistics::of(&models);
    hand_over(&DatasetStatistics {
        models: set.models as u32,
        points: set.points as f64,
        primitives: set.primitives as u32,
        types: set.types.into(),
        type_shares: set.type_shares().map(TypeShares::from),
        shared: set.shared as f64,
        unsegmented: set.unsegmented,
        points_per_model: set.points_per_model.map(Spread::from),
        primitives_per_model: set.primitives_per_model.map(Spread::from),
        unsegmented_per_model: set.unsegmented_per_model.map(Spread::from),
    })
}
