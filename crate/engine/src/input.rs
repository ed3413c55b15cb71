//! The files of a model as they come from JavaScript.

use fit4cad::format;
use js_sys::Uint8Array;
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// `PCi.txt`: the points.
    Cloud,
    /// `PCi_primitives.txt`: which points belong together.
    Primitives,
    /// `PCi_parametric.txt`: their surfaces in parametric form.
    Parametric,
    /// `PCi_implicit.txt`: their surfaces in implicit form.
    Implicit,
}

impl From<Role> for format::Role {
    fn from(role: Role) -> Self {
        match role {
            Role::Cloud => Self::Cloud,
            Role::Primitives => Self::Primitives,
            Role::Parametric => Self::Parametric,
            Role::Implicit => Self::Implicit,
        }
    }
}

impl From<format::Role> for Role {
    fn from(role: format::Role) -> Self {
        match role {
            format::Role::Cloud => Self::Cloud,
            format::Role::Primitives => Self::Primitives,
            format::Role::Parametric => Self::Parametric,
            format::Role::Implicit => Self::Implicit,
        }
    }
}

/// One file of a model.
#[derive(Debug, Clone, Deserialize, Tsify)]
pub struct InputFile {
    /// Path, for the diagnostics.
    pub path: String,
    /// What it holds.
    pub role: Role,
    /// The method whose result it is; absent for the cloud and the ground truth.
    #[serde(default)]
    #[tsify(optional)]
    pub method: Option<String>,
    /// The content.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8Array")]
    pub bytes: Uint8Array,
}
