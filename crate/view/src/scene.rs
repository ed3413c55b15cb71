//! All that is to be seen, without a word of WebGL: what the graphics card holds can be lost and
//! made again from here.

use glam::{Vec3, Vec4};
use tsify::Tsify;

use crate::camera::{Camera, Lens};
use crate::clip::{Clip, ClipBox};
use crate::cloud::{Arranged, Bounds, Cloud};
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

/// A normal as it is given, and as it is drawn: −127 to 127.
type Normals = Arranged<f32, [i8; 4]>;

/// The scene.
#[derive(Debug)]
pub struct Scene {
    /// The points.
    pub cloud: Revised<Cloud>,
    /// Normals, where there are any.
    pub normals: Revised<Normals>,
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

impl Default for Scene {
    fn default() -> Self {
        Self {
            cloud: Revised::default(),
            normals: Revised::new(Arranged::none(normal)),
            colourings: Default::default(),
            patches: Revised::default(),
            camera: Camera::default(),
            layout: Layout::default(),
            display: Display::default(),
        }
    }
}

/// A normal brought to unit length, and what is none to zero.
fn normal(given: &[f32]) -> [i8; 4] {
    let given = Vec3::from_array(given.try_into().unwrap_or_default());
    let unit = given.normalize_or_zero() * 127.0;
    // A float beyond the range saturates and NaN becomes 0.
    let [x, y, z] = unit.round().to_array().map(|component| component as i8);
    [x, y, z, 0]
}

impl Scene {
    /// Replaces the points; labels, scalars, normals and patches go with them. They are to be seen as
    /// far as [`Scene::proceed`] has come.
    pub fn set_cloud(&mut self, coordinates: Vec<f32>) {
        self.cloud.set(Cloud::new(coordinates));
        self.normals.set(Arranged::none(normal));
        self.patches.set(Vec::new());
        for colouring in &mut self.colourings {
            colouring.clear();
        }
    }

    /// Sets the normals (x y z per point, in the order the points were given).
    pub fn set_normals(&mut self, components: Vec<f32>) {
        self.normals.set(Arranged::of(components, 3, normal));
    }

    /// Brings as many more points, and what is said of as many, into the order in which they are drawn.
    /// Returns whether that leaves some.
    pub fn proceed(&mut self, points: usize) -> bool {
        self.cloud.proceed(|cloud| cloud.proceed(points));
        let cloud = self.cloud.get();
        for colouring in &mut self.colourings {
            colouring.proceed(cloud, points);
        }
        self.normals
            .proceed(|normals| normals.proceed(cloud, points));
        !self.is_ready()
    }

    /// Whether everything is in order.
    pub fn is_ready(&self) -> bool {
        let cloud = self.cloud.get();
        cloud.is_ready()
            && self.normals.get().is_ready(cloud)
            && self.colourings.iter().all(|side| side.is_ready(cloud))
    }

    /// How many points can be drawn on a side.
    pub fn ready(&self, side: Side) -> usize {
        self.colouring(side).ready()
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
        let [first, second] = &mut self.colourings;
        match side {
            Side::First => first,
            Side::Second => second,
        }
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
        let drawn = drawn.min(self.ready(pane.side));
        Sight {
            pane: *pane,
            lens: self.lens(pane),
            scale: self.point_scale(frame, drawn),
            count: drawn,
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

    /// Bounds of the points with one of the labels on a side, as far as they are in order; of everything
    /// where none is given.
    pub fn bounds_of(&self, side: Side, labels: &[u32]) -> Bounds {
        let cloud = self.cloud.get();
        if labels.is_empty() {
            return *cloud.bounds();
        }
        let points = cloud
            .positions()
            .iter()
            .zip(self.colouring(side).labels().get().values());
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
        let points = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0];
        scene.set_cloud(points.to_vec());
        scene.proceed(usize::MAX);
        scene
    }

    #[test]
    fn a_label_has_bounds_of_its_own() {
        let mut scene = four_points();
        let side = scene.colouring_mut(Side::Second);
        side.set_labels(vec![0, 5, 5, 1]);
        scene.proceed(usize::MAX);
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
        scene.set_normals(vec![1.0; 12]);
        scene.colouring_mut(Side::First).set_labels(vec![7; 4]);
        scene.proceed(usize::MAX);
        scene.set_cloud(vec![0.0; 6]);
        assert_eq!(scene.ready(Side::First), 0);
        scene.proceed(usize::MAX);
        assert!(!scene.normals.get().is_wanted());
        assert_eq!(scene.colouring(Side::First).labels().get().values(), [0, 0]);
    }

    #[test]
    fn normals_are_brought_to_unit_length_and_nonsense_to_zero() {
        let mut scene = four_points();
        scene.set_normals(vec![0.0, 0.0, -9.0, f32::NAN, 0.0, 0.0]);
        scene.proceed(usize::MAX);
        let mut normals = scene.normals.get().values().to_vec();
        normals.sort_unstable();
        assert_eq!(normals, [[0, 0, -127, 0], [0; 4], [0; 4], [0; 4]]);
    }

    #[test]
    fn points_are_seen_as_far_as_they_are_in_order() {
        let mut scene = four_points();
        scene.colouring_mut(Side::Second).set_labels(vec![1; 4]);
        assert_eq!(
            (scene.ready(Side::First), scene.ready(Side::Second)),
            (4, 0)
        );
        assert!(scene.proceed(3));
        assert_eq!(scene.ready(Side::Second), 3);
        assert!(!scene.proceed(3));
        assert_eq!(scene.ready(Side::Second), 4);
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
