//! Textures and the framebuffers that are drawn into.

use web_sys::{WebGlFramebuffer, WebGlRenderbuffer, WebGlTexture};

use super::{Gl, GlError};

/// A texture of bytes or depths, clamped at its edges.
#[derive(Debug)]
pub struct Texture {
    texture: WebGlTexture,
}

impl Texture {
    /// An empty texture; between its texels the filter (`NEAREST` or `LINEAR`) decides.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn new(gl: &Gl, filter: u32) -> Result<Self, GlError> {
        let texture = gl.create_texture().ok_or(GlError::Lost)?;
        gl.bind_texture(Gl::TEXTURE_2D, Some(&texture));
        for (name, value) in [
            (Gl::TEXTURE_MIN_FILTER, filter),
            (Gl::TEXTURE_MAG_FILTER, filter),
            (Gl::TEXTURE_WRAP_S, Gl::CLAMP_TO_EDGE),
            (Gl::TEXTURE_WRAP_T, Gl::CLAMP_TO_EDGE),
        ] {
            gl.tex_parameteri(Gl::TEXTURE_2D, name, value.cast_signed());
        }
        Ok(Self { texture })
    }

    /// Binds it to a texture unit.
    pub fn bind(&self, gl: &Gl, unit: u32) {
        gl.active_texture(Gl::TEXTURE0 + unit);
        gl.bind_texture(Gl::TEXTURE_2D, Some(&self.texture));
    }

    /// Replaces the content by r g b a bytes, row by row. Too few bytes are an error of the caller
    /// and leave the texture as it is.
    pub fn upload(&self, gl: &Gl, width: i32, height: i32, rgba: &[u8]) {
        gl.bind_texture(Gl::TEXTURE_2D, Some(&self.texture));
        // The only error is a buffer shorter than the texture.
        let done = gl.tex_image_2d_with_i32_and_i32_and_i32_and_format_and_type_and_opt_u8_array(
            Gl::TEXTURE_2D,
            0,
            Gl::RGBA8.cast_signed(),
            width,
            height,
            0,
            Gl::RGBA,
            Gl::UNSIGNED_BYTE,
            Some(rgba),
        );
        debug_assert!(
            done.is_ok(),
            "texture of {width} × {height} from {} bytes",
            rgba.len()
        );
    }

    fn storage(gl: &Gl, format: u32, width: i32, height: i32) -> Result<Self, GlError> {
        let texture = Self::new(gl, Gl::NEAREST)?;
        gl.tex_storage_2d(Gl::TEXTURE_2D, 1, format, width, height);
        Ok(texture)
    }
}

fn framebuffer(gl: &Gl) -> Result<WebGlFramebuffer, GlError> {
    let framebuffer = gl.create_framebuffer().ok_or(GlError::Lost)?;
    gl.bind_framebuffer(Gl::FRAMEBUFFER, Some(&framebuffer));
    Ok(framebuffer)
}

fn attach(gl: &Gl, place: u32, texture: &Texture) {
    let texture = Some(&texture.texture);
    gl.framebuffer_texture_2d(Gl::FRAMEBUFFER, place, Gl::TEXTURE_2D, texture, 0);
}

fn check(gl: &Gl, width: i32, height: i32) -> Result<(), GlError> {
    match gl.check_framebuffer_status(Gl::FRAMEBUFFER) {
        Gl::FRAMEBUFFER_COMPLETE => Ok(()),
        _ if gl.is_context_lost() => Err(GlError::Lost),
        status => Err(GlError::Target {
            width,
            height,
            status,
        }),
    }
}

/// Colour and depth of the points, both readable as textures by the eye-dome lighting pass.
#[derive(Debug)]
pub struct SceneTarget {
    framebuffer: WebGlFramebuffer,
    /// Colour; alpha 0 background, ½ highlighted, 1 other points.
    pub colour: Texture,
    /// Depth, 24 bits.
    pub depth: Texture,
    size: (i32, i32),
}

