//! The point lists of a segmentation as two flat typed arrays.

use fit4cad::model::Segmentation;
use js_sys::Uint32Array;
use serde::Serialize;
use tsify::Tsify;

/// Point lists in compressed rows: primitive i lists the points
/// `indices[offsets[i]] … indices[offsets[i + 1] - 1]`, counted from 0.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct PointLists {
    /// One more than there are primitives, the first being 0.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub offsets: Uint32Array,
    /// The points of all primitives, one list after the other.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub indices: Uint32Array,
}

impl From<&Segmentation> for PointLists {
    fn from(segmentation: &Segmentation) -> Self {
        let mut offsets = vec![0];
        let mut indices = Vec::new();
        for primitive in &segmentation.primitives {
            indices.extend_from_slice(&primitive.points);
            // The reader's limit on listed indices lies far below 2³².
            offsets.push(indices.len() as u32);
        }
        Self {
            offsets: Uint32Array::from(offsets.as_slice()),
            indices: Uint32Array::from(indices.as_slice()),
        }
    }
}
