//! A submission to have something to score.

use fit4cad::sample;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;

/// Name of the submission.
const METHOD: &str = "Imperfect";

#[wasm_bindgen]
impl Model {
    /// Adds a submission that is wrong on purpose, in ways that are common, and gives its name. The
    /// same model and seed give the same submission; a model without truth gets an empty one.
    pub fn imperfect(&mut self, seed: u32) -> String {
        let segmentation = sample::imperfect(&self.model, u64::from(seed));
        self.model.submit(METHOD, segmentation);
        METHOD.to_owned()
    }
}
