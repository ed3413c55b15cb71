//! All that is to be seen, without a word of WebGL: what the graphics card holds can be lost and
//! made again from here.

use glam::{Vec3, Vec4};
use tsify::Tsify;

use crate::camera::{Camera, Lens};
use crate::clip::{Clip, ClipBox};
use crate::cloud::{Bounds, Cloud};
use crate::colouring::{Colouring, Revised};
use crate::layout::{Layout, Pane, Panes, Side};
use crate::patch::SurfacePatch;
use crate::sight::{PointScale, Sight};

/// How large points are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Tsify)]
#[serde(tag = "unit", content = "value", rename_all = "lowercase")]
pub enum PointSize {
    /// A multiple of the cloud's spacing: nearer points are larger and surfaces stay closed.
    Spacing(f32),
    /// Pixels (of the page, not of the device), the same everywhere.
    Pixels(f32),
}

/// Settings of the picture.
#[derive(Debug, Clone, Copy)]
pub struct Display {
    /// Size of points.
    pub point_size: PointSize,
    /// Strength of eye-dome lighting; 0 switches it off.
    pub eye_dome: f32,
    /// Colour behind everything.
    pub background: Vec3,
    /// Colour of outlines, axes and marks: what stands out from the background.
    pub ink: Vec3,
    /// Whether the directions of the axes are shown in a corner.
    pub gizmo: bool,
    /// The box outside of which nothing is shown.
    pub clip_box: ClipBox,
}

impl Default for Display {
    fn default() -> Self {
        Self {
            point_size: PointSize::Spacing(1.6),
            eye_dome: 1.0,
            background: Vec3::ONE,
            ink: Vec3::ZERO,
            gizmo: true,
            clip_box: ClipBox::default(),
        }
    }
}

/// The scene.
#[derive(Debug, Default)]
pub struct Scene {
    /// The points.
    pub cloud: Revised<Cloud>,
    /// Normals in the cloud's shuffled order, −127 to 127; empty where there are none.
    pub normals: Revised<Vec<[i8; 4]>>,
    /// Colours of the two sides.
    pub colourings: [Colouring; 2],
    /// Patches of fitted surfaces.
    pub patches: Revised<Vec<SurfacePatch>>,
    /// Where the viewer stands.
    pub camera: Camera,
    /// How the canvas is divided.
    pub layout: Layout,
    /// Settings.
    pub display: Display,
}

/// The part of a picture that is drawn at one time, and how finely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Width of the whole picture in pixels.
    pub width: i32,
    /// Height of the whole picture.
    pub height: i32,
    /// Device pixels for one of the page's.
    pub pixel_ratio: f32,
}

impl Scene {
    /// Replaces the points; labels, scalars, normals and patches go with them.
    pub fn set_cloud(&mut self, coordinates: &[f32]) {
        self.cloud.set(Cloud::new(coordinates));
        self.normals.set(Vec::new());
        self.patches.set(Vec::new());
        for colouring in &mut self.colourings {
            colouring.clear(self.cloud.get());
        }
    }

    /// Sets the normals (x y z per point, in the order the points were given).
    pub fn set_normals(&mut self, components: &[f32]) {
        let (vectors, _) = components.as_chunks::<3>();
        let bytes: Vec<[i8; 4]> = vectors
            .iter()
            .map(|&vector| {
                let unit = Vec3::from_array(vector).normalize_or_zero() * 127.0;
                // A float beyond the range saturates and NaN becomes 0.
                let [x, y, z] = unit.round().to_array().map(|component| component as i8);
                [x, y, z, 0]
            })
            .collect();
        self.normals.set(self.cloud.get().arrange(&bytes, [0; 4]));
    }

    /// The colours of a side.
    pub fn colouring(&self, side: Side) -> &Colouring {
        let [first, second] = &self.colourings;
        match side {
            Side::First => first,
            Side::Second => second,
        }
    }

    /// The colours of a side, to change them.
    pub fn colouring_mut(&mut self, side: Side) -> &mut Colouring {
        self.points_and_colours(side).1
    }

    /// Sets the label of each point on a side, in the order the points were given.
    pub fn set_labels(&mut self, side: Side, labels: &[u32]) {
        let (cloud, colouring) = self.points_and_colours(side);
        colouring.set_labels(cloud, labels);
    }

    /// Sets the scalar of each point on a side, in the order the points were given; NaN where a
    /// point has none.
    pub fn set_scalars(&mut self, side: Side, scalars: &[f32]) {
        let (cloud, colouring) = self.points_and_colours(side);
        colouring.set_scalars(cloud, scalars);
    }

    fn points_and_colours(&mut self, side: Side) -> (&Cloud, &mut Colouring) {
        let [first, second] = &mut self.colourings;
        let colouring = match side {
            Side::First => first,
            Side::Second => second,
        };
        (self.cloud.get(), colouring)
    }

    /// The panes of a picture.
    pub fn panes(&self, frame: &Frame) -> Panes {
        Panes::new(self.layout, frame.width, frame.height)
    }

    /// The camera's matrices for a pane.
    pub fn lens(&self, pane: &Pane) -> Lens {
        let (width, height) = (pane.viewport.width as f32, pane.viewport.height as f32);
        self.camera.lens(width, height, self.cloud.get().bounds())
    }

