//! Draws patches of fitted surfaces: translucent meshes with their rims, axes, radii and apexes.

use glam::{Vec2, Vec3};

use crate::camera::Lens;
use crate::clip::Clip;
use crate::draw::gl::{Buffer, Gl, GlError, Program, VertexArray};
use crate::draw::lines::{Line, LineBuffer, Lines};
use crate::layout::Side;
use crate::patch::{Mark, SurfacePatch};
use crate::scene::Scene;

const VERTEX: &str = "
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 towards;   // to the viewer where all rays are parallel, else 0
uniform float lift;
out vec3 outer;
out vec3 ray;
out vec3 place;

void main() {
    place = position;
    ray = towards == vec3(0.0) ? normalize(eye - position) : towards;
    outer = normal;
    // Lifted off its own points, which it would otherwise cover in speckles.
    gl_Position = view_projection * vec4(position + ray * lift, 1.0);
}
";

const FRAGMENT: &str = "
in vec3 outer;
in vec3 ray;
in vec3 place;
uniform vec3 clip_low, clip_high; // what lies outside this box is hidden
uniform vec3 colour;
uniform float opacity;
uniform float facing;   // 1 draws what faces the viewer, -1 the rest
out vec4 fragment;

void main() {
    if (any(lessThan(place, clip_low)) || any(greaterThan(place, clip_high))) discard;
    float slant = dot(normalize(outer), normalize(ray));
    if (slant * facing < 0.0) discard;
    float sheen = pow(abs(slant), 24.0) * 0.35;
    // Seen at a slant there is more of a translucent sheet to look through.
    float cover = opacity * mix(1.6, 1.0, abs(slant));
    fragment = vec4(mix(colour, vec3(1.0), sheen), min(cover, 1.0));
}
";

const UNIFORMS: [&str; 9] = [
    "clip_low",
    "clip_high",
    "view_projection",
    "eye",
    "towards",
    "lift",
    "colour",
    "opacity",
    "facing",
];

/// Opacity of a patch seen straight on.
const OPACITY: f32 = 0.34;
/// Opacity of lines that lie behind points.
const BEHIND: f32 = 0.4;

/// Where a patch's triangles are in the common index buffer.
#[derive(Debug, Clone, Copy)]
struct Piece {
    side: Side,
    colour: Vec3,
    centre: Vec3,
    first: i32,
    count: i32,
}

/// The patches on the graphics card.
#[derive(Debug)]
pub struct Patches {
    program: Program,
    array: VertexArray,
    vertices: Buffer,
    indices: Buffer,
    lines: [LineBuffer; 2],
    pieces: Vec<Piece>,
    uploaded: Option<(u64, [u8; 3])>,
}

