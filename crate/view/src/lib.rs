//! WebGL2 renderer for segmented point clouds, loaded by the page.
//!
//! [`scene`] holds what is to be seen, [`renderer`] draws it, and this file is the boundary to
//! JavaScript. The page decides everything that has to do with Fit4CAD: which label a point has,
//! which colour a label. Time comes in as an argument, a frame is drawn when the page asks for one.
//!
//! Positions on the screen are in device pixels from the lower left corner of the canvas.

pub mod camera;
pub mod cloud;
pub mod colouring;
pub mod controls;
pub mod eye_dome;
pub mod gizmo;
pub mod gl;
pub mod layout;
pub mod lines;
pub mod motion;
pub mod palette;
pub mod patch;
pub mod picking;
pub mod picture;
pub mod points;
pub mod renderer;
pub mod scene;
pub mod select;

use glam::{Vec2, Vec3};
use wasm_bindgen::prelude::*;
use web_sys::WebGl2RenderingContext;

use crate::camera::{Camera, Projection, Standpoint};
use crate::cloud::Bounds;
use crate::colouring::ColourBy;
use crate::controls::Flight;
use crate::gl::GlError;
use crate::layout::{Layout, Side};
use crate::motion::Motion;
use crate::patch::SurfacePatch;
use crate::picking::PickState;
use crate::renderer::Renderer;
use crate::scene::{Frame, PointSize, Scene};
use crate::select::Region;

impl From<GlError> for JsValue {
    fn from(error: GlError) -> Self {
        JsError::new(&error.to_string()).into()
    }
}

/// A view of one or two colourings of a cloud on a canvas.
#[wasm_bindgen]
pub struct View {
    gl: WebGl2RenderingContext,
    scene: Scene,
    frame: Frame,
    renderer: Option<Renderer>,
    flight: Option<Flight>,
    motion: Motion,
    drawn: Option<Camera>,
}

#[wasm_bindgen]
impl View {
    /// A view that draws with a context. Fails where the driver refuses a shader.
    #[wasm_bindgen(constructor)]
    pub fn new(gl: WebGl2RenderingContext) -> Result<View, JsValue> {
        let renderer = Renderer::new(&gl)?;
        Ok(Self {
            gl,
            scene: Scene::default(),
            frame: Frame {
                width: 1,
                height: 1,
                pixel_ratio: 1.0,
            },
            renderer: Some(renderer),
            flight: None,
            motion: Motion::default(),
            drawn: None,
        })
    }

    /// Forgets everything on the graphics card: its context is lost.
    pub fn lose(&mut self) {
        self.renderer = None;
    }

    /// Makes everything on the graphics card again: its context is back.
    pub fn restore(&mut self) -> Result<(), JsValue> {
        self.renderer = Some(Renderer::new(&self.gl)?);
        Ok(())
    }

    /// Tells the size of the canvas in device pixels, and how many of them make one of the page's.
    pub fn resize(&mut self, width: i32, height: i32, pixel_ratio: f32) {
        self.frame = Frame {
            width,
            height,
            pixel_ratio: if pixel_ratio > 0.0 { pixel_ratio } else { 1.0 },
        };
    }

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
        let Scene {
            cloud, colourings, ..
        } = &mut self.scene;
        if let Some(colouring) = colourings.get_mut(side) {
            colouring.set_labels(cloud.get(), labels);
        }
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
        let Scene {
            cloud, colourings, ..
        } = &mut self.scene;
        if let Some(colouring) = colourings.get_mut(side) {
            colouring.set_scalars(cloud.get(), scalars);
        }
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

    // The camera.

    /// Target x y z, rotation x y z w, visible height, 1 where orthographic.
    pub fn camera(&self) -> Vec<f32> {
        self.destination().state().to_vec()
    }

    /// Sets the camera from such numbers; false where they are none.
    pub fn set_camera(&mut self, state: &[f32], animated: bool) -> bool {
        let camera = Camera::from_state(state);
        if let Some(camera) = camera {
            self.fly(camera, animated);
        }
        camera.is_some()
    }

    /// Switches between perspective and orthographic projection.
    pub fn set_orthographic(&mut self, orthographic: bool) {
        let projection = if orthographic {
            Projection::Orthographic
        } else {
            Projection::Perspective
        };
        let camera = Camera {
            projection,
            ..self.destination()
        };
        self.fly(camera, false);
    }

    /// Frames the whole cloud.
    pub fn fit(&mut self, animated: bool) {
        let bounds = *self.scene.cloud.get().bounds();
        self.frame_bounds(&bounds, animated);
    }

    /// Frames the points with any of the labels on a side.
    pub fn fit_labels(&mut self, side: usize, labels: &[u32], animated: bool) {
        let bounds = self.scene.bounds_of(Side::from_index(side), labels);
        self.frame_bounds(&bounds, animated);
    }

    /// Frames a box.
    pub fn fit_box(&mut self, min: &[f32], max: &[f32], animated: bool) {
        if let (&[a, b, c], &[d, e, f]) = (min, max) {
            let bounds = Bounds::new(Vec3::new(a, b, c), Vec3::new(d, e, f));
            self.frame_bounds(&bounds, animated);
        }
    }

