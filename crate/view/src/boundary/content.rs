//! What is seen: points, their colours, patches, the layout and the settings of the picture.

use glam::Vec3;
use wasm_bindgen::prelude::*;

use super::View;
use crate::colouring::ColourBy;
use crate::layout::{Layout, Side};
use crate::patch::SurfacePatch;
use crate::scene::PointSize;

#[wasm_bindgen]
impl View {
    /// Replaces the cloud: x y z per point, relative to its centre. Labels, scalars and normals are
    /// forgotten, and the camera frames the new cloud at once.
    pub fn set_cloud(&mut self, coordinates: &[f32]) {
        self.scene.set_cloud(coordinates);
        self.flight = None;
        self.scene.camera = self.scene.fitting(&self.frame);
    }

    /// Sets the normals, x y z per point.
    pub fn set_normals(&mut self, components: &[f32]) {
        self.scene.set_normals(components);
    }

    /// Sets a label per point on a side.
    pub fn set_labels(&mut self, side: usize, labels: &[u32]) {
        self.scene.set_labels(Side::from_index(side), labels);
    }

    /// Sets the colours of a side's labels, r g b per label.
    pub fn set_colours(&mut self, side: usize, colours: &[u8]) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_colours(colours);
    }

    /// Sets the states of a side's labels: 0 hidden, 1 faded, 2 shown, 3 highlighted.
    pub fn set_states(&mut self, side: usize, states: &[u8]) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_states(states);
    }

    /// Sets a scalar per point on a side; NaN where a point has none.
    pub fn set_scalars(&mut self, side: usize, scalars: &[f32]) {
        self.scene.set_scalars(Side::from_index(side), scalars);
    }

    /// Sets the colour map of a side's scalars, r g b per step.
    pub fn set_colour_map(&mut self, side: usize, colours: &[u8]) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_map(colours);
    }

    /// Colours a side by label.
    pub fn colour_by_label(&mut self, side: usize) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Label;
    }

    /// Colours a side by its scalars, from the low to the high end of the map.
    pub fn colour_by_scalar(&mut self, side: usize, low: f32, high: f32) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Scalar { low, high };
    }

    /// Colours a side by normal.
    pub fn colour_by_normal(&mut self, side: usize) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Normal;
    }

    /// Removes the patches.
    pub fn clear_patches(&mut self) {
        self.scene.patches.set(Vec::new());
    }

    /// Adds a patch of a surface on a side: colour r g b, x y z of each vertex and of its normal,
    /// three indices a triangle, six coordinates a line and what it is (0 rim, 1 axis, 2 radius,
    /// 3 centre).
    #[allow(clippy::too_many_arguments)]
    pub fn add_patch(
        &mut self,
        side: usize,
        colour: &[u8],
        positions: &[f32],
        normals: &[f32],
        triangles: &[u32],
        lines: &[f32],
        marks: &[u8],
    ) {
        let colour = colour.try_into().unwrap_or([128; 3]);
        let side = Side::from_index(side);
        let patch = SurfacePatch::new(side, colour, positions, normals, triangles);
        self.scene
            .patches
            .change(|patches| patches.push(patch.with_lines(lines, marks)));
    }

    /// Shows one side alone.
    pub fn show_single(&mut self, side: usize) {
        self.scene.layout = Layout::Single(Side::from_index(side));
    }

    /// Shows both sides beside each other.
    pub fn show_split(&mut self) {
        self.scene.layout = Layout::Split;
    }

    /// Shows both sides in one place with a border at a share of the width.
    pub fn show_wipe(&mut self, at: f32) {
        self.scene.layout = Layout::Wipe(if at.is_nan() { 0.5 } else { at });
    }

    /// Draws points with a multiple of the cloud's spacing as diameter.
    pub fn size_by_spacing(&mut self, factor: f32) {
        self.scene.display.point_size = PointSize::Spacing(factor.clamp(0.1, 20.0));
    }

    /// Draws points with a diameter in pixels of the page.
    pub fn size_in_pixels(&mut self, pixels: f32) {
        self.scene.display.point_size = PointSize::Pixels(pixels.clamp(0.5, 40.0));
    }

    /// Sets the strength of eye-dome lighting, 0 off, 1 usual.
    pub fn set_eye_dome(&mut self, strength: f32) {
        self.scene.display.eye_dome = strength.clamp(0.0, 10.0);
    }

    /// Shows or hides the directions of the axes in the corner.
    pub fn set_gizmo(&mut self, shown: bool) {
        self.scene.display.gizmo = shown;
    }

    /// Sets the colour of the background and of what stands out from it (0 to 1 per channel).
    pub fn set_theme(&mut self, background: &[f32], ink: &[f32]) {
        if let (&[r, g, b], &[x, y, z]) = (background, ink) {
            self.scene.display.background = Vec3::new(r, g, b);
            self.scene.display.ink = Vec3::new(x, y, z);
        }
    }

    /// Typical distance of neighbouring points, in the cloud's units.
    pub fn spacing(&self) -> f32 {
        self.scene.cloud.get().spacing()
    }
}
