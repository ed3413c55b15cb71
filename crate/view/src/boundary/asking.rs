//! Questions: what is where on the screen.

use glam::{Vec2, Vec3};
use wasm_bindgen::prelude::*;

use super::View;
use crate::gl::GlError;
use crate::layout::Side;
use crate::picking::{PickState, visible_in};
use crate::renderer::Renderer;
use crate::select::Region;

#[wasm_bindgen]
impl View {
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
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
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
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
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
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
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
            visible_in(&self.gl, &renderer.points, &sight, &region)?
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
