//! The patches of surfaces that the points cover, as meshes.

use std::fmt::Write;

use super::About;
use super::points::in_one_line;
use super::table::quoted;
use crate::cloud::{Bounds, Cloud, Point, Vector};
use crate::model::{Primitive, Segmentation};
use crate::surface::patch::Patch;

/// The patch of each primitive that has one, with its place and name.
fn patches(cloud: &Cloud, segmentation: &Segmentation) -> Vec<(usize, String, Patch)> {
    let primitives = segmentation.primitives.iter().enumerate();
    primitives
        .filter_map(|(place, primitive)| Some((place, name(primitive), patch(cloud, primitive)?)))
        .collect()
}

fn patch(cloud: &Cloud, primitive: &Primitive) -> Option<Patch> {
    let points = primitive.points.iter();
    let points: Vec<Point> = points
        .filter_map(|&index| cloud.points().get(index as usize).copied())
        .collect();
    Patch::new(primitive.surface.as_ref()?, &points)
}

fn name(primitive: &Primitive) -> String {
    let kind = primitive.kind.map_or("Primitive", |kind| kind.name());
    format!("{kind}_{}", primitive.number)
}

pub(super) fn obj(cloud: &Cloud, segmentation: &Segmentation, about: &About) -> String {
    let mut text = format!(
        "# {}, {}\n",
        in_one_line(&about.model),
        in_one_line(&about.method)
    );
    let mut before = 1;
    for (place, name, patch) in patches(cloud, segmentation) {
        let _ = writeln!(text, "o {name}");
        let [r, g, b] = about
            .colour(Some(place))
            .map(|channel| f64::from(channel) / 255.0);
        for vertex in &patch.vertices {
            let _ = writeln!(
                text,
                "v {} {} {} {r:.4} {g:.4} {b:.4}",
                vertex.x, vertex.y, vertex.z
            );
        }
        for normal in &patch.normals {
            let _ = writeln!(text, "vn {} {} {}", normal.x, normal.y, normal.z);
        }
        for corners in &patch.triangles {
            let [a, b, c] = corners.map(|corner| corner + before);
            let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
        }
        before += patch.vertices.len() as u32;
    }
    text
}

/// Binary STL: single precision, as it knows no other.
pub(super) fn stl(cloud: &Cloud, segmentation: &Segmentation) -> Vec<u8> {
    let mut file = vec![b' '; 80];
    let patches = patches(cloud, segmentation);
    let count: usize = patches
        .iter()
        .map(|(_, _, patch)| patch.triangles.len())
        .sum();
    file.extend((count as u32).to_le_bytes());
    for (_, _, patch) in &patches {
        for corners in &patch.triangles {
            let corners = corners.map(|corner| {
                patch
                    .vertices
                    .get(corner as usize)
                    .copied()
                    .unwrap_or(Point::origin())
            });
            let [a, b, c] = corners;
            let normal = (b - a)
                .cross(&(c - a))
                .try_normalize(0.0)
                .unwrap_or(Vector::zeros());
            let numbers = std::iter::once(normal).chain(corners.map(|corner| corner.coords));
            for vector in numbers {
                file.extend(
                    vector
                        .iter()
                        .flat_map(|&value| (value as f32).to_le_bytes()),
                );
            }
            file.extend([0, 0]);
        }
    }
    file
}

pub(super) fn ply(cloud: &Cloud, segmentation: &Segmentation, about: &About) -> Vec<u8> {
    let patches = patches(cloud, segmentation);
    let vertices: usize = patches
        .iter()
        .map(|(_, _, patch)| patch.vertices.len())
        .sum();
    let faces: usize = patches
        .iter()
        .map(|(_, _, patch)| patch.triangles.len())
        .sum();
    let mut file = format!(
        "ply\nformat binary_little_endian 1.0\ncomment {}, {}\nelement vertex {vertices}\n\
         property double x\nproperty double y\nproperty double z\nproperty uchar red\n\
         property uchar green\nproperty uchar blue\nproperty int primitive_index\n\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n",
        in_one_line(&about.model),
        in_one_line(&about.method),
    )
    .into_bytes();
    for (place, _, patch) in &patches {
        let number = segmentation
            .primitives
            .get(*place)
            .map_or(0, |it| it.number);
        for vertex in &patch.vertices {
            file.extend(vertex.iter().flat_map(|value| value.to_le_bytes()));
            file.extend(about.colour(Some(*place)));
            file.extend(number.to_le_bytes());
        }
    }
    let mut before = 0;
    for (_, _, patch) in &patches {
        for corners in &patch.triangles {
            file.push(3);
            file.extend(
                corners
                    .iter()
                    .flat_map(|corner| (corner + before).to_le_bytes()),
            );
        }
        before += patch.vertices.len() as u32;
    }
    file
}

