//! WebGL2 renderer for segmented point clouds, loaded by the page.
//!
//! [`scene`] holds what is to be seen, [`draw`] draws it, and [`boundary`] is what JavaScript sees.
//! Arrows point one way: `scene` ← `draw` ← `boundary`. The page decides everything that has to do with Fit4CAD: which label a point has,
//! which colour a label. Time comes in as an argument, a frame is drawn when the page asks for one.
//!
//! Positions on the screen are in device pixels from the lower left corner of the canvas.

#[cfg(all(test, target_arch = "wasm32"))]
#[macro_use]
extern crate fit4cad_testing;

pub mod boundary;
pub mod camera;
pub mod clip;
pub mod cloud;
pub mod colouring;
pub mod controls;
pub mod draw;
pub mod lasso;
pub mod layout;
pub mod motion;
pub mod patch;
pub mod picture;
pub mod scene;
pub mod select;
pub mod sight;
