//! A segmentation in the forms of other programs.

use fit4cad::export::{self, About, Export};
use js_sys::Uint8Array;
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;

/// A form that a segmentation can be written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct ExportInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// How names of its files end.
    pub ending: &'static str,
    /// What it is called.
    pub title: &'static str,
    /// What it holds.
    pub meaning: &'static str,
    /// Whether it is of surfaces rather than points.
    pub of_surfaces: bool,
}

impl From<Export> for ExportInfo {
    fn from(export: Export) -> Self {
        Self {
            name: export.name(),
            ending: export.ending(),
            title: export.title(),
            meaning: export.meaning(),
            of_surfaces: export.is_of_surfaces(),
        }
    }
}

#[wasm_bindgen]
impl Model {
    /// Writes the segmentation of a method, or the truth, in a form of [`ExportInfo`]. The colours are red,
    /// green and blue of points of no primitive, then of the primitives in their order, from the beginning
    /// again after the last.
    ///
    /// # Errors
    /// If there is no such form or submission, or no truth.
    pub fn export(
        &self,
        form: &str,
        method: Option<String>,
        colours: &[u8],
    ) -> Result<Uint8Array, JsError> {
        let export = Export::ALL.into_iter().find(|export| export.name() == form);
        let export = export.ok_or_else(|| {
            let names = Export::ALL.map(Export::name).join(", ");
            JsError::new(&format!("there is no form `{form}`; there are {names}"))
        })?;
        let segmentation = self.segmentation(method.as_deref())?;
        let about = About {
            model: self.model.name.clone(),
            method: method.clone().unwrap_or_else(|| "truth".to_owned()),
            fitted: self.fitted.contains(&method),
            colours: colours.as_chunks::<3>().0.to_vec(),
        };
        let bytes = export::write(export, &self.model.cloud, segmentation, &about);
        Ok(Uint8Array::from(bytes.as_slice()))
    }
}
