//! A prediction tampered with, as every protocol scores it.

use fit4cad::lesson::painting;
use fit4cad::metrics::{field_report, geometry};
use js_sys::Uint32Array;
use tsify::Ts;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::field::FieldReport;
use crate::hand_over;
use crate::model::Model;

#[wasm_bindgen]
impl Model {
    /// What the field reports of a prediction that lists these points, one list per predicted
    /// primitive. The surfaces are those of the true primitives overlapped most.
    ///
    /// # Errors
    /// If the model has no truth.
    #[wasm_bindgen(js_name = fieldOf)]
    pub fn field_of(&self, lists: Vec<Uint32Array>) -> Result<Ts<FieldReport>, JsError> {
        let lists: Vec<Vec<u32>> = lists.iter().map(Uint32Array::to_vec).collect();
        let predicted = painting::painted(&self.model, &lists, 0.0);
        let truth = self.segmentation(None)?;
        let scale = geometry::Scale::default();
        let report = field_report(&self.model.cloud, truth, &predicted, scale);
        hand_over(&FieldReport::new(&self.model.name, "tampered", &report))
    }
}
