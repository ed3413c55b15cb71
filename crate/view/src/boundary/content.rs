//! What is seen: points, their colours, patches, the layout and the settings of the picture.

use glam::Vec3;
use wasm_bindgen::prelude::*;

use super::View;
use super::crossing::{GivenLayout, GivenPatch, GivenPointSize};
use super::plain::SurfacePatch;
use crate::clip::ClipBox;
use crate::colouring::ColourBy;
use crate::layout::{Layout, Side};
use crate::patch as scene;
use crate::scene::PointSize;

#[wasm_bindgen]
impl View {
    /// Replaces the cloud: x y z per point, relative to its centre. Labels, scalars and normals are
    /// forgotten, and the camera frames the new cloud at once. What is given here and per point below is
    /// seen as far as `proceed` has come.
    pub fn set_cloud(&mut self, coordinates: Vec<f32>) {
        self.scene.set_cloud(coordinates);
        self.flight = None;
        self.scene.camera = self.scene.fitting(&self.frame);
    }

    /// Brings so many more points, and what is said of as many, into the order in which they are drawn.
    /// Returns whether that leaves some: pieces of a cloud of millions keep nobody waiting.
    pub fn proceed(&mut self, points: usize) -> bool {
        self.scene.proceed(points)
    }

    /// How many points each side in view can draw by now.
    pub fn ready(&self) -> usize {
        let panes = self.scene.panes(&self.frame);
        let ready = panes.iter().map(|pane| self.scene.ready(pane.side));
        ready.min().unwrap_or(0)
    }

    /// Sets the normals, x y z per point.
    pub fn set_normals(&mut self, components: Vec<f32>) {
        self.scene.set_normals(components);
    }

    /// Sets a label per point on a side.
    pub fn set_labels(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        labels: Vec<u32>,
    ) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_labels(labels);
    }

    /// Sets the colours of a side's labels, r g b per label.
    pub fn set_colours(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        colours: &[u8],
    ) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_colours(colours);
    }

    /// Sets the states of a side's labels: a `LabelState` each.
    pub fn set_states(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        states: &[u8],
    ) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_states(states);
    }

    /// Sets a scalar per point on a side; NaN where a point has none.
    pub fn set_scalars(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        scalars: Vec<f32>,
    ) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_scalars(scalars);
    }

    /// Sets the colour map of a side's scalars, r g b per step.
    pub fn set_colour_map(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        colours: &[u8],
    ) {
        self.scene
            .colouring_mut(Side::from_index(side))
            .set_map(colours);
    }

    /// Colours a side by label.
    pub fn colour_by_label(&mut self, #[wasm_bindgen(unchecked_param_type = "Side")] side: usize) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Label;
    }

    /// Colours a side by its scalars, from the low to the high end of the map.
    pub fn colour_by_scalar(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        low: f32,
        high: f32,
    ) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Scalar { low, high };
    }

    /// Colours a side by normal.
    pub fn colour_by_normal(&mut self, #[wasm_bindgen(unchecked_param_type = "Side")] side: usize) {
        self.scene.colouring_mut(Side::from_index(side)).by = ColourBy::Normal;
    }

    /// Removes the patches.
    pub fn clear_patches(&mut self) {
        self.scene.patches.set(Vec::new());
    }

    /// Adds a patch of a surface.
    pub fn add_patch(&mut self, patch: &GivenPatch) {
        let patch = scene::SurfacePatch::from(SurfacePatch::from(patch));
        self.scene.patches.change(|patches| patches.push(patch));
    }

    /// Divides the canvas among the sides.
    pub fn set_layout(&mut self, layout: &GivenLayout) {
        self.scene.layout = Layout::from(layout);
    }

    /// Sets how large points are drawn.
    pub fn set_point_size(&mut self, size: &GivenPointSize) {
        self.scene.display.point_size = match PointSize::from(size) {
            PointSize::Spacing(factor) => PointSize::Spacing(factor.clamp(0.1, 20.0)),
            PointSize::Pixels(pixels) => PointSize::Pixels(pixels.clamp(0.5, 40.0)),
        };
    }

    /// Sets the strength of eye-dome lighting, 0 off, 1 usual.
    pub fn set_eye_dome(&mut self, strength: f32) {
        self.scene.display.eye_dome = strength.clamp(0.0, 10.0);
    }

    /// Hides what lies outside a box: the shares of the cloud's extent along x, y and z at which it
    /// begins, then those at which it ends; 0 at the least coordinate and 1 at the greatest.
    pub fn set_clip_box(&mut self, shares: &[f32]) {
        if let &[a, b, c, d, e, f] = shares {
            self.scene.display.clip_box = ClipBox {
                low: Vec3::new(a, b, c),
                high: Vec3::new(d, e, f),
            };
        }
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
    pub fn spacing(&mut self) -> f32 {
        self.finish();
        self.scene.cloud.get().spacing()
    }
}

impl View {
    /// Brings all that is left into order: whoever asks about the points asks about all of them.
    pub(super) fn finish(&mut self) {
        self.scene.proceed(usize::MAX);
    }
}
