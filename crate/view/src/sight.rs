//! How the points of a pane are seen.

use crate::camera::Lens;
use crate::clip::Clip;
use crate::layout::Pane;

/// How large a point is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointScale {
    /// Diameter in cloud units; 0 where only pixels count.
    pub diameter: f32,
    /// Least diameter in pixels.
    pub least: f32,
    /// Greatest diameter in pixels.
    pub greatest: f32,
}

/// How the points of a pane are seen.
#[derive(Debug, Clone, Copy)]
pub struct Sight {
    /// Side and place on the canvas.
    pub pane: Pane,
    /// The camera's matrices for it.
    pub lens: Lens,
    /// Size of points.
    pub scale: PointScale,
    /// How many points are drawn, from the start of the shuffled order.
    pub count: usize,
    /// The part of space outside of which points are hidden.
    pub clip: Clip,
}
