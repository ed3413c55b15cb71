//! A thin layer over WebGL2: programs, buffers and targets that know how to make themselves.
//!
//! Nothing here is released by hand: the objects belong to the context, and the few that are
//! replaced are deleted where they are replaced.

mod buffers;
mod program;
mod targets;

pub use buffers::{Buffer, VertexArray};
pub use program::Program;
pub use targets::{ReadTarget, SceneTarget, Texture};
pub use web_sys::WebGl2RenderingContext as Gl;

/// What can go wrong between the renderer and the graphics driver.
#[derive(Debug, Clone, thiserror::Error)]
pub enum GlError {
    /// The driver gave no object: the context is lost, or out of memory.
    #[error("the graphics context is lost or out of memory")]
    Lost,
    /// A shader was not accepted.
    #[error("a shader was not accepted by the graphics driver: {0}")]
    Shader(String),
    /// A framebuffer cannot be drawn to.
    #[error("the graphics driver cannot draw to a {width} × {height} target (status {status:#x})")]
    Target {
        /// Width in pixels.
        width: i32,
        /// Height in pixels.
        height: i32,
        /// What `checkFramebufferStatus` said.
        status: u32,
    },
    /// A picture is larger than the driver can draw.
    #[error("a picture can be at most {width} × {height} pixels here; ask for a smaller one")]
    TooLarge {
        /// Greatest width in pixels.
        width: i32,
        /// Greatest height in pixels.
        height: i32,
    },
    /// Pixels could not be read back.
    #[error("the picture could not be read back from the graphics driver")]
    Read,
}
