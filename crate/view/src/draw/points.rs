//! Draws the points of one side: in their colours, or as their numbers for picking.

use glam::{Vec2, Vec3};

use crate::colouring::{ColourBy, Colouring};
use crate::draw::gl::{Buffer, Gl, GlError, Program, VertexArray};
use crate::draw::palette::{MAX_LABEL, Palette};
use crate::scene::Scene;
use crate::sight::Sight;

const VERTEX: &str = "
layout(location = 0) in vec3 position;
layout(location = 1) in uint label;
layout(location = 2) in float scalar;
layout(location = 3) in vec3 normal;
uniform mat4 view_projection;
uniform float scale;    // pixels per cloud unit at w = 1
uniform float diameter; // in cloud units; 0 where the size is in pixels
uniform vec2 pixels; // least and greatest diameter
uniform int colour_by;
uniform vec2 range;
uniform vec3 background;
uniform sampler2D label_table;
uniform sampler2D colour_map;
uniform vec3 clip_low, clip_high; // what lies outside this box is hidden
flat out vec4 colour;
#ifdef TILTED
uniform vec3 right, up, back;   // the camera's axes
uniform vec4 eye;               // w 1 in perspective, 0 where all rays are parallel
flat out vec3 tilt;             // depth across the disc: per half width, per half height; of a radius
#endif

void main() {
    uint row = min(label, MAX_LABEL);
    vec4 entry = texelFetch(label_table, ivec2(int(row & 1023u), int(row >> 10)), 0);
    int state = int(entry.a * 255.0 + 0.5);
#ifdef PICK
    if (state == 4) state = 0; // locked: lets the cursor through
#endif
    if (state < LEAST_STATE || any(lessThan(position, clip_low)) || any(greaterThan(position, clip_high))) {
        // Outside the clip volume: costs no fragment.
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        gl_PointSize = 1.0;
        colour = vec4(0.0);
        return;
    }
    gl_Position = view_projection * vec4(position, 1.0);
    gl_PointSize = clamp(diameter * scale / max(gl_Position.w, 1e-20), pixels.x, pixels.y);
    vec3 facing = vec3(0.0, 0.0, 1.0);
#ifdef TILTED
    vec3 offset = position - eye.xyz;
    vec2 centre = vec2(dot(offset, right), dot(offset, up)) / gl_Position.w;
    if (dot(normal, normal) > 0.1) facing = vec3(dot(normal, right), dot(normal, up), dot(normal, back));
    // Against the ray through the point, which in perspective is not the line of sight.
    float towards = dot(facing, vec3(-eye.w * centre, 1.0));
    vec2 slope = abs(towards) > 1e-3 ? -facing.xy / towards : vec2(0.0);
    // Seen nearly edge on, a disc would be thinner than a pixel.
    float steepness = length(slope), limit = gl_PointSize > 4.0 ? 3.0 : 1.0;
    if (steepness > limit) slope *= limit / steepness;
    float radius = 0.5 * gl_PointSize * gl_Position.w / scale;
    vec4 nearer = view_projection * vec4(position + back * radius, 1.0);
    tilt = vec3(slope, 0.5 * (nearer.z / nearer.w - gl_Position.z / gl_Position.w));
#endif
#ifdef PICK
    uint id = uint(gl_VertexID) + 1u;
    colour = vec4(id & 255u, (id >> 8) & 255u, (id >> 16) & 255u, id >> 24) / 255.0;
#else
    vec3 shown = entry.rgb;
    if (colour_by == 1 && isnan(scalar)) {
        shown = texelFetch(label_table, ivec2(0, 0), 0).rgb;
    } else if (colour_by == 1) {
        float share = clamp((scalar - range.x) / (range.y - range.x), 0.0, 1.0);
        float steps = float(textureSize(colour_map, 0).x);
        shown = textureLod(colour_map, vec2((share * (steps - 1.0) + 0.5) / steps, 0.5), 0.0).rgb;
    } else if (colour_by == 2 && dot(normal, normal) > 0.1) {
        shown = abs(normal) / length(normal);
    } else {
        // A light at the viewer. What is read off its colour stays as it is.
        shown *= 0.72 + 0.28 * abs(facing.z);
    }
    if (state == 1) shown = mix(background, shown, 0.16);
    // The alpha channel tells the next pass what is highlighted.
    colour = vec4(shown, state == 3 ? 0.5 : 1.0);
#endif
}
";

