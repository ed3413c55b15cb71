//! The renderer as JavaScript sees it: one class, in parts. What is seen is set in `content`, the
//! camera moved in `travel`, questions answered in `asking`; this file makes and draws it.
//!
//! Positions on the screen are in device pixels from the lower left corner of the canvas.

mod asking;
mod content;
mod crossing;
mod plain;
mod travel;

use wasm_bindgen::prelude::*;
use web_sys::WebGl2RenderingContext;

use crate::camera::Camera;
use crate::controls::Flight;
use crate::draw::gl::GlError;
use crate::draw::renderer::Renderer;
use crate::motion::Motion;
use crate::scene::{Frame, Scene};

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
    /// A view that draws with a context.
    ///
    /// # Errors
    /// If the driver refuses a shader, or the context is lost.
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
    ///
    /// # Errors
    /// If the driver refuses a shader, or the context is lost again.
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

    /// Draws a frame at a time in milliseconds that was asked for so many milliseconds ago. Returns
    /// whether another one is needed.
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
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
    ///
    /// # Errors
    /// If the picture is larger than the driver can draw, or the context is lost or out of memory.
    pub fn picture(
        &mut self,
        width: i32,
        height: i32,
        pixel_ratio: f32,
        opacity: f32,
    ) -> Result<Vec<u8>, JsValue> {
        self.finish();
        let frame = Frame {
            width,
            height,
            pixel_ratio,
        };
        let renderer = self.renderer.as_mut().ok_or(GlError::Lost)?;
        let opacity = opacity.clamp(0.0, 1.0);
        Ok(renderer.picture(&self.gl, &self.scene, &frame, opacity)?)
    }
}
