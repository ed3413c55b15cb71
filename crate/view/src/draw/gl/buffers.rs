//! Vertex buffers and vertex arrays.

use web_sys::{WebGlBuffer, WebGlVertexArrayObject};

use super::{Gl, GlError};

/// A buffer of vertices or of indices.
#[derive(Debug)]
pub struct Buffer {
    buffer: WebGlBuffer,
    target: u32,
}

impl Buffer {
    /// An empty buffer of vertex attributes.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn vertices(gl: &Gl) -> Result<Self, GlError> {
        Self::new(gl, Gl::ARRAY_BUFFER)
    }

    /// An empty buffer of indices.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn indices(gl: &Gl) -> Result<Self, GlError> {
        Self::new(gl, Gl::ELEMENT_ARRAY_BUFFER)
    }

    fn new(gl: &Gl, target: u32) -> Result<Self, GlError> {
        let buffer = gl.create_buffer().ok_or(GlError::Lost)?;
        Ok(Self { buffer, target })
    }

    /// Replaces the content by data that will be drawn many times.
    pub fn upload<T: bytemuck::NoUninit>(&self, gl: &Gl, data: &[T]) {
        self.fill(gl, data, Gl::STATIC_DRAW);
    }

    /// Replaces the content by data for one frame.
    pub fn stream<T: bytemuck::NoUninit>(&self, gl: &Gl, data: &[T]) {
        self.fill(gl, data, Gl::STREAM_DRAW);
    }

    /// Makes room for so many values, of which none is known yet.
    pub fn reserve<T: bytemuck::NoUninit>(&self, gl: &Gl, count: usize) {
        let bytes = i32::try_from(count * size_of::<T>()).unwrap_or(i32::MAX);
        gl.bind_buffer(self.target, Some(&self.buffer));
        gl.buffer_data_with_i32(self.target, bytes, Gl::STATIC_DRAW);
    }

    /// Writes values from a place on, into the room that was made.
    pub fn write<T: bytemuck::NoUninit>(&self, gl: &Gl, place: usize, values: &[T]) {
        let offset = i32::try_from(place * size_of::<T>()).unwrap_or(i32::MAX);
        gl.bind_buffer(self.target, Some(&self.buffer));
        gl.buffer_sub_data_with_i32_and_u8_array(self.target, offset, bytemuck::cast_slice(values));
    }

    fn fill<T: bytemuck::NoUninit>(&self, gl: &Gl, data: &[T], usage: u32) {
        gl.bind_buffer(self.target, Some(&self.buffer));
        gl.buffer_data_with_u8_array(self.target, bytemuck::cast_slice(data), usage);
    }

    /// Binds it, for the attribute pointers or index draws that follow.
    pub fn bind(&self, gl: &Gl) {
        gl.bind_buffer(self.target, Some(&self.buffer));
    }
}

/// Which buffers feed which attributes.
#[derive(Debug)]
pub struct VertexArray {
    array: WebGlVertexArrayObject,
}

impl VertexArray {
    /// One with nothing attached.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        let array = gl.create_vertex_array().ok_or(GlError::Lost)?;
        Ok(Self { array })
    }

    /// Makes it current.
    pub fn bind(&self, gl: &Gl) {
        gl.bind_vertex_array(Some(&self.array));
    }

    /// Feeds an attribute with floats. The vertex array must be bound.
    pub fn floats(
        &self,
        gl: &Gl,
        buffer: &Buffer,
        place: u32,
        size: i32,
        stride: i32,
        offset: i32,
    ) {
        buffer.bind(gl);
        gl.enable_vertex_attrib_array(place);
        gl.vertex_attrib_pointer_with_i32(place, size, Gl::FLOAT, false, stride, offset);
    }

    /// Feeds an attribute with unsigned integers. The vertex array must be bound.
    pub fn integers(&self, gl: &Gl, buffer: &Buffer, place: u32) {
        buffer.bind(gl);
        gl.enable_vertex_attrib_array(place);
        gl.vertex_attrib_i_pointer_with_i32(place, 1, Gl::UNSIGNED_INT, 0, 0);
    }

    /// Feeds an attribute with four signed bytes that stand for −1 to 1.
    pub fn signed_bytes(&self, gl: &Gl, buffer: &Buffer, place: u32) {
        buffer.bind(gl);
        gl.enable_vertex_attrib_array(place);
        gl.vertex_attrib_pointer_with_i32(place, 4, Gl::BYTE, true, 4, 0);
    }

    /// Feeds an attribute with four bytes that stand for 0 to 1.
    pub fn unit_bytes(&self, gl: &Gl, buffer: &Buffer, place: u32, stride: i32, offset: i32) {
        buffer.bind(gl);
        gl.enable_vertex_attrib_array(place);
        gl.vertex_attrib_pointer_with_i32(place, 4, Gl::UNSIGNED_BYTE, true, stride, offset);
    }
}
