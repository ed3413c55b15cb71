//! The files of a model as they come from JavaScript.

use std::borrow::Cow;

use fit4cad::format::{self, limits};
use js_sys::{Function, Uint8Array};
use serde::{Deserialize, Serialize};
use tsify::Tsify;
use wasm_bindgen::{JsCast, JsValue};

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
    /// `PCi_type.txt`: the type of each point.
    Types,
}

impl From<Role> for format::Role {
    fn from(role: Role) -> Self {
        match role {
            Role::Cloud => Self::Cloud,
            Role::Primitives => Self::Primitives,
            Role::Parametric => Self::Parametric,
            Role::Implicit => Self::Implicit,
            Role::Types => Self::Types,
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
            format::Role::Types => Self::Types,
        }
    }
}

/// One file of a model. Its content is asked for when its turn comes, and not at all where its size
/// is beyond the limits.
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
    /// What its indices of points count from, 0 or 1; 1 where it is absent.
    #[serde(default)]
    #[tsify(optional)]
    pub first: Option<u8>,
    /// Bytes of its content.
    pub size: f64,
    /// Gives the content; throws where it cannot be had.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "() => Uint8Array")]
    pub read: Function,
    /// Gives the bytes from one offset to before another, where the content can be had so: a long text is then never
    /// held whole. Throws where it cannot be had.
    #[serde(default = "absent", with = "serde_wasm_bindgen::preserve")]
    #[tsify(optional, type = "(from: number, to: number) => Uint8Array")]
    pub part: JsValue,
}

fn absent() -> JsValue {
    JsValue::UNDEFINED
}

impl format::Source for InputFile {
    fn path(&self) -> &str {
        &self.path
    }

    fn role(&self) -> format::Role {
        self.role.into()
    }

    fn method(&self) -> Option<&str> {
        self.method.as_deref()
    }

    fn first(&self) -> u8 {
        self.first.unwrap_or(1)
    }

    fn size(&self) -> u64 {
        self.size as u64
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        let bytes = self.read.call0(&JsValue::NULL).map_err(message)?;
        let bytes: Uint8Array = bytes.dyn_into().map_err(message)?;
        // The file may have grown since its size was taken.
        if u64::from(bytes.length()) > limits::MAX_FILE_BYTES {
            return Err("it is larger than it was said to be".to_owned());
        }
        Ok(Cow::Owned(bytes.to_vec()))
    }

    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        let part: &Function = self.part.dyn_ref()?;
        let asked = || {
            // Offsets are below 2⁵³: larger files are not read.
            let bytes = part.call2(&JsValue::NULL, &(from as f64).into(), &(to as f64).into());
            let bytes: Uint8Array = bytes.map_err(message)?.dyn_into().map_err(message)?;
            // More than was asked for would be more than there is room for.
            if u64::from(bytes.length()) > to - from {
                return Err("it is larger than it was said to be".to_owned());
            }
            Ok(Cow::Owned(bytes.to_vec()))
        };
        Some(asked())
    }
}

/// What was thrown, in words.
fn message(thrown: JsValue) -> String {
    let error = thrown.dyn_ref::<js_sys::Error>();
    let text = error.map_or_else(
        || js_sys::JsString::from(format!("{thrown:?}")),
        js_sys::Error::message,
    );
    text.into()
}
