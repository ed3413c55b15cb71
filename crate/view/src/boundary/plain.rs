//! Plain objects that only the boundary knows.

use tsify::Tsify;

use crate::layout::Side;
use crate::patch as scene;

/// The point found under the cursor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Tsify)]
pub struct Hit {
    /// The side that is shown there.
    pub side: Side,
    /// Its place among the points as they were given.
    pub index: u32,
}

/// What a look under the cursor found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Tsify)]
pub struct Picked {
    /// The nearest point; absent where there is none within reach.
    #[tsify(optional)]
    pub hit: Option<Hit>,
}

/// The part of a fitted surface that its points cover, relative to the cloud's centre.
#[derive(Debug, Clone, PartialEq, Tsify)]
pub struct SurfacePatch {
    /// Where it is shown.
    pub side: Side,
    /// Red, green and blue, 0 to 255.
    #[tsify(type = "readonly [number, number, number]")]
    pub colour: [u8; 3],
    /// x y z per vertex.
    #[tsify(type = "Float32Array")]
    pub positions: Vec<f32>,
    /// Unit normal x y z per vertex.
    #[tsify(type = "Float32Array")]
    pub normals: Vec<f32>,
    /// Three vertices per triangle.
    #[tsify(type = "Uint32Array")]
    pub triangles: Vec<u32>,
    /// Start and end, x y z each, per line.
    #[tsify(type = "Float32Array")]
    pub lines: Vec<f32>,
    /// A `PatchMark` per line.
    #[tsify(type = "Uint8Array")]
    pub marks: Vec<u8>,
}

impl From<SurfacePatch> for scene::SurfacePatch {
    fn from(patch: SurfacePatch) -> Self {
        let (positions, normals) = (&patch.positions, &patch.normals);
        Self::new(
            patch.side,
            patch.colour,
            positions,
            normals,
            &patch.triangles,
        )
        .with_lines(&patch.lines, &patch.marks)
    }
}