impl SceneTarget {
    /// A target of the given size.
    ///
    /// # Errors
    /// [`GlError`] if the driver gives no object or cannot draw to it.
    pub fn new(gl: &Gl, width: i32, height: i32) -> Result<Self, GlError> {
        let colour = Texture::storage(gl, Gl::RGBA8, width, height)?;
        let depth = Texture::storage(gl, Gl::DEPTH_COMPONENT24, width, height)?;
        let framebuffer = framebuffer(gl)?;
        attach(gl, Gl::COLOR_ATTACHMENT0, &colour);
        attach(gl, Gl::DEPTH_ATTACHMENT, &depth);
        check(gl, width, height)?;
        Ok(Self {
            framebuffer,
            colour,
            depth,
            size: (width, height),
        })
    }

    /// Size in pixels.
    pub fn size(&self) -> (i32, i32) {
        self.size
    }

    /// Makes it the target of drawing.
    pub fn bind(&self, gl: &Gl) {
        gl.bind_framebuffer(Gl::FRAMEBUFFER, Some(&self.framebuffer));
    }

    /// Gives the memory back.
    pub fn delete(&self, gl: &Gl) {
        gl.delete_framebuffer(Some(&self.framebuffer));
        gl.delete_texture(Some(&self.colour.texture));
        gl.delete_texture(Some(&self.depth.texture));
    }
}

/// Renderbuffers under a framebuffer that is read back, never sampled.
fn renderbuffer(
    gl: &Gl,
    place: u32,
    format: u32,
    (width, height): (i32, i32),
) -> Result<WebGlRenderbuffer, GlError> {
    let buffer = gl.create_renderbuffer().ok_or(GlError::Lost)?;
    gl.bind_renderbuffer(Gl::RENDERBUFFER, Some(&buffer));
    gl.renderbuffer_storage(Gl::RENDERBUFFER, format, width, height);
    gl.framebuffer_renderbuffer(Gl::FRAMEBUFFER, place, Gl::RENDERBUFFER, Some(&buffer));
    Ok(buffer)
}

/// A target that is read back: the numbers of points, or a picture to be saved.
#[derive(Debug)]
pub struct ReadTarget {
    framebuffer: WebGlFramebuffer,
    buffers: [WebGlRenderbuffer; 2],
    size: (i32, i32),
}

impl ReadTarget {
    /// A target of the given size.
    ///
    /// # Errors
    /// [`GlError`] if the driver gives no object or cannot draw to it.
    pub fn new(gl: &Gl, width: i32, height: i32) -> Result<Self, GlError> {
        let framebuffer = framebuffer(gl)?;
        let size = (width, height);
        let buffers = [
            renderbuffer(gl, Gl::COLOR_ATTACHMENT0, Gl::RGBA8, size)?,
            renderbuffer(gl, Gl::DEPTH_ATTACHMENT, Gl::DEPTH_COMPONENT24, size)?,
        ];
        check(gl, width, height)?;
        Ok(Self {
            framebuffer,
            buffers,
            size,
        })
    }

    /// Reads what was drawn, r g b a, lowest row first. Waits for the graphics card.
    ///
    /// # Errors
    /// [`GlError::Read`] if the driver does not hand them out.
    pub fn read(&self, gl: &Gl, into: &mut [u8]) -> Result<(), GlError> {
        self.bind(gl);
        let ((width, height), format, kind) = (self.size, Gl::RGBA, Gl::UNSIGNED_BYTE);
        gl.read_pixels_with_opt_u8_array(0, 0, width, height, format, kind, Some(into))
            .map_err(|_| GlError::Read)
    }

    /// Makes it the target of drawing and reading.
    pub fn bind(&self, gl: &Gl) {
        gl.bind_framebuffer(Gl::FRAMEBUFFER, Some(&self.framebuffer));
    }

    /// Gives the memory back.
    pub fn delete(&self, gl: &Gl) {
        gl.delete_framebuffer(Some(&self.framebuffer));
        for buffer in &self.buffers {
            gl.delete_renderbuffer(Some(buffer));
        }
    }
}
