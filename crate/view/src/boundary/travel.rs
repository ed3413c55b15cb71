//! The camera: set, asked for, flown and moved by hand.

use glam::{Vec2, Vec3};
use wasm_bindgen::prelude::*;

use super::View;
use super::crossing::GivenCamera;
use crate::camera::{Camera, CameraState, Projection, Standpoint};
use crate::cloud::Bounds;
use crate::controls::Flight;
use crate::layout::{Panes, Side};

#[wasm_bindgen]
impl View {
    /// Where the camera is or is flying to.
    #[wasm_bindgen(unchecked_return_type = "CameraState")]
    pub fn camera(&self) -> JsValue {
        JsValue::from(&self.destination().state())
    }

    /// Sets the camera; false where the numbers make none.
    pub fn set_camera(&mut self, state: &GivenCamera, animated: bool) -> bool {
        let camera = Camera::from_state(&CameraState::from(state));
        if let Some(camera) = camera {
            self.fly(camera, animated);
        }
        camera.is_some()
    }

    /// Switches between perspective and orthographic projection.
    pub fn set_projection(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Projection")] projection: &str,
    ) {
        let camera = Camera {
            projection: Projection::named(projection),
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
    pub fn fit_labels(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        labels: &[u32],
        animated: bool,
    ) {
        self.finish();
        let bounds = self.scene.bounds_of(Side::from_index(side), labels);
        self.frame_bounds(&bounds, animated);
    }

    /// Frames a box: its least x, y and z, then its greatest. One that is none changes nothing.
    pub fn fit_box(&mut self, corners: &[f32], animated: bool) {
        if let &[a, b, c, d, e, f] = corners {
            let bounds = Bounds::new(Vec3::new(a, b, c), Vec3::new(d, e, f));
            if !bounds.is_empty() {
                self.frame_bounds(&bounds, animated);
            }
        }
    }

    /// Looks from a standpoint.
    pub fn look_from(&mut self, standpoint: Standpoint, animated: bool) {
        self.fly(self.destination().from_standpoint(standpoint), animated);
    }

    /// Width over height of the narrowest view in a canvas of a size, as the layout is.
    pub fn aspect(&self, width: i32, height: i32) -> f32 {
        Panes::new(self.scene.layout, width, height).aspect()
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
}