    /// How a pane is seen when `drawn` points are drawn in it.
    pub fn sight(&self, pane: &Pane, frame: &Frame, drawn: usize) -> Sight {
        let total = self.cloud.get().len();
        Sight {
            pane: *pane,
            lens: self.lens(pane),
            scale: self.point_scale(frame, drawn.min(total)),
            count: drawn.min(total),
            clip: self.clip(),
        }
    }

    /// The part of space that is shown.
    pub fn clip(&self) -> Clip {
        self.display.clip_box.clip(self.cloud.get().bounds())
    }

    /// The camera that frames the whole cloud in a picture.
    pub fn fitting(&self, frame: &Frame) -> Camera {
        let bounds = self.cloud.get().bounds();
        self.camera.framing(bounds, self.panes(frame).aspect())
    }

    /// Bounds of the points with one of the labels on a side; of everything where none is given.
    pub fn bounds_of(&self, side: Side, labels: &[u32]) -> Bounds {
        let cloud = self.cloud.get();
        if labels.is_empty() {
            return *cloud.bounds();
        }
        let points = cloud
            .positions()
            .iter()
            .zip(self.colouring(side).labels().get());
        Bounds::of(
            points
                .filter(|(_, label)| labels.contains(label))
                .map(|(point, _)| *point),
        )
    }

    /// Size of points when `drawn` of them are: fewer are drawn larger, to cover the same area.
    pub fn point_scale(&self, frame: &Frame, drawn: usize) -> PointScale {
        const GREATEST: f32 = 48.0;
        const LARGEST_GROWTH: f32 = 4.0;
        let cloud = self.cloud.get();
        let thinned = cloud.len() as f32 / drawn.max(1) as f32;
        let growth = thinned.sqrt().clamp(1.0, LARGEST_GROWTH);
        let ratio = frame.pixel_ratio;
        let ratio = if ratio.is_finite() { ratio } else { 1.0 };
        // Never less than a pixel, whatever the ratio.
        let greatest = (GREATEST * ratio).max(1.0);
        match self.display.point_size {
            PointSize::Spacing(factor) => PointScale {
                diameter: cloud.spacing() * factor * growth,
                least: (1.5 * ratio * growth.sqrt()).max(1.0),
                greatest,
            },
            PointSize::Pixels(pixels) => {
                // Not `clamp`: where its bounds are not known beforehand it brings along what prints numbers, 9 kB.
                let pixels = (pixels * ratio * growth.sqrt()).min(greatest).max(1.0);
                PointScale {
                    diameter: 0.0,
                    least: pixels,
                    greatest: pixels,
                }
            }
        }
    }

    /// Background with the given opacity, premultiplied.
    pub fn background(&self, opacity: f32) -> Vec4 {
        (self.display.background * opacity).extend(opacity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn four_points() -> Scene {
        let mut scene = Scene::default();
        scene.set_cloud(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0]);
        scene
    }

    #[test]
    fn a_label_has_bounds_of_its_own() {
        let mut scene = four_points();
        scene.set_labels(Side::Second, &[0, 5, 5, 1]);
        let bounds = scene.bounds_of(Side::Second, &[5]);
        assert_eq!(bounds, Bounds::new(Vec3::ZERO, Vec3::new(1.0, 2.0, 0.0)));
        assert!(scene.bounds_of(Side::Second, &[9]).is_empty());
        assert_eq!(
            scene.bounds_of(Side::First, &[]),
            *scene.cloud.get().bounds()
        );
    }

    #[test]
    fn points_are_at_least_a_pixel_whatever_the_ratio() {
        let mut scene = four_points();
        for pixel_ratio in [0.0, -1.0, 1e-9, f32::NAN, f32::INFINITY] {
            for size in [PointSize::Pixels(2.0), PointSize::Spacing(2.0)] {
                scene.display.point_size = size;
                let frame = Frame {
                    width: 0,
                    height: 0,
                    pixel_ratio,
                };
                let scale = scene.point_scale(&frame, 4);
                assert!(
                    scale.least >= 1.0 && scale.greatest >= scale.least,
                    "{scale:?}"
                );
            }
        }
    }

    #[test]
    fn a_new_cloud_forgets_labels_and_normals() {
        let mut scene = four_points();
        scene.set_normals(&[1.0; 12]);
        scene.set_cloud(&[0.0; 6]);
        assert!(scene.normals.get().is_empty());
        assert_eq!(scene.colouring(Side::First).labels().get().len(), 2);
    }

    #[test]
    fn normals_are_brought_to_unit_length_and_nonsense_to_zero() {
        let mut scene = four_points();
        scene.set_normals(&[0.0, 0.0, -9.0, f32::NAN, 0.0, 0.0]);
        let mut normals = scene.normals.get().clone();
        normals.sort_unstable();
        assert_eq!(normals, [[0, 0, -127, 0], [0; 4], [0; 4], [0; 4]]);
    }

    #[test]
    fn a_quarter_of_the_points_is_drawn_twice_as_large() {
        let scene = four_points();
        let frame = Frame {
            width: 100,
            height: 100,
            pixel_ratio: 1.0,
        };
        let (all, one) = (scene.point_scale(&frame, 4), scene.point_scale(&frame, 1));
        assert!((one.diameter - 2.0 * all.diameter).abs() < 1e-6);
    }
}
