//! Draws a scene: points into a target of their own, then onto the canvas with eye-dome lighting.

use glam::{Vec2, Vec4};
use js_sys::Int32Array;
use wasm_bindgen::JsCast;

use crate::draw::eye_dome::{EyeDome, Finish};
use crate::draw::gizmo;
use crate::draw::gl::{Gl, GlError, ReadTarget, SceneTarget};
use crate::draw::lines::{LineBuffer, Lines};
use crate::draw::patches::Patches;
use crate::draw::picking::Picker;
use crate::draw::points::Points;
use crate::layout::{Pane, Rect};
use crate::picture::{Picture, TILE};
use crate::scene::{Frame, Scene};

/// Radius of eye-dome lighting in pixels of the page.
const EYE_DOME_RADIUS: f32 = 1.4;
/// Width of the outline around highlighted points in pixels of the page.
const OUTLINE_WIDTH: f32 = 1.5;

/// What the graphics card holds. All of it can be made again from the scene.
#[derive(Debug)]
pub struct Renderer {
    /// The points, for drawing and for picking.
    pub points: Points,
    /// Picks points.
    pub picker: Picker,
    eye_dome: EyeDome,
    patches: Patches,
    lines: Lines,
    gizmo: LineBuffer,
    screen: Option<SceneTarget>,
}

/// One drawing: a part of a picture.
struct Shot<'a> {
    scene: &'a Scene,
    frame: &'a Frame,
    tile: Rect,
    count: usize,
    background: Vec4,
}

