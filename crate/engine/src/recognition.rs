//! SHREC 2022's tables of segments, as plain objects.

use fit4cad::metrics::recognition;
use fit4cad::surface;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;
use crate::primitive::SurfaceType;

/// What is to be known about the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[allow(
    missing_docs,
    reason = "each is said in `RecognitionInfo` of `fit4cad::metrics`"
)]
pub struct RecognitionInfo {
    pub key: &'static str,
    pub title: &'static str,
    pub definition: &'static str,
    pub rewards: &'static str,
    pub trap: &'static str,
    pub source: &'static str,
}

impl From<recognition::RecognitionInfo> for RecognitionInfo {
    fn from(info: recognition::RecognitionInfo) -> Self {
        Self {
            key: info.key,
            title: info.title,
            definition: info.definition,
            rewards: info.rewards,
            trap: info.trap,
            source: info.source,
        }
    }
}

/// A true primitive as a segment of its own, and what was answered.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Segment {
    /// Its number in the file.
    pub truth: u32,
    /// Its type, where it is one of the five.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// The type that was answered; `null` for another or no answer.
    pub answer: Option<SurfaceType>,
    /// Mean distance of its points to the answered surface, over the unit of length.
    pub mfe: Option<f64>,
    /// Largest distance of its points to the answered surface, over the unit of length.
    pub hausdorff: Option<f64>,
    /// Euclidean distance of the answered from the true parameters; `null` of different types.
    pub parameters: Option<f64>,
}

impl From<recognition::Segment> for Segment {
    fn from(segment: recognition::Segment) -> Self {
        Self {
            truth: segment.number,
            kind: segment.kind.map(SurfaceType::from),
            answer: segment.answer.map(SurfaceType::from),
            mfe: segment.mfe,
            hausdorff: segment.hausdorff,
            parameters: segment.parameters,
        }
    }
}

#[wasm_bindgen]
impl Model {
    /// Sets every true primitive beside the answer of a method, or of the truth itself: lengths over a
    /// normalisation's unit. Nothing where primitives are too entangled to be matched.
    ///
    /// # Errors
    /// If there is no such submission, no truth or no such normalisation.
    pub fn segments(
        &self,
        method: Option<String>,
        normalisation: &str,
    ) -> Result<Vec<Ts<Segment>>, JsError> {
        let (truth, predicted) = (
            self.segmentation(None)?,
            self.segmentation(method.as_deref())?,
        );
        let normalisation = normalisation.parse()?;
        let cloud = &self.model.cloud;
        let found = recognition::recognise(cloud, truth, predicted, normalisation);
        let segments = found.into_iter().flatten().map(Segment::from);
        segments.map(|segment| hand_over(&segment)).collect()
    }
}

/// A true and an answered type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Answered {
    /// The true type; of a segment of none of the five nothing is counted.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// The answered type.
    pub answer: Option<SurfaceType>,
}

/// How well types are told, each the mean over types; `null` where there is no case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "UPPERCASE")]
#[tsify(missing_as_null)]
#[allow(
    missing_docs,
    reason = "each is said in `fit4cad::metrics::recognition::Rates`"
)]
pub struct Rates {
    pub ppv: Option<f64>,
    pub npv: Option<f64>,
    pub tpr: Option<f64>,
    pub tnr: Option<f64>,
    pub acc: Option<f64>,
}

/// Counts how well types are told.
///
/// # Errors
/// If there is no such type.
#[wasm_bindgen]
pub fn rates(answered: Vec<Ts<Answered>>) -> Result<Ts<Rates>, JsError> {
    let mut pairs = Vec::new();
    for each in answered {
        let Answered { kind, answer } = each.to_rust()?;
        if let Some(kind) = kind {
            let answer = answer.map(surface::SurfaceType::from);
            pairs.push((surface::SurfaceType::from(kind), answer));
        }
    }
    let found = recognition::Rates::of(&pairs);
    hand_over(&Rates {
        ppv: found.ppv,
        npv: found.npv,
        tpr: found.tpr,
        tnr: found.tnr,
        acc: found.acc,
    })
}
