//! Everything that names WebGL: what the graphics card holds, and how it draws a
//! [`Scene`](crate::scene::Scene). All of it can be made again from the scene, which knows nothing
//! of it.

pub mod eye_dome;
pub mod gizmo;
pub mod gl;
pub mod lines;
pub mod palette;
pub mod patches;
pub mod picking;
pub mod points;
pub mod renderer;