    /// Looks from a standpoint: 0 front, 1 back, 2 left, 3 right, 4 top, 5 bottom, 6 isometric.
    pub fn look_from(&mut self, standpoint: usize, animated: bool) {
        if let Some(&standpoint) = Standpoint::ALL.get(standpoint) {
            self.fly(self.destination().from_standpoint(standpoint), animated);
        }
    }

    /// Turns the cloud as a hand on a trackball does, from one position to another.
    pub fn drag(&mut self, x0: f32, y0: f32, x1: f32, y1: f32) {
        self.land();
        let (centre, size) = self.pane_around(x0, y0);
        let radius = size.min_element() * 0.5;
        let (from, to) = (Vec2::new(x0, y0) - centre, Vec2::new(x1, y1) - centre);
        self.scene.camera.drag(from, to, radius);
    }

    /// Turns the cloud about the viewport's axes, in radians.
    pub fn turn(&mut self, yaw: f32, pitch: f32, roll: f32) {
        self.land();
        self.scene.camera.turn(yaw, pitch, roll);
    }

    /// Moves the cloud across the viewport, in device pixels.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.land();
        let height = self.viewport_height();
        self.scene.camera.pan(Vec2::new(dx, dy), height);
    }

    /// Enlarges by a factor, keeping what is under (x, y) in place.
    pub fn zoom(&mut self, factor: f32, x: f32, y: f32) {
        self.land();
        let (centre, size) = self.pane_around(x, y);
        self.scene
            .camera
            .zoom(factor, Vec2::new(x, y) - centre, size.y);
    }

    /// Enlarges by a factor, keeping the target in place.
    pub fn zoom_centre(&mut self, factor: f32) {
        self.land();
        self.scene.camera.zoom(factor, Vec2::ZERO, 1.0);
    }

    // Drawing.

    /// Draws a frame at a time in milliseconds that was asked for so many milliseconds ago. Returns
    /// whether another one is needed.
    pub fn draw(&mut self, now: f64, waited: f64) -> Result<bool, JsValue> {
        if let Some(flight) = &mut self.flight {
            let (camera, over) = flight.at(now);
            self.scene.camera = camera;
            if over {
                self.flight = None;
            }
        }
        let moved = self.drawn.is_some_and(|drawn| drawn != self.scene.camera);
        let panes = self.scene.panes(&self.frame).iter().count();
        let total = self.scene.cloud.get().len() * panes;
        let (count, moving) = self.motion.frame(now, waited, moved, total);
        if let Some(renderer) = &mut self.renderer {
            renderer.draw(&self.gl, &self.scene, &self.frame, count / panes.max(1))?;
        }
        self.drawn = Some(self.scene.camera);
        Ok(self.flight.is_some() || (moving && count < total))
    }

    /// A picture of the scene in the given size: r g b a, uppermost row first. `pixel_ratio` says
    /// how large points and outlines are drawn in it, `opacity` 0 leaves the background clear.
    pub fn picture(
        &mut self,
        width: i32,
        height: i32,
        pixel_ratio: f32,
        opacity: f32,
    ) -> Result<Vec<u8>, JsValue> {
        let frame = Frame {
            width,
            height,
            pixel_ratio,
        };
        let renderer = self.renderer.as_mut().ok_or(GlError::Lost)?;
        let opacity = opacity.clamp(0.0, 1.0);
        Ok(renderer.picture(&self.gl, &self.scene, &frame, opacity)?)
    }

    // Asking.

    /// Number of the side shown at a position, or nothing outside the canvas.
    pub fn side_at(&self, x: f32, y: f32) -> Option<usize> {
        let panes = self.scene.panes(&self.frame);
        panes.at(x, y).map(|pane| pane.side.index())
    }

    /// Where a point of the cloud is seen on a side: x, y and depth (−1 to 1) or nothing where it
    /// is not before the eye or the side is not shown.
    pub fn project(&self, side: usize, x: f32, y: f32, z: f32) -> Option<Vec<f32>> {
        let panes = self.scene.panes(&self.frame);
        let pane = panes.of(Side::from_index(side))?;
        let clip = self.scene.lens(pane).view_projection * Vec3::new(x, y, z).extend(1.0);
        if clip.w.is_nan() || clip.w <= 0.0 {
            return None;
        }
        let (rect, seen) = (pane.viewport, clip.truncate() / clip.w);
        Some(vec![
            rect.x as f32 + (seen.x * 0.5 + 0.5) * rect.width as f32,
            rect.y as f32 + (seen.y * 0.5 + 0.5) * rect.height as f32,
            seen.z,
        ])
    }

    /// Starts to look for the point nearest (x, y), at most `reach` device pixels away (12 at
    /// most). Returns whether there is a side to look at.
    pub fn start_pick(&mut self, x: f32, y: f32, reach: i32) -> Result<bool, JsValue> {
        let panes = self.scene.panes(&self.frame);
        let (Some(pane), Some(renderer)) = (panes.at(x, y), &mut self.renderer) else {
            return Ok(false);
        };
        renderer.sync(&self.gl, &self.scene);
        let sight = self.scene.sight(pane, &self.frame, usize::MAX);
        let Renderer { points, picker, .. } = renderer;
        let pixel = (x.floor() as i32, y.floor() as i32);
        picker.start(&self.gl, points, &sight, pixel, reach)?;
        Ok(true)
    }

    /// Asks for the answer: nothing while there is none yet; else the side and the point's index,
    /// or −1 where there is no point.
    pub fn poll_pick(&mut self) -> Option<Vec<i32>> {
        match self.renderer.as_mut()?.picker.poll(&self.gl) {
            PickState::Waiting => None,
            PickState::Idle => Some(vec![0, -1]),
            PickState::Done(side, place) => {
                let order = self.scene.cloud.get().order();
                let index = place.and_then(|place| order.get(place as usize).copied());
                let index = index
                    .and_then(|index| i32::try_from(index).ok())
                    .unwrap_or(-1);
                Some(vec![side.index() as i32, index])
            }
        }
    }

    /// Indices, ascending, of the points of a side inside a circle.
    pub fn points_in_circle(
        &mut self,
        side: usize,
        x: f32,
        y: f32,
        radius: f32,
        visible: bool,
    ) -> Result<Vec<u32>, JsValue> {
        let centre = Vec2::new(x, y);
        self.points_in(
            Side::from_index(side),
            Region::Circle { centre, radius },
            visible,
        )
    }

    /// Indices, ascending, of the points of a side inside a polygon (x y per corner).
    pub fn points_in_polygon(
        &mut self,
        side: usize,
        corners: &[f32],
        visible: bool,
    ) -> Result<Vec<u32>, JsValue> {
        let (corners, _) = corners.as_chunks::<2>();
        let corners = corners.iter().copied().map(Vec2::from_array).collect();
        self.points_in(Side::from_index(side), Region::Polygon(corners), visible)
    }
}

