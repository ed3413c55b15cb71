//! Primitives back to CAD.

use fit4cad::format::{Readers, Role, SourceFile, read_files};
use fit4cad::surface::SurfaceType;
use fit4cad_step::write_step;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::part::PartFiles;

/// A STEP file, and what is not in it.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct StepText {
    /// The file, of AP214.
    pub text: String,
    /// How many primitives were left out: without a surface, or with too few points for an outline.
    pub left_out: usize,
}

/// Writes the primitives of a model's files as STEP: each a face on its surface, trimmed by the outline
/// of its points, named and coloured. `colours` are red, green and blue, 0 to 255, of each type in the
/// order of the declared types.
///
/// # Errors
/// If there are not three numbers for each type.
#[wasm_bindgen(js_name = writeStep)]
pub fn write(name: &str, files: Ts<PartFiles>, colours: &[u8]) -> Result<Ts<StepText>, JsError> {
    let files = files.to_rust()?;
    let (colours, rest) = colours.as_chunks::<3>();
    if colours.len() != SurfaceType::ALL.len() || !rest.is_empty() {
        return Err(JsError::new("a colour is needed for each type"));
    }
    let sources = [
        (Role::Cloud, &files.cloud),
        (Role::Primitives, &files.primitives),
        (Role::Parametric, &files.parametric),
        (Role::Implicit, &files.implicit),
    ]
    .map(|(role, text)| SourceFile {
        path: role.name(),
        role,
        method: None,
        bytes: text.as_bytes(),
    });
    let model = read_files(name, &sources, &Readers::OWN).model;
    let truth = model.truth.unwrap_or_default();
    let colour = |kind: SurfaceType| {
        let places = SurfaceType::ALL.iter().zip(colours);
        let own = places.into_iter().find(|(known, _)| **known == kind);
        own.map_or([0.5; 3], |(_, colour)| {
            colour.map(|it| f64::from(it) / 255.0)
        })
    };
    let (text, left_out) = write_step(name, &model.cloud, &truth, colour);
    StepText { text, left_out }.into_ts().map_err(JsError::from)
}
