//! Which point is under the cursor, and which points can be seen in a region: the points' numbers
//! are drawn into a target cropped to the region and read back.

use glam::Vec2;
use web_sys::{WebGlBuffer, WebGlSync};

use crate::draw::gl::{Gl, GlError, ReadTarget};
use crate::draw::points::Points;
use crate::layout::{Rect, Side};
use crate::select::Region;
use crate::sight::Sight;

/// Half the side of the square around the cursor that is searched, in pixels.
pub const REACH: i32 = 12;
const SIDE: i32 = 2 * REACH + 1;
const BYTES: usize = (SIDE * SIDE * 4) as usize;

/// State of a pick.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PickState {
    /// Nothing was asked for.
    Idle,
    /// The graphics card has not finished.
    Waiting,
    /// Done: the side looked at, and the place of the point in the shuffled order, if there is one.
    Done(Side, Option<u32>),
}

#[derive(Debug)]
struct Pending {
    sync: WebGlSync,
    side: Side,
    reach: i32,
}

/// Draws and reads the numbers.
#[derive(Debug)]
pub struct Picker {
    target: ReadTarget,
    pixels: WebGlBuffer,
    pending: Option<Pending>,
}

impl Picker {
    /// A picker with nothing to do.
    ///
    /// # Errors
    /// [`GlError`] if the driver gives no object or cannot draw to it.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        Ok(Self {
            target: ReadTarget::new(gl, SIDE, SIDE)?,
            pixels: gl.create_buffer().ok_or(GlError::Lost)?,
            pending: None,
        })
    }

    /// Starts to look for the point nearest the pixel (x, y) of the canvas, at most `reach` pixels
    /// ([`REACH`] at most) away. The answer comes by [`Picker::poll`]; an earlier pick is dropped.
    ///
    /// # Errors
    /// [`GlError`] if the driver cannot read back, or gives no object.
    pub fn start(
        &mut self,
        gl: &Gl,
        points: &Points,
        sight: &Sight,
        (x, y): (i32, i32),
        reach: i32,
    ) -> Result<(), GlError> {
        self.cancel(gl);
        let region = Rect::new(x - REACH, y - REACH, SIDE, SIDE);
        draw_ids(gl, &self.target, points, sight, region);
        gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, Some(&self.pixels));
        let bytes = BYTES as i32;
        gl.buffer_data_with_i32(Gl::PIXEL_PACK_BUFFER, bytes, Gl::STREAM_READ);
        let read = gl.read_pixels_with_i32(0, 0, SIDE, SIDE, Gl::RGBA, Gl::UNSIGNED_BYTE, 0);
        gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, None);
        gl.bind_framebuffer(Gl::FRAMEBUFFER, None);
        read.map_err(|_| GlError::Read)?;
        let sync = gl
            .fence_sync(Gl::SYNC_GPU_COMMANDS_COMPLETE, 0)
            .ok_or(GlError::Lost)?;
        gl.flush();
        self.pending = Some(Pending {
            sync,
            side: sight.pane.side,
            reach: reach.clamp(0, REACH),
        });
        Ok(())
    }

    /// Asks, without waiting, whether the answer has come.
    pub fn poll(&mut self, gl: &Gl) -> PickState {
        let Some(pending) = self.pending.take() else {
            return PickState::Idle;
        };
        match gl.client_wait_sync_with_u32(&pending.sync, 0, 0) {
            Gl::TIMEOUT_EXPIRED => {
                self.pending = Some(pending);
                PickState::Waiting
            }
            Gl::WAIT_FAILED => PickState::Done(pending.side, None),
            _ => {
                gl.delete_sync(Some(&pending.sync));
                let mut pixels = [0_u8; BYTES];
                gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, Some(&self.pixels));
                let target = Gl::PIXEL_PACK_BUFFER;
                gl.get_buffer_sub_data_with_i32_and_u8_array(target, 0, &mut pixels);
                gl.bind_buffer(Gl::PIXEL_PACK_BUFFER, None);
                PickState::Done(pending.side, nearest(&pixels, pending.reach))
            }
        }
    }

    fn cancel(&mut self, gl: &Gl) {
        if let Some(pending) = self.pending.take() {
            gl.delete_sync(Some(&pending.sync));
        }
    }
}

/// The places, ascending, of the points of which a pixel can be seen in a region of the canvas.
/// Waits for the graphics card.
///
/// # Errors
/// [`GlError`] if the driver cannot draw to a target of that size, or read it back.
pub fn visible_in(
    gl: &Gl,
    points: &Points,
    sight: &Sight,
    region: &Region,
) -> Result<Vec<u32>, GlError> {
    let Some((min, max)) = region.extent() else {
        return Ok(Vec::new());
    };
    let (min, max) = (min.floor(), max.ceil());
    let around = Rect::new(
        min.x as i32,
        min.y as i32,
        (max.x as i32).saturating_sub(min.x as i32),
        (max.y as i32).saturating_sub(min.y as i32),
    );
    let around = around.intersection(&sight.pane.visible);
    let (width, height) = (around.width, around.height);
    if width == 0 || height == 0 {
        return Ok(Vec::new());
    }
    let target = ReadTarget::new(gl, width, height)?;
    draw_ids(gl, &target, points, sight, around);
    let mut pixels = vec![0_u8; width.unsigned_abs() as usize * height.unsigned_abs() as usize * 4];
    let read = target.read(gl, &mut pixels);
    gl.bind_framebuffer(Gl::FRAMEBUFFER, None);
    target.delete(gl);
    read?;
    Ok(inside(&pixels, around, region))
}

