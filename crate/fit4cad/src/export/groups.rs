//! Vertex groups (`.vg`), as Easy3D reads them.

use std::fmt::Write;

use super::About;
use super::points::in_one_line;
use crate::cloud::{Cloud, Point};
use crate::format::foreign::VERTEX_GROUP_TYPES;
use crate::model::{Primitive, Segmentation};
use crate::surface::Surface;

/// Number of a group of another type than those that have one.
const GENERAL: usize = 5;

/// The points of the cloud, which have numbers of their own here, and a group for each primitive.
pub(super) fn vg(cloud: &Cloud, segmentation: &Segmentation, about: &About) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "num_points: {}", cloud.len());
    for point in cloud.points() {
        let _ = writeln!(text, "{} {} {}", point.x, point.y, point.z);
    }
    text.push_str("num_colors: 0\nnum_normals: 0\n");
    let _ = writeln!(text, "num_groups: {}", segmentation.primitives.len());
    for (place, primitive) in segmentation.primitives.iter().enumerate() {
        group(&mut text, place, primitive, about);
    }
    text
}

fn group(text: &mut String, place: usize, primitive: &Primitive, about: &About) {
    let number = |kind| VERTEX_GROUP_TYPES.iter().position(|known| *known == kind);
    let kind = primitive.kind.and_then(number).unwrap_or(GENERAL);
    let parameters = primitive
        .surface
        .map(|surface| parameters(&surface))
        .unwrap_or_default();
    let _ = writeln!(text, "group_type: {kind}");
    let _ = writeln!(text, "num_group_parameters: {}", parameters.len());
    text.push_str("group_parameters:");
    for value in parameters {
        let _ = write!(text, " {value}");
    }
    let name = primitive.kind.map_or("Primitive", |kind| kind.name());
    let _ = writeln!(
        text,
        "\ngroup_label: {}{}",
        in_one_line(name),
        primitive.number
    );
    let [r, g, b] = about
        .colour(Some(place))
        .map(|channel| f64::from(channel) / 255.0);
    let _ = writeln!(text, "group_color: {r:.4} {g:.4} {b:.4}");
    let _ = writeln!(text, "group_num_point: {}", primitive.points.len());
    for index in &primitive.points {
        let _ = write!(text, "{index} ");
    }
    text.push_str("\nnum_children: 0\n");
}

/// The parameters in the order of the type: a plane's a, b, c, d of ax + by + cz + d = 0, which is
/// all that readers use; for the others position, axis, radii and angle.
fn parameters(surface: &Surface) -> Vec<f64> {
    let joined = |point: &Point, axis: [f64; 3], more: &[f64]| {
        let point: [f64; 3] = (*point).into();
        [&point[..], &axis, more].concat()
    };
    match surface {
        Surface::Plane(plane) => {
            let normal: [f64; 3] = plane.normal.into_inner().into();
            [&normal[..], &[-plane.offset]].concat()
        }
        Surface::Cylinder(it) => joined(&it.centre, it.axis.into_inner().into(), &[it.radius]),
        Surface::Cone(it) => joined(&it.apex, it.axis.into_inner().into(), &[it.half_angle]),
        Surface::Sphere(it) => {
            let centre: [f64; 3] = it.centre.into();
            [&centre[..], &[it.radius]].concat()
        }
        Surface::Torus(it) => joined(
            &it.centre,
            it.axis.into_inner().into(),
            &[it.major_radius, it.minor_radius],
        ),
    }
}
