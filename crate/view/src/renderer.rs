//! Draws a scene: points into a target of their own, then onto the canvas with eye-dome lighting.

use glam::{Vec2, Vec4};

use crate::eye_dome::{EyeDome, Finish};
use crate::gizmo;
use crate::gl::{Export, Gl, GlError, SceneTarget};
use crate::layout::{Pane, Rect};
use crate::lines::{LineBuffer, Lines};
use crate::patch::Patches;
use crate::picking::Picker;
use crate::points::Points;
use crate::scene::{Frame, Scene};

/// Radius of eye-dome lighting in pixels of the page.
const EYE_DOME_RADIUS: f32 = 1.4;
/// Width of the outline around highlighted points in pixels of the page.
const OUTLINE_WIDTH: f32 = 1.5;
/// Greatest side of a tile of a saved picture, without its margin.
const TILE: i32 = 2048;

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

    /// Draws a picture of any size, in tiles where it is large, and returns it as r g b a with
    /// straight alpha, uppermost row first.
    pub fn picture(
        &mut self,
        gl: &Gl,
        scene: &Scene,
        frame: &Frame,
        opacity: f32,
    ) -> Result<Vec<u8>, GlError> {
        self.sync(gl, scene);
        // Shading and outlines look at neighbours: tiles overlap by as much.
        let margin = (frame.pixel_ratio * 4.0).ceil() as i32;
        let (width, height) = (frame.width.max(1), frame.height.max(1));
        let side = TILE + 2 * margin;
        let size = (side.min(width + 2 * margin), side.min(height + 2 * margin));
        let target = SceneTarget::new(gl, size.0, size.1)?;
        let export = Export::new(gl, size.0, size.1)?;
        let mut picture = Picture::new(width, height);
        let mut pixels = vec![0_u8; size.0 as usize * size.1 as usize * 4];
        let mut result = Ok(());
        'tiles: for y in (0..height).step_by(TILE as usize) {
            for x in (0..width).step_by(TILE as usize) {
                let shot = Shot {
                    scene,
                    frame,
                    tile: Rect::new(x - margin, y - margin, size.0, size.1),
                    count: usize::MAX,
                    background: scene.background(opacity),
                };
                self.draw_points(gl, &target, &shot);
                export.bind(gl);
                self.finish(gl, &target, &shot);
                result = export.read(gl, &mut pixels);
                if result.is_err() {
                    break 'tiles;
                }
                picture.place(x, y, &pixels, size.0, margin);
            }
        }
        gl.bind_framebuffer(Gl::FRAMEBUFFER, None);
        target.delete(gl);
        export.delete(gl);
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
        for pane in scene.panes(frame).iter() {
            let visible = shot.enter(gl, pane);
            gl.viewport(0, 0, tile.width, tile.height);
            let lens = scene.lens(pane);
            self.eye_dome.draw(gl, points, visible, &lens, &finish);
            shot.enter(gl, pane);
            let viewport = Vec2::new(pane.viewport.width as f32, pane.viewport.height as f32);
            let lift = scene.cloud.get().spacing();
            let style = (viewport, frame.pixel_ratio, lift);
            self.patches.draw(gl, &self.lines, pane.side, &lens, style);
        }
        gl.disable(Gl::SCISSOR_TEST);
        if display.gizmo {
            self.draw_gizmo(gl, shot);
        }
    }

    /// Draws the axes into the lower left corner of the picture.
    fn draw_gizmo(&mut self, gl: &Gl, shot: &Shot<'_>) {
        let Shot {
            scene, frame, tile, ..
        } = shot;
        let side = (gizmo::SIZE * frame.pixel_ratio) as i32;
        if side * 3 > frame.width.min(frame.height) {
            return;
        }
        self.gizmo.stream(gl, &gizmo::lines(scene.camera.rotation));
        gl.viewport(-tile.x, -tile.y, side, side);
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

/// A picture put together from tiles.
struct Picture {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 4]>,
}

impl Picture {
    fn new(width: i32, height: i32) -> Self {
        let (width, height) = (
            width.unsigned_abs() as usize,
            height.unsigned_abs() as usize,
        );
        Self {
            width,
            height,
            pixels: vec![[0; 4]; width * height],
        }
    }

    /// Copies a tile whose lower left pixel, without its margin, is at (x, y) from below.
    fn place(&mut self, x: i32, y: i32, tile: &[u8], tile_width: i32, margin: i32) {
        let (tile, _) = tile.as_chunks::<4>();
        let (x, y) = (x.unsigned_abs() as usize, y.unsigned_abs() as usize);
        let (tile_width, margin) = (
            tile_width.unsigned_abs() as usize,
            margin.unsigned_abs() as usize,
        );
        let inner = tile_width.saturating_sub(2 * margin);
        let columns = inner.min(self.width.saturating_sub(x));
        let rows = tile.chunks_exact(tile_width.max(1)).skip(margin);
        for (row, source) in (y..self.height.min(y + TILE as usize)).zip(rows) {
            let start = (self.height - 1 - row) * self.width + x;
            let target = self.pixels.get_mut(start..start + columns);
            if let (Some(target), Some(source)) = (target, source.get(margin..margin + columns)) {
                target.copy_from_slice(source);
            }
        }
    }

    /// Divides the colours by their alpha, as image files want them.
    fn into_straight_alpha(mut self) -> Vec<u8> {
        for [r, g, b, a] in &mut self.pixels {
            if *a != 0 && *a != 255 {
                for channel in [r, g, b] {
                    let straight = (u32::from(*channel) * 255 + u32::from(*a) / 2) / u32::from(*a);
                    *channel = u8::try_from(straight).unwrap_or(255);
                }
            }
        }
        self.pixels.into_flattened()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_land_where_they_belong_and_the_picture_is_upright() {
        let mut picture = Picture::new(3, 2);
        // A tile of 5 × 4 with a margin of one pixel; its inner lower left pixel is number 6.
        let tile: Vec<u8> = (0..20).flat_map(|number| [number, 0, 0, 255]).collect();
        picture.place(0, 0, &tile, 5, 1);
        let reds: Vec<u8> = picture
            .into_straight_alpha()
            .iter()
            .step_by(4)
            .copied()
            .collect();
        assert_eq!(reds, [11, 12, 13, 6, 7, 8]);
    }

    #[test]
    fn premultiplied_colours_become_straight() {
        let mut picture = Picture::new(1, 1);
        picture.pixels[0] = [64, 128, 0, 128];
        assert_eq!(picture.into_straight_alpha(), [128, 255, 0, 128]);
    }
}
