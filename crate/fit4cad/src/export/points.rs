//! Points with a label each.

use std::fmt::Write;

use super::About;
use crate::cloud::{Cloud, Point};
use crate::model::Segmentation;

/// The place of the primitive that each point belongs to: of several, the nearest surface's, or the
/// first's where that tells nothing.
pub(super) fn owners(cloud: &Cloud, segmentation: &Segmentation) -> Vec<Option<u32>> {
    let mut owners: Vec<Option<(u32, f64)>> = vec![None; cloud.len()];
    for (place, primitive) in (0u32..).zip(&segmentation.primitives) {
        for &index in &primitive.points {
            let (Some(owner), Some(point)) = (
                owners.get_mut(index as usize),
                cloud.points().get(index as usize),
            ) else {
                continue;
            };
            let surface = primitive.surface.as_ref();
            let distance = surface.map_or(f64::INFINITY, |surface| surface.distance(point));
            if owner.is_none_or(|(_, least)| distance < least) {
                *owner = Some((place, distance));
            }
        }
    }
    let places = owners.into_iter();
    places.map(|owner| owner.map(|(place, _)| place)).collect()
}

/// The number that a file gives the primitive at a place, as a label; -1 for none.
pub(super) fn label(segmentation: &Segmentation, owner: Option<u32>) -> i32 {
    let primitive = owner.and_then(|place| segmentation.primitives.get(place as usize));
    primitive.map_or(-1, |primitive| {
        i32::try_from(primitive.number).unwrap_or(-1)
    })
}

/// A row of the cloud's file: its point and what that belongs to, or three times NaN for one that could
/// not be read, so that later rows keep their numbers.
pub(super) fn rows<'a>(
    cloud: &'a Cloud,
    owners: &'a [Option<u32>],
) -> impl Iterator<Item = (Point, Option<u32>)> + 'a {
    let mut points = (0u32..).zip(cloud.points()).zip(owners).peekable();
    let numbers = 1..=cloud.numbering().rows() as u64;
    numbers.map(move |number| {
        let here = points.next_if(|((index, _), _)| cloud.numbering().number(*index) == number);
        here.map_or((Point::from([f64::NAN; 3]), None), |((_, point), owner)| {
            (*point, *owner)
        })
    })
}

pub(super) fn xyzc(cloud: &Cloud, segmentation: &Segmentation) -> String {
    let mut text = String::with_capacity(cloud.len() * 48);
    for (point, owner) in rows(cloud, &owners(cloud, segmentation)) {
        let label = label(segmentation, owner);
        let _ = writeln!(text, "{} {} {} {label}", point.x, point.y, point.z);
    }
    text
}

pub(super) fn ply(
    cloud: &Cloud,
    segmentation: &Segmentation,
    about: &About,
    text: bool,
) -> Vec<u8> {
    let format = if text {
        "ascii"
    } else {
        "binary_little_endian"
    };
    let mut file = format!(
        "ply\nformat {format} 1.0\ncomment {}, {}\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nproperty uchar red\nproperty uchar green\n\
         property uchar blue\nproperty int primitive_index\nend_header\n",
        in_one_line(&about.model),
        in_one_line(&about.method),
        cloud.numbering().rows(),
    )
    .into_bytes();
    for (point, owner) in rows(cloud, &owners(cloud, segmentation)) {
        let [r, g, b] = about.colour(owner.map(|place| place as usize));
        let label = label(segmentation, owner);
        if text {
            let row = format!("{} {} {} {r} {g} {b} {label}\n", point.x, point.y, point.z);
            file.extend(row.into_bytes());
        } else {
            for value in [point.x, point.y, point.z] {
                file.extend(value.to_le_bytes());
            }
            file.extend([r, g, b]);
            file.extend(label.to_le_bytes());
        }
    }
    file
}

/// A name without what would end its line.
pub(super) fn in_one_line(name: &str) -> String {
    let shown = |it: char| if it.is_control() { ' ' } else { it };
    name.chars().map(shown).collect()
}
