//! How the few plain objects cross, field by field: a general deserialiser would be a third of the
//! renderer. Their TypeScript types are generated from the Rust ones.

use js_sys::{Array, Object, Reflect};
use wasm_bindgen::prelude::*;

use super::plain::{Hit, Picked, SurfacePatch};
use crate::camera::{CameraState, Projection};
use crate::lasso::Lasso;
use crate::layout::{Layout, Side};
use crate::scene::PointSize;

#[wasm_bindgen]
extern "C" {
    /// A [`Layout`] as it comes.
    #[wasm_bindgen(typescript_type = "Layout")]
    pub type GivenLayout;
    #[wasm_bindgen(method, getter, js_name = kind)]
    fn kind(this: &GivenLayout) -> String;
    #[wasm_bindgen(method, getter, js_name = side)]
    fn side(this: &GivenLayout) -> Option<f64>;
    #[wasm_bindgen(method, getter, js_name = at)]
    fn at(this: &GivenLayout) -> Option<f32>;

    /// A [`PointSize`] as it comes.
    #[wasm_bindgen(typescript_type = "PointSize")]
    pub type GivenPointSize;
    #[wasm_bindgen(method, getter, js_name = unit)]
    fn unit(this: &GivenPointSize) -> String;
    #[wasm_bindgen(method, getter, js_name = value)]
    fn value(this: &GivenPointSize) -> f32;

    /// A [`CameraState`] as it comes.
    #[wasm_bindgen(typescript_type = "CameraState")]
    pub type GivenCamera;
    #[wasm_bindgen(method, getter, js_name = target)]
    fn target(this: &GivenCamera) -> Vec<f32>;
    #[wasm_bindgen(method, getter, js_name = rotation)]
    fn rotation(this: &GivenCamera) -> Vec<f32>;
    #[wasm_bindgen(method, getter, js_name = height)]
    fn height(this: &GivenCamera) -> f32;
    #[wasm_bindgen(method, getter, js_name = projection)]
    fn projection(this: &GivenCamera) -> String;

    /// A [`SurfacePatch`] as it comes.
    #[wasm_bindgen(typescript_type = "SurfacePatch")]
    pub type GivenPatch;
    #[wasm_bindgen(method, getter, js_name = side)]
    fn side_of(this: &GivenPatch) -> f64;
    #[wasm_bindgen(method, getter, js_name = colour)]
    fn colour(this: &GivenPatch) -> Vec<u8>;
    #[wasm_bindgen(method, getter, js_name = positions)]
    fn positions(this: &GivenPatch) -> Vec<f32>;
    #[wasm_bindgen(method, getter, js_name = normals)]
    fn normals(this: &GivenPatch) -> Vec<f32>;
    #[wasm_bindgen(method, getter, js_name = triangles)]
    fn triangles(this: &GivenPatch) -> Vec<u32>;
    #[wasm_bindgen(method, getter, js_name = lines)]
    fn lines(this: &GivenPatch) -> Vec<f32>;
    #[wasm_bindgen(method, getter, js_name = marks)]
    fn marks(this: &GivenPatch) -> Vec<u8>;
}

impl From<&GivenLayout> for Layout {
    fn from(given: &GivenLayout) -> Self {
        match given.kind().as_str() {
            "single" => Self::Single {
                side: Side::from_index(given.side().unwrap_or(0.0) as usize),
            },
            "wipe" => Self::Wipe {
                at: given.at().filter(|at| !at.is_nan()).unwrap_or(0.5),
            },
            _ => Self::Split,
        }
    }
}

impl From<&GivenPointSize> for PointSize {
    fn from(given: &GivenPointSize) -> Self {
        match given.unit().as_str() {
            "pixels" => Self::Pixels(given.value()),
            _ => Self::Spacing(given.value()),
        }
    }
}

impl Projection {
    /// The name by which JavaScript knows it.
    const fn name(self) -> &'static str {
        match self {
            Self::Perspective => "perspective",
            Self::Orthographic => "orthographic",
        }
    }

    /// The projection of that name; perspective for any other.
    pub(super) fn named(name: &str) -> Self {
        if name == Self::Orthographic.name() {
            Self::Orthographic
        } else {
            Self::Perspective
        }
    }
}

impl From<&GivenCamera> for CameraState {
    /// Lists of another length than they have become numbers that make no camera.
    fn from(given: &GivenCamera) -> Self {
        Self {
            target: given.target().try_into().unwrap_or([f32::NAN; 3]),
            rotation: given.rotation().try_into().unwrap_or([f32::NAN; 4]),
            height: given.height(),
            projection: Projection::named(&given.projection()),
        }
    }
}

impl From<&GivenPatch> for SurfacePatch {
    fn from(given: &GivenPatch) -> Self {
        Self {
            side: Side::from_index(given.side_of() as usize),
            colour: given.colour().try_into().unwrap_or([128; 3]),
            positions: given.positions(),
            normals: given.normals(),
            triangles: given.triangles(),
            lines: given.lines(),
            marks: given.marks(),
        }
    }
}

/// A plain object with these properties.
pub(super) fn object(properties: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in properties {
        // Nothing but a frozen object refuses a property.
        let _ = Reflect::set(&object, &JsValue::from_str(key), value);
    }
    object.into()
}

fn list(numbers: &[f32]) -> JsValue {
    let numbers = numbers.iter().map(|&number| JsValue::from(number));
    numbers.collect::<Array>().into()
}

impl From<&CameraState> for JsValue {
    fn from(state: &CameraState) -> Self {
        object(&[
            ("target", list(&state.target)),
            ("rotation", list(&state.rotation)),
            ("height", state.height.into()),
            ("projection", state.projection.name().into()),
        ])
    }
}

impl From<&Lasso> for JsValue {
    fn from(lasso: &Lasso) -> Self {
        let corners = lasso.corners.iter().map(|corner| list(corner));
        object(&[
            ("target", list(&lasso.target)),
            ("rotation", list(&lasso.rotation)),
            ("eye", lasso.eye.into()),
            ("depth", lasso.depth.into()),
            ("corners", corners.collect::<Array>().into()),
        ])
    }
}

impl From<&Picked> for JsValue {
    fn from(picked: &Picked) -> Self {
        let hit = picked.hit.map(|Hit { side, index }| {
            let side = side.index() as u32;
            (
                "hit",
                object(&[("side", side.into()), ("index", index.into())]),
            )
        });
        object(hit.as_slice())
    }
}
