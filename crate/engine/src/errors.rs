//! How sure the parameters of surfaces are, and the noise of fits.

use fit4cad::cloud::Point;
use fit4cad::fit::least_squares::StandardErrors;
use fit4cad::fit::noise::Noise;
use fit4cad::surface::Surface;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;

/// Standard errors of the parameters of a surface, as its points show them; `null` where the surface has no
/// such parameter, or the points do not determine it. Lengths are in the units of the cloud.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct StandardErrorsInfo {
    /// Of the axis or the normal, an angle in radians.
    pub axis: Option<f64>,
    /// Of the centre or apex, or across the axis or the plane at the middle of the points.
    pub position: Option<f64>,
    /// Of a plane's offset from the origin.
    pub offset: Option<f64>,
    /// Of the radius; of a torus, the major one.
    pub radius: Option<f64>,
    /// Of a torus's minor radius.
    pub minor_radius: Option<f64>,
    /// Of a cone's half-angle, in radians.
    pub half_angle: Option<f64>,
}

impl From<StandardErrors> for StandardErrorsInfo {
    fn from(errors: StandardErrors) -> Self {
        Self {
            axis: errors.axis,
            position: errors.position,
            offset: errors.offset,
            radius: errors.radius,
            minor_radius: errors.minor_radius,
            half_angle: errors.half_angle,
        }
    }
}

impl StandardErrorsInfo {
    pub(crate) fn of(surface: &Surface, points: &[Point]) -> Self {
        StandardErrors::of(surface, points).into()
    }
}

/// The noise that a fit went by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct NoiseInfo {
    /// Standard deviation of the points off their surfaces, in the units of the cloud; 0 where none could be told.
    pub deviation: f64,
    /// How it is known: `given`, `measured`, or by the `tolerance` that was given.
    #[tsify(type = "\"given\" | \"measured\" | \"tolerance\"")]
    pub source: &'static str,
    /// Its kind, where it is known: none (`exact`), off at random (`scattered`), coordinates `rounded`, some points exact
    /// and others not (`mixed`), or points on no surface at all (`everywhere`).
    #[tsify(type = "\"exact\" | \"scattered\" | \"rounded\" | \"mixed\" | \"everywhere\" | null")]
    pub kind: Option<&'static str>,
    /// Step that coordinates were rounded to; 0 where they were not seen to be.
    pub step: f64,
}

impl From<Noise> for NoiseInfo {
    fn from(noise: Noise) -> Self {
        Self {
            deviation: noise.deviation,
            source: noise.source.name(),
            kind: noise.kind.map(|kind| kind.name()),
            step: noise.step,
        }
    }
}

#[wasm_bindgen]
impl Model {
    /// How sure the surface of each primitive of a method, or of the truth, is by its points, in the order of
    /// [`Model::primitives`].
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    #[wasm_bindgen(js_name = standardErrors)]
    pub fn standard_errors(
        &self,
        method: Option<String>,
    ) -> Result<Vec<Ts<StandardErrorsInfo>>, JsError> {
        let primitives = self.segmentation(method.as_deref())?.primitives.iter();
        let cloud = &self.model.cloud;
        primitives
            .map(|primitive| hand_over(&StandardErrors::of_primitive(cloud, primitive).into()))
            .collect()
    }

    /// The noise that the fit of a method here went by; absent where it was not fitted here.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn noise(&self, method: &str) -> Result<Option<Ts<NoiseInfo>>, JsError> {
        self.noise
            .get(method)
            .map(|&noise| hand_over(&NoiseInfo::from(noise)))
            .transpose()
    }
}
