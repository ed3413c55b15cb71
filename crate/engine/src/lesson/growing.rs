//! Primitive growing on a small part, step by step.

use fit4cad::cloud::{Cloud, Point};
use fit4cad::lesson::growing::{Growing, Motion, motions, split};
use js_sys::{Float32Array, Uint32Array};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;
use crate::primitive::{SurfaceInfo, SurfaceType};

/// The coarse partition at one threshold.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct PartitionInfo {
    /// η: the share of points at or below the threshold.
    pub quantile: f64,
    /// The surface variation at that share.
    pub threshold: f64,
    /// Number of points above it.
    pub sharp: u32,
    /// Region of every point, 0 the largest; 2³² − 1 for sharp ones.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub labels: Uint32Array,
    /// Steps of growth from the region's seed to every point; 2³² − 1 for sharp ones.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub steps: Uint32Array,
    /// Number of points of each region.
    pub sizes: Vec<u32>,
}

/// Slippage of a region.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct SlippageInfo {
    /// Eigenvalues, smallest first.
    pub eigenvalues: [f64; 6],
    /// ISO GPS invariance class.
    pub class: &'static str,
    /// What the slippable motions are.
    pub motions: Vec<&'static str>,
}

/// A surface that RANSAC found in a region.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct SplitInfo {
    /// Its family.
    #[serde(rename = "type")]
    pub kind: SurfaceType,
    /// The surface.
    pub surface: SurfaceInfo,
    /// Its points, ascending.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub support: Uint32Array,
}

/// Primitive growing on one model's points. Release it with `free()`.
#[derive(Debug)]
#[wasm_bindgen]
pub struct GrowingLesson {
    cloud: Cloud,
    growing: Growing,
    regions: Vec<Vec<u32>>,
}

#[wasm_bindgen]
impl GrowingLesson {
    /// Takes the surface variation of a model's points.
    #[wasm_bindgen(constructor)]
    pub fn new(model: &Model) -> GrowingLesson {
        let cloud = model.model.cloud.clone();
        Self {
            growing: Growing::new(&cloud),
            cloud,
            regions: Vec::new(),
        }
    }

    /// Surface variation of every point.
    pub fn variation(&self) -> Float32Array {
        let values = self.growing.variation().iter();
        let values: Vec<f32> = values.map(|&value| value as f32).collect();
        values.as_slice().into()
    }

    /// Grows regions below the threshold at η; at the fitter's own choice where η is 0. Regions are
    /// asked about by their place from then on.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn partition(&mut self, quantile: f64) -> Result<Ts<PartitionInfo>, JsError> {
        let partition = self.growing.partition(quantile.clamp(0.0, 1.0));
        let labels = fit4cad::fit::growing::regions::labels(self.cloud.len(), &partition.regions);
        let sizes = partition.regions.iter().map(|region| region.len() as u32);
        let sharp = partition.steps.iter().filter(|&&step| step == u32::MAX);
        let info = PartitionInfo {
            quantile: partition.threshold.quantile,
            threshold: partition.threshold.value,
            sharp: sharp.count() as u32,
            labels: labels.as_slice().into(),
            steps: partition.steps.as_slice().into(),
            sizes: sizes.collect(),
        };
        self.regions = partition.regions;
        hand_over(&info)
    }

    /// Slippage of a region; nothing where it is too small or does not exist.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn slippage(&self, region: usize) -> Result<Option<Ts<SlippageInfo>>, JsError> {
        let points = self.regions.get(region).map_or(&[][..], Vec::as_slice);
        let Some(slippage) = self.growing.slippage(&self.cloud, points) else {
            return Ok(None);
        };
        let names = self.motions(region).into_iter().map(|motion| match motion {
            Motion::Turn(..) => "turn about the axis",
            Motion::Slide(_) => "slide along the direction",
        });
        hand_over(&SlippageInfo {
            eigenvalues: slippage.eigenvalues,
            class: slippage.class.name(),
            motions: names.collect(),
        })
        .map(Some)
    }

    /// A region after one of its slippable motions, x y z per point relative to the model's centre;
    /// empty where there is no such motion. The amount is in radians of a turn, or in diagonals of
    /// the cloud.
    pub fn ghost(&self, region: usize, motion: usize, amount: f64) -> Float32Array {
        let motions = self.motions(region);
        let bounds = self.cloud.bounds();
        let moved = motions.get(motion).map(|motion| match motion {
            Motion::Turn(..) => motion.by(amount),
            Motion::Slide(_) => motion.by(amount * bounds.diagonal()),
        });
        let centre = bounds.centre();
        let flat: Vec<f32> = moved.map_or_else(Vec::new, |moved| {
            let points = self.points(region).into_iter();
            points
                .map(|point| moved * point - centre)
                .flat_map(|place| [place.x as f32, place.y as f32, place.z as f32])
                .collect()
        });
        flat.as_slice().into()
    }

    /// Splits a region by RANSAC.
    ///
    /// # Errors
    /// None in practice: nothing cancels it.
    pub fn split(&self, region: usize) -> Result<Vec<Ts<SplitInfo>>, JsError> {
        let points = self.regions.get(region).map_or(&[][..], Vec::as_slice);
        let found = split(&self.cloud, points, 1)?;
        found
            .iter()
            .map(|candidate| {
                hand_over(&SplitInfo {
                    kind: candidate.surface.kind().into(),
                    surface: SurfaceInfo::from(&candidate.surface),
                    support: candidate.support.as_slice().into(),
                })
            })
            .collect()
    }
}

impl GrowingLesson {
    fn points(&self, region: usize) -> Vec<Point> {
        let all = self.cloud.points();
        let indices = self.regions.get(region).into_iter().flatten();
        indices
            .filter_map(|&index| all.get(index as usize))
            .copied()
            .collect()
    }

    fn motions(&self, region: usize) -> Vec<Motion> {
        let points = self.regions.get(region).map_or(&[][..], Vec::as_slice);
        let slippage = self.growing.slippage(&self.cloud, points);
        slippage.map_or_else(Vec::new, |slippage| {
            motions(&slippage, &self.points(region))
        })
    }
}