impl Patches {
    /// Without patches.
    ///
    /// # Errors
    /// [`GlError`] if the driver refuses a shader or gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        let (vertices, indices) = (Buffer::vertices(gl)?, Buffer::indices(gl)?);
        let array = VertexArray::new(gl)?;
        array.bind(gl);
        array.floats(gl, &vertices, 0, 3, 24, 0);
        array.floats(gl, &vertices, 1, 3, 24, 12);
        indices.bind(gl);
        gl.bind_vertex_array(None);
        Ok(Self {
            program: Program::new(gl, "", VERTEX, FRAGMENT, &UNIFORMS)?,
            array,
            vertices,
            indices,
            lines: [LineBuffer::new(gl)?, LineBuffer::new(gl)?],
            pieces: Vec::new(),
            uploaded: None,
        })
    }

    /// Uploads what has changed: patches, or the ink that marks are drawn with.
    pub fn sync(&mut self, gl: &Gl, scene: &Scene) {
        let ink = scene
            .display
            .ink
            .to_array()
            .map(|channel| (channel * 255.0).round() as u8);
        let current = Some((scene.patches.revision(), ink));
        if self.uploaded == current {
            return;
        }
        self.uploaded = current;
        let patches = scene.patches.get();
        let (mut vertices, mut indices) = (Vec::new(), Vec::new());
        self.pieces.clear();
        for patch in patches {
            let before = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
            let first = i32::try_from(indices.len()).unwrap_or(i32::MAX);
            indices.extend(
                patch
                    .triangles
                    .iter()
                    .map(|corner| corner.saturating_add(before)),
            );
            let count = i32::try_from(patch.triangles.len()).unwrap_or(i32::MAX);
            let sum: Vec3 = patch
                .vertices
                .iter()
                .map(|&[x, y, z, ..]| Vec3::new(x, y, z))
                .sum();
            self.pieces.push(Piece {
                side: patch.side,
                colour: Vec3::from_array(patch.colour.map(|channel| f32::from(channel) / 255.0)),
                centre: sum / patch.vertices.len().max(1) as f32,
                first,
                count,
            });
            vertices.extend_from_slice(&patch.vertices);
        }
        self.vertices.upload(gl, &vertices);
        // Bound with its vertex array: an index buffer belongs to the array.
        self.array.bind(gl);
        self.indices.upload(gl, &indices);
        gl.bind_vertex_array(None);
        for (side, buffer) in Side::BOTH.into_iter().zip(&mut self.lines) {
            let lines: Vec<Line> = patches
                .iter()
                .filter(|patch| patch.side == side)
                .flat_map(|patch| styled_lines(patch, ink))
                .collect();
            buffer.upload(gl, &lines);
        }
    }

    /// Draws the patches of a side, farthest first, and their lines over the points already in the
    /// depth buffer.
    pub fn draw(
        &mut self,
        gl: &Gl,
        lines: &Lines,
        side: Side,
        lens: &Lens,
        clip: &Clip,
        (viewport, pixel_ratio, lift): (Vec2, f32, f32),
    ) {
        if self.pieces.is_empty() {
            return;
        }
        gl.enable(Gl::BLEND);
        gl.depth_mask(false);
        let program = &self.program;
        program.activate(gl);
        program.set_mat4(gl, "view_projection", &lens.view_projection);
        program.set_vec3(gl, "eye", lens.eye);
        let towards = (!lens.perspective).then_some(lens.rotation * Vec3::Z);
        program.set_vec3(gl, "towards", towards.unwrap_or(Vec3::ZERO));
        program.set_f32(gl, "lift", lift);
        program.set_vec3(gl, "clip_low", clip.low);
        program.set_vec3(gl, "clip_high", clip.high);
        program.set_f32(gl, "opacity", OPACITY);
        self.array.bind(gl);
        let eye = lens.eye;
        let distance = |piece: &Piece| match towards {
            Some(towards) => (eye - piece.centre).dot(towards),
            None => eye.distance(piece.centre),
        };
        // By insertion: from frame to frame the order hardly changes.
        for end in 1..self.pieces.len() {
            let mut place = end;
            while place > 0 && distance(&self.pieces[place]) > distance(&self.pieces[place - 1]) {
                self.pieces.swap(place, place - 1);
                place -= 1;
            }
        }
        for piece in self.pieces.iter().filter(|piece| piece.side == side) {
            program.set_vec3(gl, "colour", piece.colour);
            // Of one patch the far side first: most are convex, or nearly.
            for facing in [-1.0, 1.0] {
                program.set_f32(gl, "facing", facing);
                let offset = piece.first.saturating_mul(4);
                gl.draw_elements_with_i32(Gl::TRIANGLES, piece.count, Gl::UNSIGNED_INT, offset);
            }
        }
        gl.bind_vertex_array(None);
        if let Some(buffer) = self.lines.get(side.index()) {
            // An axis lies inside its points: what they hide shows through faintly.
            for (test, opacity) in [(Gl::GREATER, BEHIND), (Gl::LEQUAL, 1.0)] {
                gl.depth_func(test);
                lines.draw(
                    gl,
                    buffer,
                    &lens.view_projection,
                    viewport,
                    (pixel_ratio, opacity),
                );
            }
        }
        gl.depth_mask(true);
        gl.disable(Gl::BLEND);
    }
}

/// The lines of a patch: marks take the ink, rims the colour of the patch.
fn styled_lines(patch: &SurfacePatch, ink: [u8; 3]) -> impl Iterator<Item = Line> {
    let of_patch = patch.colour;
    patch.lines.iter().map(move |&(mark, [a, b, c, d, e, f])| {
        let ([r, g, blue], width) = match mark {
            Mark::Rim => (of_patch, 2.0),
            Mark::Axis => (ink, 1.4),
            Mark::Radius => (ink, 2.0),
            Mark::Centre => (ink, 7.0),
        };
        Line {
            from: [a, b, c],
            to: [d, e, f],
            colour: [r, g, blue, 255],
            width,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_take_the_ink_and_rims_the_colour_of_the_patch() {
        let patch = SurfacePatch::new(Side::First, [9, 8, 7], &[], &[], &[])
            .with_lines(&[0.0; 12], &[0, 1]);
        let colours: Vec<_> = styled_lines(&patch, [1, 1, 1])
            .map(|line| line.colour)
            .collect();
        assert_eq!(colours, [[9, 8, 7, 255], [1, 1, 1, 255]]);
    }
}
