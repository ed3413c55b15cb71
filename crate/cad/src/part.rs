//! A part read from a STEP file.

use fit4cad::format::{Layout, Role, path_of, write_cloud, write_primitives, write_surfaces};
use fit4cad::surface::Form;
use fit4cad_step::{Document, Import, Progress};
use js_sys::Function;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsError, JsValue};

use crate::options::ImportOptions;
use crate::report::ImportReport;

/// A part: its faces with their surfaces and bounds, where its assembly puts them.
#[wasm_bindgen]
pub struct Part {
    document: Document,
}

/// A text for each of the four files of a model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Tsify)]
pub struct PartFiles {
    /// `PCi.txt`.
    pub cloud: String,
    /// `PCi_primitives.txt`.
    pub primitives: String,
    /// `PCi_parametric.txt`.
    pub parametric: String,
    /// `PCi_implicit.txt`.
    pub implicit: String,
}

#[wasm_bindgen]
impl Part {
    /// Reads the bytes of a STEP file. `progress` hears what is being done and how much of it is.
    ///
    /// # Errors
    /// If it is no STEP file, is broken, or holds no face.
    pub fn read(bytes: &[u8], progress: Option<Function>) -> Result<Part, JsError> {
        let document = Document::read(bytes, &mut heard(progress))?;
        Ok(Self { document })
    }

    /// Keeps some of the bodies, by their numbers from 1 in the order of the file.
    ///
    /// # Errors
    /// If there is no body of a number; the message lists those there are.
    pub fn keep(&mut self, bodies: &[u32]) -> Result<(), JsError> {
        let numbers: Vec<usize> = bodies.iter().map(|&number| number as usize).collect();
        Ok(self.document.keep(&numbers)?)
    }

    /// Makes a model of the part: points that lie exactly on its faces, and the truth.
    ///
    /// # Errors
    /// If an option is unknown or out of its range, or no face can be used.
    pub fn sample(
        &self,
        name: &str,
        options: Ts<ImportOptions>,
        progress: Option<Function>,
    ) -> Result<Sampled, JsError> {
        let options = options.to_rust()?.known()?;
        let import = self.document.sample(name, &options, &mut heard(progress))?;
        Ok(Sampled { import })
    }
}

/// A part as a model, and what became of its faces.
#[wasm_bindgen]
pub struct Sampled {
    import: Import,
}

#[wasm_bindgen]
impl Sampled {
    /// The files of the model.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn files(&self) -> Result<Ts<PartFiles>, JsError> {
        let model = &self.import.model;
        let truth = model.truth.clone().unwrap_or_default();
        let files = PartFiles {
            cloud: write_cloud(&model.cloud),
            primitives: write_primitives(&truth, model.cloud.numbering()),
            parametric: write_surfaces(&truth, Form::Parametric),
            implicit: write_surfaces(&truth, Form::Implicit),
        };
        files.into_ts().map_err(JsError::from)
    }

    /// What the files are called, beside each other.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn paths(&self) -> Result<Ts<PartFiles>, JsError> {
        let of = |role| path_of(Layout::Beside, &self.import.model.name, role, None);
        let paths = PartFiles {
            cloud: of(Role::Cloud),
            primitives: of(Role::Primitives),
            parametric: of(Role::Parametric),
            implicit: of(Role::Implicit),
        };
        paths.into_ts().map_err(JsError::from)
    }

    /// What became of each face.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn report(&self) -> Result<Ts<ImportReport>, JsError> {
        let report = ImportReport::from(&self.import.report);
        report.into_ts().map_err(JsError::from)
    }
}

/// Passes progress on to JavaScript; what it throws is nobody's concern here.
fn heard(progress: Option<Function>) -> impl FnMut(Progress) {
    move |Progress { stage, share }| {
        if let Some(progress) = &progress {
            let _ = progress.call2(&JsValue::NULL, &stage.into(), &share.into());
        }
    }
}
