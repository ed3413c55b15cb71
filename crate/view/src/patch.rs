//! Patches of fitted surfaces as the page gives them: triangles, and lines with their meaning.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::layout::Side;

/// What a line of a patch stands for. The numbers are those of the engine's patches.
#[wasm_bindgen(js_name = PatchMark)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// Border of the patch.
    Rim = 0,
    /// Axis.
    Axis = 1,
    /// Radius.
    Radius = 2,
    /// Apex or centre: a dot.
    Centre = 3,
}

impl Mark {
    /// The mark of that number; unknown numbers are rims.
    pub fn from_number(number: u8) -> Self {
        let marks = [Self::Axis, Self::Radius, Self::Centre].into_iter();
        let mut marks = marks.filter(|&mark| mark as u8 == number);
        marks.next().unwrap_or(Self::Rim)
    }
}

/// A patch as the page gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfacePatch {
    /// Where it is shown.
    pub side: Side,
    /// Its colour, red green blue.
    pub colour: [u8; 3],
    /// Position and unit normal of each vertex.
    pub vertices: Vec<[f32; 6]>,
    /// Corners of the triangles.
    pub triangles: Vec<u32>,
    /// Start and end of each line.
    pub lines: Vec<(Mark, [f32; 6])>,
}

impl SurfacePatch {
    /// A patch from flat arrays. Triangles with corners that do not exist are left out.
    pub fn new(
        side: Side,
        colour: [u8; 3],
        positions: &[f32],
        normals: &[f32],
        triangles: &[u32],
    ) -> Self {
        let vertices: Vec<[f32; 6]> = positions
            .as_chunks::<3>()
            .0
            .iter()
            .zip(normals.as_chunks::<3>().0)
            .map(|(&[x, y, z], &[a, b, c])| [x, y, z, a, b, c])
            .collect();
        let exists = |corner: &u32| (*corner as usize) < vertices.len();
        let whole = triangles
            .as_chunks::<3>()
            .0
            .iter()
            .filter(|corners| corners.iter().all(exists));
        Self {
            side,
            colour,
            triangles: whole.flatten().copied().collect(),
            vertices,
            lines: Vec::new(),
        }
    }

    /// The same with lines: start and end x y z, and the number of a mark, each.
    pub fn with_lines(mut self, ends: &[f32], marks: &[u8]) -> Self {
        let (ends, _) = ends.as_chunks::<6>();
        let marks = marks.iter().map(|&mark| Mark::from_number(mark));
        self.lines = marks.zip(ends.iter().copied()).collect();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_with_missing_corners_are_left_out() {
        let positions = [0.0; 9];
        let patch = SurfacePatch::new(
            Side::First,
            [1, 2, 3],
            &positions,
            &positions,
            &[0, 1, 2, 1, 2, 3],
        );
        assert_eq!(patch.triangles, [0, 1, 2]);
        assert_eq!(patch.vertices.len(), 3);
    }

    #[test]
    fn marks_have_the_numbers_that_the_engine_gives_them() {
        use fit4cad::surface::patch::Mark as Given;
        let pairs = [
            (Given::Rim, Mark::Rim),
            (Given::Axis, Mark::Axis),
            (Given::Radius, Mark::Radius),
            (Given::Centre, Mark::Centre),
        ];
        for (given, mark) in pairs {
            assert_eq!(Mark::from_number(given as u8), mark);
        }
    }

    #[test]
    fn lines_without_a_mark_are_left_out() {
        let patch =
            SurfacePatch::new(Side::First, [0; 3], &[], &[], &[]).with_lines(&[0.0; 12], &[3]);
        assert_eq!(patch.lines, [(Mark::Centre, [0.0; 6])]);
    }
}
