//! Arrays of NumPy and archives of them.

use super::*;

pub(super) fn npy(kind: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let fortran = if shape.starts_with('F') {
        "True"
    } else {
        "False"
    };
    let shape = shape.trim_start_matches('F');
    let descr = if kind.starts_with('[') {
        kind.to_owned()
    } else {
        format!("'{kind}'")
    };
    let head = format!("{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}\n");
    let length = (head.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], head.as_bytes(), data].concat()
}

pub(super) fn points(store: Store, columns: bool) -> Vec<u8> {
    let rows = rows();
    let numbers: Vec<f64> = if columns {
        (0..3)
            .flat_map(|axis| rows.iter().map(move |(row, _)| row[axis]))
            .collect()
    } else {
        rows.iter().flat_map(|(row, _)| *row).collect()
    };
    numbers.into_iter().flat_map(store).collect()
}

#[test]
fn an_array_of_one_point_has_all_its_coordinates() {
    let numbers: Vec<u8> = [1.5f64, 2.25, 3.125]
        .iter()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    for shape in ["(1, 3)", "F(1, 3)"] {
        let read = read_foreign("a.npy", &npy("<f8", shape, &numbers), Purpose::Truth);
        let Some((Content::Cloud(file), _)) = read else {
            panic!("{shape}: {read:?}");
        };
        assert_eq!(file.cloud.points(), [Point::new(1.5, 2.25, 3.125)]);
    }
}

#[test]
fn arrays_of_either_order_and_of_every_number_are_read() {
    for (kind, store) in FLOATS {
        is_whole(&npy(kind, "(60, 3)", &points(store, false)), false);
        is_whole(&npy(kind, "(1, 60, 3)", &points(store, false)), false);
        is_whole(&npy(kind, "F(60, 3)", &points(store, true)), false);
        is_whole(&npy(kind, "(3, 60)", &points(store, true)), false);
    }
    let store = FLOATS[1].1;
    let with_labels: Vec<u8> = rows()
        .iter()
        .flat_map(|&([x, y, z], label)| [x, y, z, f64::from(label)])
        .flat_map(store)
        .collect();
    is_whole(&npy(">f8", "(60, 4)", &with_labels), true);
    let names = "[('label', '>f8'), ('x', '>f8'), ('y', '>f8'), ('z', '>f8')]";
    let named: Vec<u8> = rows()
        .iter()
        .flat_map(|&([x, y, z], label)| [f64::from(label), x, y, z])
        .flat_map(store)
        .collect();
    is_whole(&npy(names, "(60,)", &named), true);
    let labels: Vec<u8> = rows()
        .iter()
        .flat_map(|(_, label)| label.to_le_bytes())
        .collect();
    let read = read_foreign(
        "a_labels.npy",
        &npy("<i4", "(60,)", &labels),
        Purpose::Truth,
    );
    let expected: Vec<i32> = rows().iter().map(|&(_, label)| label).collect();
    assert_eq!(
        read,
        Some((Content::Labels(expected, BTreeMap::new()), vec![]))
    );
}

/// A zip of stored or deflated entries.
fn zipped(entries: &[(&str, Vec<u8>)], deflated: bool) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in entries {
        let packed = if deflated {
            miniz_oxide::deflate::compress_to_vec(content, 6)
        } else {
            content.clone()
        };
        let at = (bytes.len() as u32).to_le_bytes();
        let method = [if deflated { 8u8 } else { 0 }, 0];
        let sizes = [packed.len() as u32, content.len() as u32]
            .map(u32::to_le_bytes)
            .concat();
        let lengths = [&(name.len() as u16).to_le_bytes()[..], &[0, 0]].concat();
        let common = [&[20, 0, 0, 0][..], &method, &[0; 8], &sizes, &lengths].concat();
        bytes.extend([&b"PK\x03\x04"[..], &common, name.as_bytes(), &packed].concat());
        directory.extend(
            [
                &b"PK\x01\x02\x14\x00"[..],
                &common,
                &[0; 10],
                &at,
                name.as_bytes(),
            ]
            .concat(),
        );
    }
    let count = (entries.len() as u16).to_le_bytes();
    let place = [directory.len() as u32, bytes.len() as u32]
        .map(u32::to_le_bytes)
        .concat();
    let end = [&b"PK\x05\x06\0\0\0\0"[..], &count, &count, &place, &[0, 0]].concat();
    [bytes, directory, end].concat()
}

#[test]
fn archives_of_arrays_are_read_by_their_names_and_for_their_purpose() {
    let int: Store = |value| (value as i64).to_le_bytes().to_vec();
    let labels = |of: fn(i32) -> i32| {
        let values = rows()
            .into_iter()
            .flat_map(|(_, label)| int(f64::from(of(label))));
        npy("<i8", "(60, 1)", &values.collect::<Vec<u8>>())
    };
    let entries = [
        ("S.npy", npy("<f8", "(7, 2)", &[0; 112])),
        ("V.npy", npy("<f8", "(60, 3)", &points(FLOATS[2].1, false))),
        ("L.npy", labels(|_| 4)),
        ("L_gt.npy", labels(|label| label)),
    ];
    for deflated in [false, true] {
        let bytes = zipped(&entries, deflated);
        is_whole(&bytes, true);
        let Some((Content::Cloud(file), _)) = read_foreign("a.npz", &bytes, Purpose::Submission)
        else {
            panic!("no cloud");
        };
        let segments = file.segments.unwrap();
        assert_eq!(
            (segments.len(), segments[0].number, segments[0].points.len()),
            (1, 4, 60)
        );
        // Broken anywhere, nothing panics.
        for cut in (0..bytes.len()).step_by(7) {
            let _ = read_foreign("a.npz", &bytes[..cut], Purpose::Truth);
        }
    }
}

#[test]
fn types_of_points_come_along_in_archives_of_networks() {
    use crate::surface::SurfaceType::{Cylinder, Plane};
    let types: Vec<u8> = rows()
        .iter()
        .map(|(_, label)| if *label == 1 { 4 } else { 1 })
        .collect();
    let labels: Vec<u8> = rows()
        .iter()
        .flat_map(|(_, label)| label.to_le_bytes())
        .collect();
    let cloud_of = |entries: &[(&str, Vec<u8>)]| {
        let arrays = crate::export::zip_of(entries);
        cloud(&arrays).0
    };
    let xyz = || {
        (
            "points.npy",
            npy("<f8", "(60, 3)", &points(FLOATS[2].1, false)),
        )
    };
    let typed = cloud_of(&[
        xyz(),
        ("inst.npy", npy("<i4", "(60,)", &labels)),
        ("prim.npy", npy("|u1", "(60,)", &types)),
    ]);
    let kinds: Vec<_> = typed.segments.unwrap().iter().map(|it| it.kind).collect();
    assert_eq!(kinds, [Some(Plane), Some(Cylinder)]);
    let nameless = cloud_of(&[
        ("arr_0.npy", xyz().1),
        ("arr_1.npy", npy("<i4", "(60,)", &labels)),
    ]);
    assert_eq!(nameless.segments.map(|it| it.len()), Some(2));
}
