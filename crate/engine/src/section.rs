//! A cross-section of a model: the points near a plane across an axis, and the curves in which the
//! surfaces of a segmentation meet it.

use fit4cad::cloud::Point;
use fit4cad::model::Primitive;
use fit4cad::surface::section::{CuttingPlane, Meeting, trace};
use js_sys::{Float32Array, Uint32Array};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;

/// What the plane meets of one primitive.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct CurveInfo {
    /// Its place, counted from 0, in [`Model::primitives`].
    pub place: u32,
    /// What its whole surface and the plane meet in, in words.
    pub meeting: String,
    /// Right and up per place on the curve, relative to the middle of the section.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub positions: Float32Array,
    /// `chains[i]..chains[i + 1]` bounds the places that hang together.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub chains: Uint32Array,
}

/// A cross-section, seen along the axis it is across: y and z, x and z, or x and y.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct SectionInfo {
    /// The coordinate of the plane along its axis.
    pub at: f64,
    /// How thick the layer is whose points are shown.
    pub thickness: f64,
    /// The middle of the cloud to the right and upwards.
    pub middle: [f64; 2],
    /// The extent of the cloud to the right and upwards.
    pub size: [f64; 2],
    /// Indices, ascending, of the points near the plane.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub points: Uint32Array,
    /// Right and up of each of them, relative to the middle.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub positions: Float32Array,
    /// The curves of those primitives that the plane meets where their points are.
    pub curves: Vec<CurveInfo>,
}

#[wasm_bindgen]
impl Model {
    /// The cross-section across an axis (0, 1 or 2) at a share of the cloud's extent along it, 0 at
    /// its least coordinate and 1 at its greatest. The thickness of the layer of points is a share of
    /// the diagonal of the cloud's box. With the surfaces of a submission, of the truth where no
    /// method is given. Nothing where there are no points.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn section(
        &self,
        axis: usize,
        share: f64,
        thickness: f64,
        method: Option<String>,
    ) -> Result<Option<Ts<SectionInfo>>, JsError> {
        let primitives = &self.segmentation(method.as_deref())?.primitives;
        let cloud = &self.model.cloud;
        if cloud.is_empty() {
            return Ok(None);
        }
        let (bounds, axis) = (cloud.bounds(), axis.min(2));
        let (least, size) = (bounds.min[axis], bounds.size());
        let at = least + size[axis] * share.clamp(0.0, 1.0);
        let plane = CuttingPlane::across(axis, at);
        let middle = plane.flat(&bounds.centre());
        let relative = |point: &Point| {
            let [right, up] = plane.flat(point);
            [(right - middle[0]) as f32, (up - middle[1]) as f32]
        };
        let thickness = thickness.max(0.0) * bounds.diagonal();
        let near: Vec<u32> = plane.near(cloud.points(), thickness).collect();
        let listed = near.iter();
        let flat: Vec<f32> = listed
            .filter_map(|&index| cloud.points().get(index as usize))
            .flat_map(relative)
            .collect();
        let curves = (0_u32..)
            .zip(primitives)
            .filter_map(|(place, primitive)| self.curve(place, primitive, &plane, relative));
        let info = SectionInfo {
            at,
            thickness,
            middle,
            size: [size.dot(&plane.right), size.dot(&plane.up)],
            points: near.as_slice().into(),
            positions: flat.as_slice().into(),
            curves: curves.collect(),
        };
        hand_over(&info).map(Some)
    }
}

impl Model {
    fn curve(
        &self,
        place: u32,
        primitive: &Primitive,
        plane: &CuttingPlane,
        relative: impl Fn(&Point) -> [f32; 2],
    ) -> Option<CurveInfo> {
        let surface = primitive.surface.as_ref()?;
        let cloud = self.model.cloud.points();
        let listed = primitive.points.iter();
        let points: Vec<Point> = listed
            .filter_map(|&index| cloud.get(index as usize).copied())
            .collect();
        let chains = trace(surface, &points, plane);
        if chains.is_empty() {
            return None;
        }
        let positions: Vec<f32> = chains.iter().flatten().flat_map(relative).collect();
        let mut starts = vec![0_u32];
        let mut count = 0;
        for chain in &chains {
            count += chain.len() as u32;
            starts.push(count);
        }
        Some(CurveInfo {
            place,
            meeting: Meeting::of(surface, plane).to_string(),
            positions: positions.as_slice().into(),
            chains: starts.as_slice().into(),
        })
    }
}