impl View {
    /// Where the camera is or is flying to.
    fn destination(&self) -> Camera {
        self.flight
            .map_or(self.scene.camera, |flight| flight.destination())
    }

    /// Ends a flight at its destination, because a hand takes over.
    fn land(&mut self) {
        if let Some(flight) = self.flight.take() {
            self.scene.camera = flight.destination();
        }
    }

    fn fly(&mut self, camera: Camera, animated: bool) {
        if animated && camera != self.scene.camera {
            self.flight = Some(Flight::new(self.scene.camera, camera));
        } else {
            self.flight = None;
            self.scene.camera = camera;
        }
    }

    fn frame_bounds(&mut self, bounds: &Bounds, animated: bool) {
        let aspect = self.scene.panes(&self.frame).aspect();
        self.fly(self.destination().framing(bounds, aspect), animated);
    }

    /// Middle and size of the viewport around a position, or of the first one.
    fn pane_around(&self, x: f32, y: f32) -> (Vec2, Vec2) {
        let panes = self.scene.panes(&self.frame);
        let rect = panes
            .at(x, y)
            .or_else(|| panes.iter().next())
            .map(|pane| pane.viewport);
        let rect = rect.unwrap_or_default();
        let size = Vec2::new(rect.width as f32, rect.height as f32);
        (Vec2::new(rect.x as f32, rect.y as f32) + size * 0.5, size)
    }

    fn viewport_height(&self) -> f32 {
        self.pane_around(-1.0, -1.0).1.y
    }

    /// The points inside a region: all of them by projection, or those that can be seen by drawing
    /// their numbers.
    fn points_in(
        &mut self,
        side: Side,
        region: Region,
        visible: bool,
    ) -> Result<Vec<u32>, JsValue> {
        let panes = self.scene.panes(&self.frame);
        let Some(pane) = panes.of(side) else {
            return Ok(Vec::new());
        };
        let sight = self.scene.sight(pane, &self.frame, usize::MAX);
        let cloud = self.scene.cloud.get();
        let places = if visible {
            let renderer = self.renderer.as_mut().ok_or(GlError::Lost)?;
            renderer.sync(&self.gl, &self.scene);
            picking::visible_in(&self.gl, &renderer.points, &sight, &region)?
        } else {
            let origin = Vec2::new(pane.viewport.x as f32, pane.viewport.y as f32);
            let size = Vec2::new(pane.viewport.width as f32, pane.viewport.height as f32);
            let colouring = self.scene.colouring(side);
            let labels = colouring.labels().get();
            region
                .moved(-origin)
                .select(cloud.positions(), &sight.lens.view_projection, size)
                .into_iter()
                .filter(|&place| {
                    let label = labels.get(place as usize).copied().unwrap_or(0);
                    colouring.state(label).can_be_picked()
                })
                .collect()
        };
        let order = cloud.order();
        let mut indices: Vec<u32> = places
            .into_iter()
            .filter_map(|place| order.get(place as usize).copied())
            .collect();
        indices.sort_unstable();
        Ok(indices)
    }
}
