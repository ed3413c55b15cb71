//! What a view draws besides points and labels: the patches of fitted surfaces.

use fit4cad::cloud::{Point, Vector};
use fit4cad::surface::patch::Patch;
use js_sys::{Float32Array, Uint8Array, Uint32Array};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;

/// The part of a surface that its points cover, relative to [`Model::centre`].
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct PatchMesh {
    /// x y z per vertex.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub positions: Float32Array,
    /// Unit normal x y z per vertex, to the outer side.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub normals: Float32Array,
    /// Three vertices per triangle.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub triangles: Uint32Array,
    /// Start and end, x y z each, per line.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array")]
    pub lines: Float32Array,
    /// What each line is: the number of a [`Mark`](fit4cad::surface::patch::Mark).
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8Array")]
    pub marks: Uint8Array,
}

impl PatchMesh {
    pub(crate) fn new(patch: &Patch, centre: &Point) -> Self {
        let relative = |point: &Point| flat(&(point - centre));
        let positions: Vec<f32> = patch.vertices.iter().flat_map(relative).collect();
        let normals: Vec<f32> = patch.normals.iter().flat_map(|n| flat(n)).collect();
        let ends = patch.lines.iter().flat_map(|(_, ends)| ends);
        let lines: Vec<f32> = ends.flat_map(relative).collect();
        let marks = patch.lines.iter().map(|(mark, _)| *mark as u8);
        Self {
            positions: positions.as_slice().into(),
            normals: normals.as_slice().into(),
            triangles: patch.triangles.as_flattened().into(),
            lines: lines.as_slice().into(),
            marks: marks.collect::<Vec<u8>>().as_slice().into(),
        }
    }
}

fn flat(vector: &Vector) -> [f32; 3] {
    [vector.x as f32, vector.y as f32, vector.z as f32]
}

#[wasm_bindgen]
impl Model {
    /// The patch of a primitive's surface that its points cover. The primitive is given by its
    /// place, counted from 0, in [`Model::primitives`]. Nothing where it has no surface or no
    /// points.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn patch(
        &self,
        place: usize,
        method: Option<String>,
    ) -> Result<Option<Ts<PatchMesh>>, JsError> {
        let segmentation = self.segmentation(method.as_deref())?;
        let cloud = &self.model.cloud;
        let patch = segmentation.primitives.get(place).and_then(|primitive| {
            let points = primitive.points.iter();
            let points = points.filter_map(|&index| cloud.points().get(index as usize).copied());
            Patch::new(primitive.surface.as_ref()?, &points.collect::<Vec<Point>>())
        });
        let centre = cloud.bounds().centre();
        patch
            .map(|patch| hand_over(&PatchMesh::new(&patch, &centre)))
            .transpose()
    }
}
