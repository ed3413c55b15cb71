//! Questions: what is where on the screen.

use glam::{Vec2, Vec3};
use wasm_bindgen::prelude::*;

use super::View;
use super::plain::{Hit, Picked};
use crate::draw::gl::GlError;
use crate::draw::picking::{PickState, visible_in};
use crate::draw::renderer::Renderer;
use crate::lasso::Lasso;
use crate::layout::Side;
use crate::select::Region;

#[wasm_bindgen]
impl View {
    /// The side shown at a position, or nothing outside the canvas.
    #[wasm_bindgen(unchecked_return_type = "Side | undefined")]
    pub fn side_at(&self, x: f32, y: f32) -> Option<usize> {
        let panes = self.scene.panes(&self.frame);
        panes.at(x, y).map(|pane| pane.side.index())
    }

    /// Where a point of the cloud is seen on a side: x, y and depth (−1 to 1) or nothing where it
    /// is not before the eye or the side is not shown.
    pub fn project(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        x: f32,
        y: f32,
        z: f32,
    ) -> Option<Vec<f32>> {
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

    /// Asks for the answer; nothing while there is none yet.
    #[wasm_bindgen(unchecked_return_type = "Picked | undefined")]
    pub fn poll_pick(&mut self) -> JsValue {
        let Some(renderer) = self.renderer.as_mut() else {
            return JsValue::UNDEFINED;
        };
        let hit = match renderer.picker.poll(&self.gl) {
            PickState::Waiting => return JsValue::UNDEFINED,
            PickState::Idle => None,
            PickState::Done(side, place) => {
                let order = self.scene.cloud.get().order();
                let index = place.and_then(|place| order.get(place as usize).copied());
                index.map(|index| Hit { side, index })
            }
        };
        JsValue::from(&Picked { hit })
    }

    /// Indices, ascending, of the points of a side inside a circle.
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
    pub fn points_in_circle(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
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

    /// The region of space that a closed curve (x y per place) on a side encloses: all the way
    /// through, or, with `visible`, as deep as the deepest point that can be seen in it. Nothing
    /// where no point is inside.
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
    #[wasm_bindgen(unchecked_return_type = "Lasso | undefined")]
    pub fn lasso(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        curve: &[f32],
        visible: bool,
    ) -> Result<JsValue, JsValue> {
        self.finish();
        let side = Side::from_index(side);
        let (curve, _) = curve.as_chunks::<2>();
        let curve: Vec<Vec2> = curve.iter().copied().map(Vec2::from_array).collect();
        let camera = self.scene.camera;
        let panes = self.scene.panes(&self.frame);
        let lasso = panes
            .of(side)
            .and_then(|pane| Lasso::drawn(&curve, &pane.viewport, &camera, self.frame.pixel_ratio));
        let places = self.places_in(side, Region::Polygon(curve), visible)?;
        let Some(lasso) = lasso.filter(|_| !places.is_empty()) else {
            return Ok(JsValue::UNDEFINED);
        };
        let cloud = self.scene.cloud.get();
        let lasso = if visible {
            let seen = places
                .iter()
                .filter_map(|&at| cloud.positions().get(at as usize));
            // A little more than the deepest: what is seen must not stay for want of a digit.
            lasso.down_to(seen.copied(), &camera, cloud.spacing() / 4.0)
        } else {
            lasso
        };
        Ok(JsValue::from(&lasso))
    }

    /// Indices, ascending, of the points of a side inside a polygon (x y per corner).
    ///
    /// # Errors
    /// If the graphics context is lost or out of memory.
    pub fn points_in_polygon(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Side")] side: usize,
        corners: &[f32],
        visible: bool,
    ) -> Result<Vec<u32>, JsValue> {
        let (corners, _) = corners.as_chunks::<2>();
        let corners = corners.iter().copied().map(Vec2::from_array).collect();
        self.points_in(Side::from_index(side), Region::Polygon(corners), visible)
    }
}

impl View {
    /// Indices, ascending, of the points inside a region.
    fn points_in(
        &mut self,
        side: Side,
        region: Region,
        visible: bool,
    ) -> Result<Vec<u32>, JsValue> {
        self.finish();
        let places = self.places_in(side, region, visible)?;
        let order = self.scene.cloud.get().order();
        let given = places
            .into_iter()
            .filter_map(|place| order.get(place as usize).copied());
        let mut indices: Vec<u32> = given.collect();
        indices.sort_unstable();
        Ok(indices)
    }

    /// Places in the shuffled order of the points inside a region: all of them by projection, or
    /// those that can be seen by drawing their numbers.
    fn places_in(
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
        if visible {
            let renderer = self.renderer.as_mut().ok_or(GlError::Lost)?;
            renderer.sync(&self.gl, &self.scene);
            Ok(visible_in(&self.gl, &renderer.points, &sight, &region)?)
        } else {
            let origin = Vec2::new(pane.viewport.x as f32, pane.viewport.y as f32);
            let size = Vec2::new(pane.viewport.width as f32, pane.viewport.height as f32);
            let colouring = self.scene.colouring(side);
            let labels = colouring.labels().get().values();
            Ok(region
                .moved(-origin)
                .select(cloud.positions(), &sight.lens.view_projection, size)
                .into_iter()
                .filter(|&place| {
                    let point = cloud.positions().get(place as usize);
                    if point.is_none_or(|point| sight.clip.hides(point)) {
                        return false;
                    }
                    let label = labels.get(place as usize).copied().unwrap_or(0);
                    colouring.state(label).can_be_picked()
                })
                .collect())
        }
    }
}
