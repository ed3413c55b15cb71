//! Where the files of models lie.

use fit4cad::format;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::input::Role;

/// How files are laid out in folders.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Layout {
    /// That of the public test set, a folder for each kind of file:
    /// `pointCloud_primitives_HT/PC1_primitives.txt`.
    TestSet,
    /// All of a model beside each other, and a folder for each method: `HT/PC1_primitives.txt`.
    Beside,
}

impl From<Layout> for format::Layout {
    fn from(layout: Layout) -> Self {
        match layout {
            Layout::TestSet => Self::TestSet,
            Layout::Beside => Self::Beside,
        }
    }
}

/// The path of a model's file, with `/` between folders; of the ground truth where no method is
/// given. It leads out of no folder, whatever the names are, and every file system takes it.
///
/// # Errors
/// Only if the arguments are not of the declared types.
#[wasm_bindgen(js_name = pathOf)]
pub fn path_of(
    layout: Ts<Layout>,
    model: &str,
    role: Ts<Role>,
    method: Option<String>,
) -> Result<String, JsError> {
    let (layout, role) = (layout.to_rust()?.into(), role.to_rust()?.into());
    Ok(format::path_of(layout, model, role, method.as_deref()))
}

/// A name as one of a file or folder that every file system takes.
#[wasm_bindgen(js_name = fileName)]
pub fn file_name(name: &str) -> String {
    format::file_name(name)
}