const FRAGMENT: &str = "
flat in vec4 colour;
out vec4 fragment;
#ifdef TILTED
flat in vec3 tilt;
#endif

void main() {
    vec2 offset = gl_PointCoord * 2.0 - 1.0;
#ifdef TILTED
    float nearer = dot(tilt.xy, vec2(offset.x, -offset.y));
    // Between a circle and the ellipse that the disc really is: neighbours are not always even.
    if (dot(offset, offset) + 0.5 * nearer * nearer > 1.0) discard;
    // Bulged a little: of discs that overlap in one surface the one with the nearest middle wins.
    gl_FragDepth = gl_FragCoord.z + (nearer - BULGE * dot(offset, offset)) * tilt.z;
#else
    if (dot(offset, offset) > 1.0) discard;
#endif
    fragment = colour;
}
";

const UNIFORMS: [&str; 15] = [
    "clip_low",
    "clip_high",
    "eye",
    "view_projection",
    "scale",
    "right",
    "up",
    "back",
    "diameter",
    "pixels",
    "colour_by",
    "range",
    "background",
    "label_table",
    "colour_map",
];

/// The points on the graphics card.
#[derive(Debug)]
pub struct Points {
    show: Program,
    /// Where normals are known, points are discs that lie in the surface: depth is continuous
    /// across them, so eye-dome lighting shades the shape and not the discs.
    show_tilted: Program,
    /// Tilted too, so that the point found is the one whose middle is nearest.
    pick: Program,
    positions: Buffer,
    normals: Buffer,
    sides: [SideBuffers; 2],
    count: usize,
    has_normals: bool,
    uploaded: (u64, u64),
}

#[derive(Debug)]
struct SideBuffers {
    array: VertexArray,
    labels: Buffer,
    scalars: Buffer,
    palette: Palette,
    uploaded: (u64, u64),
}

impl SideBuffers {
    fn new(gl: &Gl, positions: &Buffer) -> Result<Self, GlError> {
        let (labels, scalars) = (Buffer::vertices(gl)?, Buffer::vertices(gl)?);
        let array = VertexArray::new(gl)?;
        array.bind(gl);
        array.floats(gl, positions, 0, 3, 0, 0);
        array.integers(gl, &labels, 1);
        gl.bind_vertex_array(None);
        Ok(Self {
            array,
            labels,
            scalars,
            palette: Palette::new(gl)?,
            uploaded: (u64::MAX, u64::MAX),
        })
    }

    fn sync(&mut self, gl: &Gl, colouring: &Colouring) {
        let (labels, scalars) = (colouring.labels(), colouring.scalars());
        if self.uploaded.0 != labels.revision() {
            self.labels.upload(gl, labels.get());
        }
        if self.uploaded.1 != scalars.revision() {
            self.scalars.upload(gl, scalars.get());
            self.array.bind(gl);
            if scalars.get().is_empty() {
                gl.disable_vertex_attrib_array(2);
            } else {
                self.array.floats(gl, &self.scalars, 2, 1, 0, 0);
            }
            gl.bind_vertex_array(None);
        }
        self.uploaded = (labels.revision(), scalars.revision());
        self.palette.sync(gl, colouring);
    }
}

