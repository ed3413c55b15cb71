//! Which way the points of a model face: what a view shades them by.

use fit4cad::cloud::normals::estimate_normals;
use js_sys::Float32Array;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;

/// How many neighbours say which way the surface faces: enough to average rounded coordinates, few
/// enough to stay on one side of an edge.
const NEIGHBOURS: usize = 12;

#[wasm_bindgen]
impl Model {
    /// Unit normals of the points, x y z after one another, estimated from each point's
    /// neighbours. Their sign means nothing. O(n log n).
    pub fn normals(&self) -> Float32Array {
        let normals = estimate_normals(self.model.cloud.points(), NEIGHBOURS);
        let components: Vec<f32> = normals
            .iter()
            .flat_map(|normal| [normal.x as f32, normal.y as f32, normal.z as f32])
            .collect();
        Float32Array::from(components.as_slice())
    }
}
