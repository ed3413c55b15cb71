//! Arrays of NumPy in a zip whose entries are stored.

use super::points::{label, owners, rows};
use crate::cloud::Cloud;
use crate::model::Segmentation;
use crate::surface::SurfaceType;

/// Rows of points, labels and types, each where it is known, as they are written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Arrays {
    /// Coordinates, three a row; empty where there are none.
    pub points: Vec<f64>,
    /// Whether these are of single precision.
    pub single: bool,
    /// The number of each row's primitive, -1 for none; empty where there are none.
    pub labels: Vec<i32>,
    /// Numbers of primitives and their types, where one of the five is known.
    pub types: Vec<(i32, Option<SurfaceType>)>,
}

impl Arrays {
    /// The arrays that are there as `.npz`: `points` (float64 or float32, n × 3), `labels` (int32, n), `numbers` and
    /// `types` (int32; of the primitives: their numbers, and places in the order plane, cylinder, cone, sphere,
    /// torus, -1 for another). Linear in their lengths.
    pub fn npz(&self) -> Vec<u8> {
        let mut entries = Vec::new();
        if !self.points.is_empty() {
            let shape = format!("({}, 3)", self.points.len() / 3);
            let values = self.points.iter();
            let points = if self.single {
                let bytes = values.flat_map(|&value| (value as f32).to_le_bytes());
                array("<f4", &shape, &bytes.collect::<Vec<u8>>())
            } else {
                let bytes = values.flat_map(|value| value.to_le_bytes());
                array("<f8", &shape, &bytes.collect::<Vec<u8>>())
            };
            entries.push(("points.npy", points));
        }
        if !self.labels.is_empty() {
            let count = self.labels.len();
            entries.push(("labels.npy", whole(count, self.labels.iter().copied())));
            let count = self.types.len();
            let numbers = self.types.iter().map(|&(number, _)| number);
            entries.push(("numbers.npy", whole(count, numbers)));
            let place = |kind| SurfaceType::ALL.iter().position(|known| *known == kind);
            let places = self.types.iter().map(|&(_, kind)| {
                let place = kind.and_then(place);
                place.map_or(-1, |place| place as i32)
            });
            entries.push(("types.npy", whole(count, places)));
        }
        zip(&entries)
    }
}

pub(super) fn npz(cloud: &Cloud, segmentation: &Segmentation) -> Vec<u8> {
    let owners = owners(cloud, segmentation);
    let mut arrays = Arrays::default();
    for (point, owner) in rows(cloud, &owners) {
        arrays.points.extend(point.iter());
        arrays.labels.push(label(segmentation, owner));
    }
    let primitives = segmentation.primitives.iter();
    let types = primitives.map(|primitive| (primitive.number as i32, primitive.kind));
    arrays.types = types.collect();
    arrays.npz()
}

fn whole(count: usize, values: impl Iterator<Item = i32>) -> Vec<u8> {
    let bytes: Vec<u8> = values.flat_map(i32::to_le_bytes).collect();
    array("<i4", &format!("({count},)"), &bytes)
}

/// An array as `.npy`, version 1.0, its data at a multiple of 64 bytes.
fn array(kind: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let mut head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let length = (10 + head.len() + 1).next_multiple_of(64) - 10;
    while head.len() + 1 < length {
        head.push(' ');
    }
    head.push('\n');
    let length = (head.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], head.as_bytes(), data].concat()
}

pub(crate) fn zip(entries: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let (mut file, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in entries {
        let at = (file.len() as u32).to_le_bytes();
        let size = (content.len() as u32).to_le_bytes();
        let mut common = Vec::new();
        // Version 2.0, no flags, stored, the first day that zips know.
        common.extend([20, 0, 0, 0, 0, 0, 0, 0, 0x21, 0]);
        common.extend(crc32(content).to_le_bytes());
        common.extend([size, size].concat());
        common.extend((name.len() as u16).to_le_bytes());
        common.extend([0, 0]);
        file.extend([b"PK\x03\x04", &common[..], name.as_bytes(), content].concat());
        directory.extend(
            [
                b"PK\x01\x02\x14\x00",
                &common[..],
                &[0; 10],
                &at,
                name.as_bytes(),
            ]
            .concat(),
        );
    }
    let count = (entries.len() as u16).to_le_bytes();
    let (size, at) = (directory.len() as u32, file.len() as u32);
    file.extend(directory);
    file.extend([&b"PK\x05\x06\0\0\0\0"[..], &count, &count].concat());
    file.extend([size.to_le_bytes(), at.to_le_bytes()].concat());
    file.extend([0, 0]);
    file
}

/// The checksum of zips (ISO 3309), by nibbles.
fn crc32(bytes: &[u8]) -> u32 {
    const TABLE: [u32; 16] = {
        let mut table = [0u32; 16];
        let mut at = 0;
        while at < 16 {
            let mut value = at as u32;
            let mut bit = 0;
            while bit < 4 {
                value = if value & 1 == 1 {
                    0xEDB8_8320 ^ (value >> 1)
                } else {
                    value >> 1
                };
                bit += 1;
            }
            table[at] = value;
            at += 1;
        }
        table
    };
    let mut sum = u32::MAX;
    for &byte in bytes {
        sum ^= u32::from(byte);
        sum = TABLE[(sum & 15) as usize] ^ (sum >> 4);
        sum = TABLE[(sum & 15) as usize] ^ (sum >> 4);
    }
    !sum
}
