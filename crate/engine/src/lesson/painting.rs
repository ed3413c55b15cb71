//! Predictions painted on a small part.

use fit4cad::lesson::painting;
use fit4cad::metrics;
use js_sys::Uint32Array;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;
use crate::report::{Protocol, Report};

/// Name of the painted submission.
const METHOD: &str = "Painted";

/// Points counted for one true primitive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct CountsInfo {
    /// Points of the primitive that its match lists.
    pub tp: u32,
    /// Points of the match that are not the primitive's.
    pub fp: u32,
    /// Points of the primitive that its match lacks.
    #[serde(rename = "fn")]
    pub fn_: u32,
    /// Points of neither.
    pub tn: u32,
}

/// The score of a painted prediction.
#[derive(Debug, Clone, Serialize, Tsify)]
#[tsify(hashmap_as_object)]
pub struct PaintedScore {
    /// As for any other submission.
    pub report: Report,
    /// One per true primitive, in their order.
    pub counts: Vec<CountsInfo>,
}

#[wasm_bindgen]
impl Model {
    /// A niche of two primitives, wall and floor, and a third of `rest` points where that is not 0.
    pub fn niche(rest: u32) -> Model {
        Model::of(painting::niche(rest.min(200_000)))
    }

    /// Replaces the painted prediction, one list of point indices per predicted primitive, and
    /// scores it by definition. The surfaces are those of the true primitives overlapped most, moved
    /// by `shift`.
    ///
    /// # Errors
    /// If the model has no truth.
    pub fn paint(
        &mut self,
        lists: Vec<Uint32Array>,
        shift: f64,
    ) -> Result<Ts<PaintedScore>, JsError> {
        let lists: Vec<Vec<u32>> = lists.iter().map(Uint32Array::to_vec).collect();
        let segmentation = painting::painted(&self.model, &lists, shift);
        self.model.submit(METHOD, segmentation);
        let (truth, painted) = (self.segmentation(None)?, self.segmentation(Some(METHOD))?);
        let protocol = metrics::Protocol::Definition;
        let report = metrics::evaluate(&self.model.cloud, truth, painted, protocol);
        let counts = report.primitives.iter().map(|row| CountsInfo {
            tp: row.counts.true_positives as u32,
            fp: row.counts.false_positives as u32,
            fn_: row.counts.false_negatives as u32,
            tn: row.counts.true_negatives as u32,
        });
        let counts = counts.collect();
        let name = &self.model.name;
        let report = Report::new(name, METHOD, Protocol::Definition, &report, Vec::new());
        hand_over(&PaintedScore { report, counts })
    }
}
