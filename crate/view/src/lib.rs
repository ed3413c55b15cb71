//! WebGL2 renderer for segmented point clouds, loaded by the page.
//!
//! [`scene`] holds what is to be seen, [`renderer`] draws it, and [`boundary`] is what
//! JavaScript sees. The page decides everything that has to do with Fit4CAD: which label a point has,
//! which colour a label. Time comes in as an argument, a frame is drawn when the page asks for one.
//!
//! Positions on the screen are in device pixels from the lower left corner of the canvas.

pub mod boundary;
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
