//! Clouds and segments that are one primitive each.

use fit4cad::cloud::Point;
use fit4cad::fit::single::{Recognised, Verdict, recognise};
use fit4cad::format::write_answer;
use fit4cad::model::{Primitive, Segmentation};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::errors::StandardErrorsInfo;
use crate::hand_over;
use crate::model::Model;
use crate::primitive::{SurfaceInfo, SurfaceType};

/// A surface and how far the points are from it, in the units of the cloud.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct VerdictInfo {
    /// Its type.
    #[serde(rename = "type")]
    pub kind: SurfaceType,
    /// The surface.
    pub surface: SurfaceInfo,
    /// How sure it is.
    pub standard_errors: StandardErrorsInfo,
    /// Mean distance.
    pub mean: f64,
    /// Root mean square distance.
    pub rms: f64,
    /// Largest distance.
    pub largest: f64,
}

impl VerdictInfo {
    fn of(verdict: &Verdict, points: &[Point]) -> Self {
        Self {
            standard_errors: StandardErrorsInfo::of(&verdict.surface, points),
            kind: verdict.surface.kind().into(),
            surface: SurfaceInfo::from(&verdict.surface),
            mean: verdict.mean,
            rms: verdict.rms,
            largest: verdict.largest,
        }
    }
}

/// What a group of points is.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SingleInfo {
    /// Number of the segment; 1 for the whole cloud.
    pub number: u32,
    /// How many points it has.
    pub points: u32,
    /// The best surface.
    pub best: VerdictInfo,
    /// The best of another type.
    pub runner_up: VerdictInfo,
    /// How many times as far the points typically are from the runner-up, parameters paid for; at
    /// least 1.
    pub margin: f64,
    /// The answer column of SHREC 2022.
    pub answer: String,
}

/// What came of it.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Singles {
    /// Name of the submission.
    pub method: String,
    /// One for each segment, or for the whole cloud.
    pub segments: Vec<SingleInfo>,
}

#[wasm_bindgen]
impl Model {
    /// Takes each segment of the truth, or the whole cloud where there is no truth, for one primitive, and
    /// keeps them as a submission. There is an answer for each that has points.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    #[wasm_bindgen(js_name = fitSingle)]
    pub fn fit_single(&mut self) -> Result<Ts<Singles>, JsError> {
        let recognised = recognise(&self.model.cloud, self.model.truth.as_ref());
        let (mut segments, mut segmentation) = (Vec::new(), Segmentation::default());
        for Recognised {
            number,
            points,
            single,
        } in recognised
        {
            let second = single.others.first().unwrap_or(&single.best);
            let all = self.model.cloud.points();
            let own = points.iter();
            let own: Vec<Point> = own
                .filter_map(|&index| all.get(index as usize).copied())
                .collect();
            segments.push(SingleInfo {
                number,
                points: points.len() as u32,
                best: VerdictInfo::of(&single.best, &own),
                runner_up: VerdictInfo::of(second, &own),
                margin: single.margin,
                answer: write_answer(&single.best.surface),
            });
            let primitive = Primitive::on(single.best.surface, number, points);
            segmentation.primitives.push(primitive);
        }
        let method = self.free_name("SINGLE");
        self.model.submit(&method, segmentation);
        hand_over(&Singles { method, segments })
    }
}