impl Points {
    /// Programs and empty buffers.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        let program = |defines: &str| {
            let defines = format!("{defines}#define MAX_LABEL {MAX_LABEL}u\n");
            Program::new(gl, &defines, VERTEX, FRAGMENT, &UNIFORMS)
        };
        let positions = Buffer::vertices(gl)?;
        Ok(Self {
            show: program("#define LEAST_STATE 1\n")?,
            show_tilted: program("#define TILTED\n#define BULGE 0.02\n#define LEAST_STATE 1\n")?,
            // What is faded or locked lets the cursor through to what is not.
            pick: program(
                "#define PICK\n#define TILTED\n#define BULGE 0.3\n#define LEAST_STATE 2\n",
            )?,
            sides: [
                SideBuffers::new(gl, &positions)?,
                SideBuffers::new(gl, &positions)?,
            ],
            normals: Buffer::vertices(gl)?,
            positions,
            count: 0,
            has_normals: false,
            uploaded: (u64::MAX, u64::MAX),
        })
    }

    /// Uploads what has changed since the last time.
    pub fn sync(&mut self, gl: &Gl, scene: &Scene) {
        let (cloud, normals) = (&scene.cloud, &scene.normals);
        if self.uploaded.0 != cloud.revision() {
            self.positions.upload(gl, cloud.get().positions());
            self.count = cloud.get().len();
        }
        if self.uploaded.1 != normals.revision() {
            self.normals.upload(gl, normals.get());
            self.has_normals = !normals.get().is_empty();
            for side in &self.sides {
                side.array.bind(gl);
                if normals.get().is_empty() {
                    gl.disable_vertex_attrib_array(3);
                } else {
                    side.array.signed_bytes(gl, &self.normals, 3);
                }
            }
            gl.bind_vertex_array(None);
        }
        self.uploaded = (cloud.revision(), normals.revision());
        for (side, colouring) in self.sides.iter_mut().zip(&scene.colourings) {
            side.sync(gl, colouring);
        }
    }

    /// Draws a pane's points into the bound target, with depth test. What is faded is mixed with
    /// the background.
    pub fn draw(&self, gl: &Gl, sight: &Sight, colour_by: ColourBy, background: Vec3) {
        let program = if self.has_normals {
            &self.show_tilted
        } else {
            &self.show
        };
        program.activate(gl);
        let (mode, range) = match colour_by {
            ColourBy::Label => (0, Vec2::Y),
            ColourBy::Scalar { low, high } => {
                (1, Vec2::new(low, high.max(low + f32::MIN_POSITIVE)))
            }
            ColourBy::Normal => (2, Vec2::Y),
        };
        program.set_i32(gl, "colour_by", mode);
        program.set_vec2(gl, "range", range);
        program.set_vec3(gl, "background", background);
        program.set_i32(gl, "colour_map", 1);
        self.draw_with(gl, program, sight);
    }

    /// Draws the numbers (1 + place in the shuffled order, as little-endian r g b a) of the points
    /// that can be picked.
    pub fn draw_ids(&self, gl: &Gl, sight: &Sight) {
        self.pick.activate(gl);
        self.draw_with(gl, &self.pick, sight);
    }

    fn draw_with(&self, gl: &Gl, program: &Program, sight: &Sight) {
        let Sight {
            pane,
            lens,
            scale,
            count,
            clip,
        } = sight;
        let count = i32::try_from(*count.min(&self.count)).unwrap_or(i32::MAX);
        let Some(side) = self.sides.get(pane.side.index()) else {
            return;
        };
        if count == 0 {
            return;
        }
        program.set_i32(gl, "label_table", 0);
        program.set_vec3(gl, "right", lens.rotation * Vec3::X);
        program.set_vec3(gl, "up", lens.rotation * Vec3::Y);
        program.set_vec3(gl, "back", lens.rotation * Vec3::Z);
        program.set_vec4(gl, "eye", lens.eye.extend(f32::from(lens.perspective)));
        program.set_mat4(gl, "view_projection", &lens.view_projection);
        program.set_f32(gl, "scale", lens.scale);
        program.set_f32(gl, "diameter", scale.diameter);
        program.set_vec3(gl, "clip_low", clip.low);
        program.set_vec3(gl, "clip_high", clip.high);
        program.set_vec2(gl, "pixels", Vec2::new(scale.least, scale.greatest));
        side.palette.bind(gl);
        side.array.bind(gl);
        gl.draw_arrays(Gl::POINTS, 0, count);
        gl.bind_vertex_array(None);
    }
}
