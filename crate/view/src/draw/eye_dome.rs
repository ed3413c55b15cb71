//! Eye-dome lighting, the outline of what is highlighted, and the background: the pass that brings
//! the points onto the canvas.
//!
//! Eye-dome lighting (Boucheny 2009, *Interactive scientific visualization of large datasets*,
//! ch. 4) shades a pixel by how far its neighbours lie before it. It needs depth alone, no normals.

use glam::{Vec2, Vec3, Vec4};

use crate::camera::Lens;
use crate::draw::gl::{Gl, GlError, Program, SceneTarget, VertexArray};
use crate::layout::Rect;

const VERTEX: &str = "
void main() {
    // One triangle that covers the viewport.
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
";

const FRAGMENT: &str = "
uniform sampler2D colours;
uniform sampler2D depths;
uniform ivec4 bounds;      // the pane: least x, y, greatest x, y
uniform vec3 clip;         // near, far, and the camera's distance where orthographic, else 0
uniform vec2 lighting;     // strength, radius in pixels
uniform vec4 background;   // premultiplied
uniform vec4 outline;      // colour, width in pixels
out vec4 fragment;

const vec2 AROUND[8] = vec2[8](
    vec2(1.0, 0.0), vec2(0.7071, 0.7071), vec2(0.0, 1.0), vec2(-0.7071, 0.7071),
    vec2(-1.0, 0.0), vec2(-0.7071, -0.7071), vec2(0.0, -1.0), vec2(0.7071, -0.7071));

ivec2 neighbour(vec2 offset) {
    return clamp(ivec2(gl_FragCoord.xy + offset), bounds.xy, bounds.zw);
}

// Differences of this are relative to the distance from the eye, in either projection.
float log_depth(float depth) {
    if (clip.z > 0.0) return 1.4427 * (clip.x + depth * (clip.y - clip.x)) / clip.z;
    return log2(clip.x * clip.y / (clip.y - depth * (clip.y - clip.x)));
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(colours, here, 0);
    float depth = texelFetch(depths, here, 0).r;
    bool empty = depth >= 1.0;
    bool highlighted = !empty && colour.a < 0.75;
    gl_FragDepth = depth;
    fragment = empty ? background : vec4(colour.rgb, 1.0);

    if (!empty && lighting.x > 0.0) {
        float middle = log_depth(depth);
        float response = 0.0;
        for (int i = 0; i < 8; i++) {
            float other = texelFetch(depths, neighbour(AROUND[i] * lighting.y), 0).r;
            if (other < 1.0) response += max(0.0, middle - log_depth(other));
        }
        // The floor keeps dark segments apart from black, which has a meaning of its own.
        float shade = max(exp(-response * 0.125 * 120.0 * lighting.x), 0.3);
        fragment.rgb *= shade;
    }
    if (!highlighted && outline.w > 0.0) {
        for (int i = 0; i < 8; i++) {
            ivec2 there = neighbour(AROUND[i] * outline.w);
            float alpha = texelFetch(colours, there, 0).a;
            if (alpha > 0.25 && alpha < 0.75) {
                fragment = vec4(outline.rgb, 1.0);
                // Patches and lines lie behind an outline where they lie behind its points.
                gl_FragDepth = min(gl_FragDepth, texelFetch(depths, there, 0).r);
                break;
            }
        }
    }
}
";

const UNIFORMS: [&str; 7] = [
    "colours",
    "depths",
    "bounds",
    "clip",
    "lighting",
    "background",
    "outline",
];

/// How the points are brought onto the canvas.
#[derive(Debug, Clone, Copy)]
pub struct Finish {
    /// Strength of eye-dome lighting, 0 off, about 1 usual.
    pub strength: f32,
    /// How far the neighbours are that shade a pixel, in pixels.
    pub radius: f32,
    /// Colour behind everything; premultiplied, so transparent black leaves the picture clear.
    pub background: Vec4,
    /// Colour of outlines.
    pub outline: Vec3,
    /// Width of outlines in pixels.
    pub outline_width: f32,
}

/// The pass.
#[derive(Debug)]
pub struct EyeDome {
    program: Program,
    array: VertexArray,
}

impl EyeDome {
    /// Compiles it.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        Ok(Self {
            program: Program::new(gl, "", VERTEX, FRAGMENT, &UNIFORMS)?,
            array: VertexArray::new(gl)?,
        })
    }

    /// Draws a pane's points, colour and depth, onto the bound target. The viewport must cover the
    /// whole target and the scissor the pane.
    pub fn draw(&self, gl: &Gl, points: &SceneTarget, pane: Rect, lens: &Lens, finish: &Finish) {
        let program = &self.program;
        program.activate(gl);
        points.colour.bind(gl, 0);
        points.depth.bind(gl, 1);
        program.set_i32(gl, "colours", 0);
        program.set_i32(gl, "depths", 1);
        let bounds = [
            pane.x,
            pane.y,
            pane.x + pane.width - 1,
            pane.y + pane.height - 1,
        ];
        program.set_ivec4(gl, "bounds", bounds);
        let distance = if lens.perspective {
            0.0
        } else {
            lens.reference
        };
        program.set_vec3(gl, "clip", Vec3::new(lens.near, lens.far, distance));
        program.set_vec2(gl, "lighting", Vec2::new(finish.strength, finish.radius));
        program.set_vec4(gl, "background", finish.background);
        program.set_vec4(gl, "outline", finish.outline.extend(finish.outline_width));
        self.array.bind(gl);
        gl.depth_func(Gl::ALWAYS);
        gl.draw_arrays(Gl::TRIANGLES, 0, 3);
        gl.depth_func(Gl::LEQUAL);
        gl.bind_vertex_array(None);
        // A texture that stays bound could not be drawn into.
        gl.active_texture(Gl::TEXTURE1);
        gl.bind_texture(Gl::TEXTURE_2D, None);
        gl.active_texture(Gl::TEXTURE0);
        gl.bind_texture(Gl::TEXTURE_2D, None);
    }
}
