//! Lines of any width with round ends; a line of no length is a dot.

use bytemuck::NoUninit;
use glam::{Mat4, Vec2};

use crate::draw::gl::{Buffer, Gl, GlError, Program, VertexArray};

const VERTEX: &str = "
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 tint;
layout(location = 3) in float width;
uniform mat4 view_projection;
uniform vec2 viewport;
uniform float pixel_ratio;
out vec2 place;             // along and across the line, in pixels
flat out vec2 extent;       // length and half width
flat out vec4 colour;

void main() {
    vec4 a = view_projection * vec4(from, 1.0);
    vec4 b = view_projection * vec4(to, 1.0);
    // Cut off what lies before the near plane, where there is no perspective division.
    float before_a = a.z + a.w, before_b = b.z + b.w;
    if (before_a < 0.0 && before_b < 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (before_a < 0.0) a = mix(a, b, before_a / (before_a - before_b));
    if (before_b < 0.0) b = mix(b, a, before_b / (before_b - before_a));
    vec3 start = a.xyz / a.w, stop = b.xyz / b.w;
    vec2 along = (stop - start).xy * 0.5 * viewport;
    float len = length(along);
    vec2 direction = len > 1e-3 ? along / len : vec2(1.0, 0.0);
    vec2 across = vec2(-direction.y, direction.x);
    float half_width = width * 0.5 * pixel_ratio;
    float reach = half_width + 1.0;
    float end = float(gl_VertexID & 1);
    float side = gl_VertexID < 2 ? -1.0 : 1.0;
    vec2 offset = direction * reach * (end * 2.0 - 1.0) + across * reach * side;
    vec3 base = mix(start, stop, end);
    place = vec2(end * (len + 2.0 * reach) - reach, side * reach);
    extent = vec2(len, half_width);
    colour = tint;
    // Divided already: on the screen, depth and place are linear.
    gl_Position = vec4(base.xy + offset / (0.5 * viewport), base.z, 1.0);
}
";

const FRAGMENT: &str = "
in vec2 place;
flat in vec2 extent;
flat in vec4 colour;
uniform float opacity;
out vec4 fragment;

void main() {
    vec2 offset = vec2(place.x - clamp(place.x, 0.0, extent.x), place.y);
    float alpha = colour.a * opacity * clamp(extent.y + 0.5 - length(offset), 0.0, 1.0);
    if (alpha <= 0.0) discard;
    fragment = vec4(colour.rgb, alpha);
}
";

const UNIFORMS: [&str; 4] = ["view_projection", "viewport", "pixel_ratio", "opacity"];

/// A straight line, as the shader reads it.
#[derive(Debug, Clone, Copy, PartialEq, NoUninit)]
#[repr(C)]
pub struct Line {
    /// Start.
    pub from: [f32; 3],
    /// End.
    pub to: [f32; 3],
    /// Red, green, blue and opacity.
    pub colour: [u8; 4],
    /// Width in pixels of the page.
    pub width: f32,
}

/// Lines on the graphics card.
#[derive(Debug)]
pub struct LineBuffer {
    array: VertexArray,
    buffer: Buffer,
    count: usize,
}

impl LineBuffer {
    /// Without lines.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        let buffer = Buffer::vertices(gl)?;
        let array = VertexArray::new(gl)?;
        array.bind(gl);
        let stride = size_of::<Line>() as i32;
        array.floats(gl, &buffer, 0, 3, stride, 0);
        array.floats(gl, &buffer, 1, 3, stride, 12);
        array.unit_bytes(gl, &buffer, 2, stride, 24);
        array.floats(gl, &buffer, 3, 1, stride, 28);
        for place in 0..4 {
            gl.vertex_attrib_divisor(place, 1);
        }
        gl.bind_vertex_array(None);
        Ok(Self {
            array,
            buffer,
            count: 0,
        })
    }

    /// Replaces the lines.
    pub fn upload(&mut self, gl: &Gl, lines: &[Line]) {
        self.buffer.upload(gl, lines);
        self.count = lines.len();
    }

    /// Replaces the lines for one frame.
    pub fn stream(&mut self, gl: &Gl, lines: &[Line]) {
        self.buffer.stream(gl, lines);
        self.count = lines.len();
    }
}

/// Draws lines.
#[derive(Debug)]
pub struct Lines {
    program: Program,
}

impl Lines {
    /// Compiles the program.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        let program = Program::new(gl, "", VERTEX, FRAGMENT, &UNIFORMS)?;
        Ok(Self { program })
    }

    /// Draws into the current viewport of the given size, blended.
    pub fn draw(
        &self,
        gl: &Gl,
        lines: &LineBuffer,
        view_projection: &Mat4,
        viewport: Vec2,
        (pixel_ratio, opacity): (f32, f32),
    ) {
        let count = i32::try_from(lines.count).unwrap_or(i32::MAX);
        if count == 0 {
            return;
        }
        let program = &self.program;
        program.activate(gl);
        program.set_mat4(gl, "view_projection", view_projection);
        program.set_vec2(gl, "viewport", viewport);
        program.set_f32(gl, "pixel_ratio", pixel_ratio);
        program.set_f32(gl, "opacity", opacity);
        lines.array.bind(gl);
        gl.draw_arrays_instanced(Gl::TRIANGLE_STRIP, 0, 4, count);
        gl.bind_vertex_array(None);
    }
}
