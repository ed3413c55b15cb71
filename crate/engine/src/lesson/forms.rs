//! One surface in both forms.

use fit4cad::cloud::{Point, Vector};
use fit4cad::lesson::forms;
use fit4cad::surface::patch::Patch;
use fit4cad::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};
use js_sys::Float32Array;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::look::PatchMesh;
use crate::primitive::{SurfaceInfo, SurfaceType};

/// Half the side of the cube that a surface is shown in.
const HALF: f64 = 1.5;

/// A surface as a reader sets it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SurfaceSliders {
    /// Its family.
    #[serde(rename = "type")]
    pub kind: SurfaceType,
    /// Centre, apex, or a point of the plane or axis.
    pub at: [f64; 3],
    /// Angle between axis (or normal) and z, in degrees.
    pub tilt: f64,
    /// Angle of the tilted axis about z, in degrees.
    pub heading: f64,
    /// Radius, half-angle in degrees, or major radius.
    pub size: f64,
    /// Minor radius of a torus.
    pub minor: f64,
}

impl From<SurfaceSliders> for Surface {
    fn from(sliders: SurfaceSliders) -> Self {
        let [x, y, z] = sliders.at;
        let at = Point::new(x, y, z);
        let (sin, cos) = libm::sincos(sliders.tilt.to_radians());
        let (up, out) = libm::sincos(sliders.heading.to_radians());
        let axis = Vector::new(sin * out, sin * up, cos);
        match sliders.kind {
            SurfaceType::Plane => Self::Plane(Plane::new(at, axis)),
            SurfaceType::Cylinder => Self::Cylinder(Cylinder::new(at, axis, sliders.size)),
            SurfaceType::Cone => Self::Cone(Cone::new(at, axis, sliders.size.to_radians())),
            SurfaceType::Sphere => Self::Sphere(Sphere::new(at, sliders.size)),
            SurfaceType::Torus => Self::Torus(Torus::new(at, axis, sliders.size, sliders.minor)),
        }
    }
}

/// A surface in both forms, and what shows it.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct Forms {
    /// Canonical parameters.
    pub surface: SurfaceInfo,
    /// Parametric vector, in the order of the files.
    pub parametric: Vec<f64>,
    /// Implicit vector, in the order of the files.
    pub implicit: Vec<f64>,
    /// What each implicit coefficient stands before.
    pub terms: Vec<String>,
    /// Points of the surface in the cube about the origin, x y z after one another.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub points: Float32Array,
    /// The patch they cover; absent where none lies in the cube.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub patch: Option<PatchMesh>,
}

/// Both forms of a surface.
///
/// # Errors
/// If the argument is not of the declared type.
#[wasm_bindgen(js_name = surfaceForms)]
pub fn surface_forms(sliders: Ts<SurfaceSliders>) -> Result<Ts<Forms>, JsError> {
    let surface = Surface::from(sliders.to_rust()?);
    let points = forms::shown_points(&surface, HALF);
    let flat: Vec<f32> = points
        .iter()
        .flat_map(|point| [point.x as f32, point.y as f32, point.z as f32])
        .collect();
    let implicit = surface.to_implicit();
    let patch = Patch::new(&surface, &points);
    hand_over(&Forms {
        surface: SurfaceInfo::from(&surface),
        parametric: surface.to_parametric(),
        terms: forms::implicit_terms(implicit.len()),
        implicit,
        points: flat.as_slice().into(),
        patch: patch.map(|patch| PatchMesh::new(&patch, &Point::origin())),
    })
}

/// Two implicit vectors compared by both definitions of d1.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct FormComparison {
    /// The predicted vector scaled to norm 1; empty where it cannot be.
    pub predicted: Vec<f64>,
    /// The true vector scaled to norm 1; empty where it cannot be.
    pub truth: Vec<f64>,
    /// d1 by the paper's definition.
    pub definition: Option<f64>,
    /// d1 as the authors' script has it.
    pub published: Option<f64>,
    /// Places whose entries have opposite signs.
    pub opposite: Vec<u32>,
}

/// Compares a predicted implicit vector with the true one.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen(js_name = compareForms)]
pub fn compare_forms(predicted: &[f64], truth: &[f64]) -> Result<Ts<FormComparison>, JsError> {
    let compared = forms::compare(predicted, truth);
    let [predicted, truth] = compared.unit;
    hand_over(&FormComparison {
        predicted,
        truth,
        definition: compared.definition,
        published: compared.published,
        opposite: compared.opposite,
    })
}