impl Renderer {
    /// Compiles the programs.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        gl.enable(Gl::DEPTH_TEST);
        gl.depth_func(Gl::LEQUAL);
        // Colours premultiplied by opacity in the target, for pictures with a clear background.
        let (over, add) = (Gl::ONE_MINUS_SRC_ALPHA, Gl::ONE);
        gl.blend_func_separate(Gl::SRC_ALPHA, over, add, over);
        gl.pixel_storei(Gl::UNPACK_ALIGNMENT, 1);
        Ok(Self {
            points: Points::new(gl)?,
            picker: Picker::new(gl)?,
            eye_dome: EyeDome::new(gl)?,
            patches: Patches::new(gl)?,
            lines: Lines::new(gl)?,
            gizmo: LineBuffer::new(gl)?,
            screen: None,
        })
    }

    /// Uploads what has changed in the scene.
    pub fn sync(&mut self, gl: &Gl, scene: &Scene) {
        self.points.sync(gl, scene);
        self.patches.sync(gl, scene);
    }

    /// Draws onto the canvas, with the first `count` points.
    ///
    /// # Errors
    /// [`GlError`] if the driver gives no object or cannot draw to it.
    pub fn draw(
        &mut self,
        gl: &Gl,
        scene: &Scene,
        frame: &Frame,
        count: usize,
    ) -> Result<(), GlError> {
        let (width, height) = (frame.width, frame.height);
        if width <= 0 || height <= 0 {
            return Ok(());
        }
        self.sync(gl, scene);
        let target = match self.screen.take() {
            Some(target) if target.size() == (width, height) => target,
            outgrown => {
                if let Some(outgrown) = outgrown {
                    outgrown.delete(gl);
                }
                SceneTarget::new(gl, width, height)?
            }
        };
        let shot = Shot {
            scene,
            frame,
            tile: Rect::new(0, 0, width, height),
            count,
            background: scene.background(1.0),
        };
        self.draw_points(gl, &target, &shot);
        gl.bind_framebuffer(Gl::FRAMEBUFFER, None);
        self.finish(gl, &target, &shot);
        self.screen = Some(target);
        Ok(())
    }

    /// Draws a picture to be saved, in tiles where it is large, and returns it as r g b a with
    /// straight alpha, uppermost row first. Every pixel is the mean of four that are drawn, unless
    /// that would be more than the driver can do.
    ///
    /// # Errors
    /// [`GlError::TooLarge`] where the driver cannot draw so large a picture; else as for drawing and
    /// reading back.
    pub fn picture(
        &mut self,
        gl: &Gl,
        scene: &Scene,
        frame: &Frame,
        opacity: f32,
    ) -> Result<Vec<u8>, GlError> {
        self.sync(gl, scene);
        let (width, height) = greatest_picture(gl);
        let fits = |factor: i32| {
            (1..=width / factor).contains(&frame.width)
                && (1..=height / factor).contains(&frame.height)
        };
        let Some(factor) = [2, 1].into_iter().find(|&factor| fits(factor)) else {
            return Err(GlError::TooLarge { width, height });
        };
        let mut picture = Picture::new(frame.width, frame.height, factor);
        let frame = Frame {
            width: frame.width * factor,
            height: frame.height * factor,
            pixel_ratio: frame.pixel_ratio * factor as f32,
        };
        // Shading and outlines look at neighbours: tiles overlap by as much.
        let margin = (frame.pixel_ratio * 4.0).ceil() as i32;
        let size = (
            TILE.min(frame.width) + 2 * margin,
            TILE.min(frame.height) + 2 * margin,
        );
        let target = SceneTarget::new(gl, size.0, size.1)?;
        let output = ReadTarget::new(gl, size.0, size.1)?;
        let mut pixels = vec![0_u8; size.0 as usize * size.1 as usize * 4];
        let mut result = Ok(());
        let starts = |length: i32| (0..length).step_by(TILE as usize);
        for (x, y) in starts(frame.height).flat_map(|y| starts(frame.width).map(move |x| (x, y))) {
            let shot = Shot {
                scene,
                frame: &frame,
                tile: Rect::new(x - margin, y - margin, size.0, size.1),
                count: usize::MAX,
                background: scene.background(opacity),
            };
            self.draw_points(gl, &target, &shot);
            output.bind(gl);
            self.finish(gl, &target, &shot);
            result = output.read(gl, &mut pixels);
            if result.is_err() {
                break;
            }
            picture.add(x, y, &pixels, size.0, margin);
        }
        gl.bind_framebuffer(Gl::FRAMEBUFFER, None);
        target.delete(gl);
        output.delete(gl);
        result.map(|()| picture.into_straight_alpha())
    }

    fn draw_points(&self, gl: &Gl, target: &SceneTarget, shot: &Shot<'_>) {
        let Shot { scene, frame, .. } = shot;
        target.bind(gl);
        gl.disable(Gl::SCISSOR_TEST);
        gl.disable(Gl::BLEND);
        gl.depth_mask(true);
        gl.clear_color(0.0, 0.0, 0.0, 0.0);
        gl.clear(Gl::COLOR_BUFFER_BIT | Gl::DEPTH_BUFFER_BIT);
        gl.enable(Gl::SCISSOR_TEST);
        for pane in scene.panes(frame).iter() {
            shot.enter(gl, pane);
            let colour_by = scene.colouring(pane.side).by;
            let sight = scene.sight(pane, frame, shot.count);
            self.points
                .draw(gl, &sight, colour_by, scene.display.background);
        }
        gl.disable(Gl::SCISSOR_TEST);
    }

    fn finish(&mut self, gl: &Gl, points: &SceneTarget, shot: &Shot<'_>) {
        let Shot {
            scene, frame, tile, ..
        } = shot;
        let display = &scene.display;
        gl.disable(Gl::SCISSOR_TEST);
        let back = shot.background;
        gl.clear_color(back.x, back.y, back.z, back.w);
        gl.clear(Gl::COLOR_BUFFER_BIT | Gl::DEPTH_BUFFER_BIT);
        gl.enable(Gl::SCISSOR_TEST);
        let finish = Finish {
            strength: display.eye_dome,
            radius: EYE_DOME_RADIUS * frame.pixel_ratio,
            background: back,
            outline: display.ink,
            outline_width: OUTLINE_WIDTH * frame.pixel_ratio,
        };
        let clip = scene.clip();
        for pane in scene.panes(frame).iter() {
            let visible = shot.enter(gl, pane);
            gl.viewport(0, 0, tile.width, tile.height);
            let lens = scene.lens(pane);
            self.eye_dome.draw(gl, points, visible, &lens, &finish);
            shot.enter(gl, pane);
            let viewport = Vec2::new(pane.viewport.width as f32, pane.viewport.height as f32);
            let lift = scene.cloud.get().spacing();
            let style = (viewport, frame.pixel_ratio, lift);
            self.patches
                .draw(gl, &self.lines, pane.side, &lens, &clip, style);
        }
        gl.disable(Gl::SCISSOR_TEST);
        if display.gizmo {
            self.draw_gizmo(gl, shot);
        }
    }

    /// Draws the axes into the lower right corner of the picture; the page's legend is on the left.
    fn draw_gizmo(&mut self, gl: &Gl, shot: &Shot<'_>) {
        let Shot {
            scene, frame, tile, ..
        } = shot;
        let side = (gizmo::SIZE * frame.pixel_ratio) as i32;
        if side * 3 > frame.width.min(frame.height) {
            return;
        }
        self.gizmo.stream(gl, &gizmo::lines(scene.camera.rotation));
        gl.viewport(frame.width - side - tile.x, -tile.y, side, side);
        gl.disable(Gl::DEPTH_TEST);
        gl.enable(Gl::BLEND);
        let (projection, viewport) = (gizmo::projection(gizmo::SIZE), Vec2::splat(side as f32));
        self.lines.draw(
            gl,
            &self.gizmo,
            &projection,
            viewport,
            (frame.pixel_ratio, 1.0),
        );
        gl.disable(Gl::BLEND);
        gl.enable(Gl::DEPTH_TEST);
    }
}

impl Shot<'_> {
    /// Sets viewport and scissor for a pane; returns its visible part of the tile.
    fn enter(&self, gl: &Gl, pane: &Pane) -> Rect {
        let (x, y) = (self.tile.x, self.tile.y);
        let viewport = pane.viewport.relative_to(x, y);
        let whole = Rect::new(0, 0, self.tile.width, self.tile.height);
        let visible = pane.visible.relative_to(x, y).intersection(&whole);
        gl.viewport(viewport.x, viewport.y, viewport.width, viewport.height);
        gl.scissor(visible.x, visible.y, visible.width, visible.height);
        visible
    }
}

/// The greatest width and height that a viewport can have. WebGL2 grants 2048.
fn greatest_picture(gl: &Gl) -> (i32, i32) {
    let dims = gl.get_parameter(Gl::MAX_VIEWPORT_DIMS).ok();
    let dims = dims.and_then(|dims| dims.dyn_into::<Int32Array>().ok());
    match dims.map(|dims| dims.to_vec()).as_deref() {
        Some(&[width, height]) => (width, height),
        _ => (2048, 2048),
    }
}