/// Binary glTF 2.0: a mesh, a material and a node for each patch. Positions are single precision
/// relative to the middle of the patch, which its node moves back.
pub(super) fn glb(cloud: &Cloud, segmentation: &Segmentation, about: &About) -> Vec<u8> {
    let patches = patches(cloud, segmentation);
    let mut binary: Vec<u8> = Vec::new();
    let (mut views, mut accessors, mut meshes, mut materials, mut nodes) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut view = |bytes: Vec<u8>, target: u32| {
        views.push(format!(
            "{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{target}}}",
            binary.len(),
            bytes.len()
        ));
        binary.extend(bytes);
        views.len() - 1
    };
    for (at, (place, name, patch)) in patches.iter().enumerate() {
        let middle = Bounds::of(&patch.vertices).centre();
        let relative: Vec<[f32; 3]> = patch
            .vertices
            .iter()
            .map(|vertex| <[f64; 3]>::from(vertex - middle).map(|value| value as f32))
            .collect();
        let extreme = |start: f32, pick: fn(f32, f32) -> f32| {
            let axes = [0, 1, 2].map(|axis| relative.iter().map(|it| it[axis]).fold(start, pick));
            format!("[{:?},{:?},{:?}]", axes[0], axes[1], axes[2])
        };
        let single = |values: &mut dyn Iterator<Item = f32>| -> Vec<u8> {
            values.flat_map(f32::to_le_bytes).collect()
        };
        let positions = view(single(&mut relative.iter().flatten().copied()), 34962);
        let normals = patch
            .normals
            .iter()
            .flat_map(|it| it.iter().map(|&value| value as f32).collect::<Vec<_>>());
        let normals = view(single(&mut normals.into_iter()), 34962);
        let corners = patch
            .triangles
            .iter()
            .flatten()
            .flat_map(|corner| corner.to_le_bytes());
        let corners = view(corners.collect(), 34963);
        let count = patch.vertices.len();
        accessors.push(format!(
            "{{\"bufferView\":{positions},\"componentType\":5126,\"count\":{count},\"type\":\"VEC3\",\"min\":{},\"max\":{}}}",
            extreme(f32::INFINITY, f32::min),
            extreme(f32::NEG_INFINITY, f32::max)
        ));
        accessors.push(format!(
            "{{\"bufferView\":{normals},\"componentType\":5126,\"count\":{count},\"type\":\"VEC3\"}}"
        ));
        accessors.push(format!(
            "{{\"bufferView\":{corners},\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}}",
            3 * patch.triangles.len()
        ));
        let name = quoted(name);
        let first = 3 * at;
        meshes.push(format!(
            "{{\"name\":{name},\"primitives\":[{{\"attributes\":{{\"POSITION\":{first},\"NORMAL\":{}}},\"indices\":{},\"material\":{at}}}]}}",
            first + 1,
            first + 2
        ));
        let [r, g, b] = about.colour(Some(*place)).map(linear);
        materials.push(format!(
            "{{\"name\":{name},\"doubleSided\":true,\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{r:.4},{g:.4},{b:.4},1],\"metallicFactor\":0,\"roughnessFactor\":0.8}}}}"
        ));
        nodes.push(format!(
            "{{\"name\":{name},\"mesh\":{at},\"translation\":[{:?},{:?},{:?}]}}",
            middle.x, middle.y, middle.z
        ));
    }
    let places: Vec<String> = (0..nodes.len()).map(|at| at.to_string()).collect();
    let mut json = format!(
        "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"fit4cad {}\"}},\"scene\":0,\"scenes\":[{{\"name\":{}",
        env!("CARGO_PKG_VERSION"),
        quoted(&about.model),
    );
    // No list may be empty.
    if !nodes.is_empty() {
        let _ = write!(
            json,
            ",\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}],\"materials\":[{}],\"accessors\":[{}],\
             \"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}",
            places.join(","),
            nodes.join(","),
            meshes.join(","),
            materials.join(","),
            accessors.join(","),
            views.join(","),
            binary.len(),
        );
    } else {
        json.push_str("}]}");
    }
    let mut json = json.into_bytes();
    while !json.len().is_multiple_of(4) {
        json.push(b' ');
    }
    let chunk = |bytes: &[u8], kind: &[u8; 4]| {
        [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat()
    };
    let mut chunks = chunk(&json, b"JSON");
    if !binary.is_empty() {
        chunks.extend(chunk(&binary, b"BIN\0"));
    }
    let whole = (12 + chunks.len() as u32).to_le_bytes();
    [&b"glTF"[..], &2u32.to_le_bytes(), &whole, &chunks].concat()
}

/// A channel of sRGB as linear light, 0 to 1.
fn linear(channel: u8) -> f64 {
    let value = f64::from(channel) / 255.0;
    if value <= 0.040_45 {
        value / 12.92
    } else {
        libm::pow((value + 0.055) / 1.055, 2.4)
    }
}