/// The points, ascending, whose numbers stand in pixels inside a region.
fn inside(pixels: &[u8], around: Rect, region: &Region) -> Vec<u32> {
    let (ids, _) = pixels.as_chunks::<4>();
    let rows = ids.chunks_exact(around.width.unsigned_abs().max(1) as usize);
    let mut points: Vec<u32> = (around.y..)
        .zip(rows)
        .flat_map(|(y, row)| (around.x..).zip(row).map(move |(x, id)| (x, y, id)))
        .filter(|(x, y, id)| {
            **id != [0; 4] && region.contains(Vec2::new(*x as f32 + 0.5, *y as f32 + 0.5))
        })
        .filter_map(|(_, _, id)| u32::from_le_bytes(*id).checked_sub(1))
        .collect();
    points.sort_unstable();
    points.dedup();
    points
}

/// Draws the numbers in a region of the canvas. The whole pane's picture is drawn with a viewport
/// shifted so that the region falls onto the target, which clips the rest.
fn draw_ids(gl: &Gl, target: &ReadTarget, points: &Points, sight: &Sight, region: Rect) {
    target.bind(gl);
    gl.disable(Gl::SCISSOR_TEST);
    gl.clear_color(0.0, 0.0, 0.0, 0.0);
    gl.clear(Gl::COLOR_BUFFER_BIT | Gl::DEPTH_BUFFER_BIT);
    let pane = &sight.pane;
    let viewport = pane.viewport.relative_to(region.x, region.y);
    let visible = pane.visible.relative_to(region.x, region.y);
    gl.viewport(viewport.x, viewport.y, viewport.width, viewport.height);
    gl.enable(Gl::SCISSOR_TEST);
    gl.scissor(visible.x, visible.y, visible.width, visible.height);
    points.draw_ids(gl, sight);
    gl.disable(Gl::SCISSOR_TEST);
}

/// The place of the point whose pixel is nearest the middle of the square, at most `reach` away.
fn nearest(pixels: &[u8], reach: i32) -> Option<u32> {
    let (ids, _) = pixels.as_chunks::<4>();
    let distance = |place: usize| {
        let place = place as i32;
        let (x, y) = (place % SIDE - REACH, place / SIDE - REACH);
        x * x + y * y
    };
    ids.iter()
        .enumerate()
        .filter_map(|(place, &id)| Some((distance(place), u32::from_le_bytes(id).checked_sub(1)?)))
        .filter(|&(distance, _)| distance <= reach * reach)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, point)| point)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(ids: &[(i32, i32, u32)]) -> Vec<u8> {
        let mut pixels = vec![0; BYTES];
        for &(x, y, id) in ids {
            let place = ((y + REACH) * SIDE + x + REACH) as usize * 4;
            pixels[place..place + 4].copy_from_slice(&id.to_le_bytes());
        }
        pixels
    }

    #[test]
    fn the_pixel_nearest_the_cursor_wins() {
        let pixels = with(&[(-5, 0, 7), (3, 2, 1_000_001), (0, 9, 3)]);
        assert_eq!(nearest(&pixels, REACH), Some(1_000_000));
    }

    #[test]
    fn beyond_the_reach_there_is_nothing() {
        let pixels = with(&[(4, 4, 9)]);
        assert_eq!(nearest(&pixels, 5), None);
        assert_eq!(nearest(&pixels, 6), Some(8));
        assert_eq!(nearest(&with(&[]), REACH), None);
    }

    #[test]
    fn the_first_point_is_no_background() {
        assert_eq!(nearest(&with(&[(0, 0, 1)]), 0), Some(0));
    }

    #[test]
    fn a_lasso_takes_the_points_of_the_pixels_inside_it_once() {
        let ids: [u32; 6] = [1, 1, 0, 5, 9, 9];
        let pixels: Vec<u8> = ids.iter().flat_map(|id| id.to_le_bytes()).collect();
        let brush = |x: f32| Region::Circle {
            centre: Vec2::new(x, 101.0),
            radius: 1.2,
        };
        let around = Rect::new(10, 100, 3, 2);
        assert_eq!(inside(&pixels, around, &brush(11.0)), [0, 4, 8]);
        assert_eq!(inside(&pixels, around, &brush(13.0)), [8]);
    }
}
