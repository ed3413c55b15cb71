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
    placed: Uploaded,
    turned: Uploaded,
    has_normals: bool,
}

/// How much of a list is on the graphics card.
#[derive(Debug)]
struct Uploaded {
    revision: u64,
    count: usize,
}

impl Uploaded {
    fn nothing() -> Self {
        Self {
            revision: u64::MAX,
            count: 0,
        }
    }

    /// Uploads what has come since the last time of a list that will have so many values. Returns whether
    /// it is another list than then.
    fn sync<T: bytemuck::NoUninit>(
        &mut self,
        gl: &Gl,
        buffer: &Buffer,
        (revision, values, total): (u64, &[T], usize),
    ) -> bool {
        let is_other = self.revision != revision;
        if is_other {
            buffer.reserve::<T>(gl, total);
            *self = Self { revision, count: 0 };
        }
        if let Some(new) = values.get(self.count..).filter(|new| !new.is_empty()) {
            buffer.write(gl, self.count, new);
            self.count = values.len();
        }
        is_other
    }
}

#[derive(Debug)]
struct SideBuffers {
    array: VertexArray,
    labels: Buffer,
    scalars: Buffer,
    palette: Palette,
    labelled: Uploaded,
    measured: Uploaded,
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
            labelled: Uploaded::nothing(),
            measured: Uploaded::nothing(),
        })
    }

    fn sync(&mut self, gl: &Gl, colouring: &Colouring, total: usize) {
        let (labels, scalars) = (colouring.labels(), colouring.scalars());
        let values = (labels.revision(), labels.get().values(), total);
        self.labelled.sync(gl, &self.labels, values);
        let room = if scalars.get().is_wanted() { total } else { 0 };
        let values = (scalars.revision(), scalars.get().values(), room);
        if self.measured.sync(gl, &self.scalars, values) {
            self.array.bind(gl);
            if scalars.get().is_wanted() {
                self.array.floats(gl, &self.scalars, 2, 1, 0, 0);
            } else {
                gl.disable_vertex_attrib_array(2);
            }
            gl.bind_vertex_array(None);
        }
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
            placed: Uploaded::nothing(),
            turned: Uploaded::nothing(),
            has_normals: false,
        })
    }

    /// Uploads what has changed or come since the last time.
    pub fn sync(&mut self, gl: &Gl, scene: &Scene) {
        let (cloud, normals) = (&scene.cloud, &scene.normals);
        let total = cloud.get().len();
        let values = (cloud.revision(), cloud.get().positions(), total);
        self.placed.sync(gl, &self.positions, values);
        let is_wanted = normals.get().is_wanted();
        let room = if is_wanted { total } else { 0 };
        let values = (normals.revision(), normals.get().values(), room);
        self.turned.sync(gl, &self.normals, values);
        // Points are not tilted before all of them can be.
        let has_normals = is_wanted && self.turned.count == total;
        if self.has_normals != has_normals {
            self.has_normals = has_normals;
            for side in &self.sides {
                side.array.bind(gl);
                if has_normals {
                    side.array.signed_bytes(gl, &self.normals, 3);
                } else {
                    gl.disable_vertex_attrib_array(3);
                }
            }
            gl.bind_vertex_array(None);
        }
        for (side, colouring) in self.sides.iter_mut().zip(&scene.colourings) {
            side.sync(gl, colouring, total);
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
        let Some(side) = self.sides.get(pane.side.index()) else {
            return;
        };
        let count = *count.min(&self.placed.count.min(side.labelled.count));
        let count = i32::try_from(count).unwrap_or(i32::MAX);
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
