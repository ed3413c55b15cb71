use std::collections::BTreeMap;

use super::*;
use crate::cloud::Point;

mod arrays;

use arrays::{npy, points};

/// Points of an L of two faces, label 0 and 1, the last of none.
fn rows() -> Vec<([f64; 3], i32)> {
    (0..60)
        .map(|i| {
            let (u, v) = (f64::from(i % 10) * 0.5, f64::from(i / 10 % 3) - 1.25);
            match i {
                59 => ([9.0, 9.0, 9.0], -1),
                30.. => ([0.0, u, v], 1),
                _ => ([u, 0.0, v], 0),
            }
        })
        .collect()
}

fn cloud(bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    match read_foreign("PC1", bytes, Purpose::Truth) {
        Some((Content::Cloud(file), findings)) => (file, findings),
        other => panic!("{other:?}"),
    }
}

/// Whether a file is read as the points above, and its labels, where it has some.
fn is_whole(bytes: &[u8], labelled: bool) {
    let (file, findings) = cloud(bytes);
    let expected: Vec<Point> = rows().iter().map(|&(row, _)| Point::from(row)).collect();
    assert_eq!(file.cloud.points(), expected, "{findings:?}");
    assert!(
        findings
            .iter()
            .all(|it| it.severity == crate::diagnostics::Severity::Note),
        "{findings:?}"
    );
    let found = file.segments.map(|segments| {
        let segments = segments.into_iter();
        segments
            .map(|it| (it.number, it.points.len()))
            .collect::<Vec<_>>()
    });
    assert_eq!(found, labelled.then(|| vec![(0, 30), (1, 29)]));
}

/// Says a value as bytes of a number.
type Store = fn(f64) -> Vec<u8>;

const FLOATS: [(&str, Store); 4] = [
    ("<f4", |value| (value as f32).to_le_bytes().to_vec()),
    (">f8", |value| value.to_be_bytes().to_vec()),
    ("<f8", |value| value.to_le_bytes().to_vec()),
    (">f4", |value| (value as f32).to_be_bytes().to_vec()),
];

#[test]
fn ply_of_each_form_is_read_with_what_else_it_holds_passed_over() {
    for (form, float, int) in [
        (
            "binary_little_endian",
            FLOATS[0].1,
            (|v| (v as i32).to_le_bytes().to_vec()) as Store,
        ),
        ("binary_big_endian", FLOATS[3].1, |v| {
            (v as i32).to_be_bytes().to_vec()
        }),
    ] {
        let mut bytes = format!(
            "ply\nformat {form} 1.0\ncomment of something\nelement face 2\n\
             property list uchar int vertex_indices\nelement vertex 60\nproperty float x\n\
             property list uchar uchar odd\nproperty float y\nproperty float32 z\n\
             property uchar red\nproperty int v:primitive_index\nend_header\n"
        )
        .into_bytes();
        for corners in [3u8, 0] {
            bytes.push(corners);
            (0..corners).for_each(|corner| bytes.extend(int(f64::from(corner))));
        }
        for ([x, y, z], label) in rows() {
            bytes.extend(float(x));
            bytes.extend([2, 7, 7]);
            bytes.extend([y, z].into_iter().flat_map(float));
            bytes.push(200);
            bytes.extend(int(f64::from(label)));
        }
        is_whole(&bytes, true);
        // Cut off, it is read as far as it goes.
        let (file, findings) = cloud(&bytes[..bytes.len() - 1]);
        assert_eq!(file.cloud.len(), 59);
        assert_eq!(findings.last().unwrap().found, "59 points of 60");
    }
    let lines: Vec<String> = rows()
        .iter()
        .map(|([x, y, z], label)| format!("{x} {y} {z} {label}.0\r\n"))
        .collect();
    let text = format!(
        "ply\r\nformat ascii 1.0\r\nelement vertex 60\r\nproperty double x\r\nproperty double y\r\n\
         property double z\r\nproperty float label\r\nend_header\r\n{}",
        lines.concat()
    );
    is_whole(text.as_bytes(), true);
}

#[test]
fn heads_that_claim_what_is_not_there_get_an_error_and_no_memory() {
    let huge = u64::MAX;
    let head = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex {huge}\nproperty float x\nproperty float y\n\
             property float z\nend_header\n1 2 3\n"
        )
    };
    for text in [
        head("ascii"),
        head("binary_big_endian"),
        format!(
            "ply\nformat ascii 1.0\nelement empty {huge}\nelement vertex 1\nproperty float x\n\
                 property float y\nproperty float z\nend_header\n"
        ),
        "ply\nformat ascii 1.0\nelement vertex x\n".to_owned(),
        "ply\nformat ascii 1.0\nproperty float x\nend_header\n".to_owned(),
        "ply\nno end".to_owned(),
        "ply\nformat ascii 1.0\nelement face 3\nend_header\n".to_owned(),
        format!(
            "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {huge}\n\
                 HEIGHT {huge}\nPOINTS {huge}\nDATA binary\n"
        ),
        format!("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 {huge}\nDATA ascii\n"),
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 9\nDATA binary_compressed\n\
         \u{1}\u{0}\u{0}\u{0}\u{7f}\u{7f}\u{7f}\u{7f}a"
            .to_owned(),
        format!("num_points: {huge}\n1 2 3\n"),
        "num_points: 1\n1 2 3\nnum_groups: 1\ngroup_type: 0\ngroup_num_point: 99\n0\n".to_owned(),
    ] {
        let (file, findings) = cloud(text.as_bytes());
        assert!(file.cloud.len() <= 1, "{text}");
        let worst = findings.iter().map(|it| it.severity).max();
        assert_eq!(worst, Some(crate::diagnostics::Severity::Error), "{text}");
    }
    let mut array = npy("<f4", "(1152921504606846976, 3)", &[0; 24]);
    assert_eq!(cloud(&array).0.cloud.len(), 0);
    array = npy("|O", "(3, 3)", b"cos\nsystem\n");
    assert!(cloud(&array).1[0].message.contains("never opened"));
}

#[test]
fn pcd_of_each_form_is_read() {
    let head = |data: &str| {
        format!(
            "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z normal label\nSIZE 4 4 4 4 4\nTYPE F F F F U\n\
             COUNT 1 1 1 2 1\nWIDTH 60\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 60\nDATA {data}\n"
        )
    };
    let float = FLOATS[0].1;
    let numbers: Vec<Vec<Vec<u8>>> = rows()
        .iter()
        .map(|(row, label)| {
            let mut fields: Vec<Vec<u8>> = row.iter().map(|&value| float(value)).collect();
            fields.push([float(0.0), float(1.0)].concat());
            fields.push(label.to_le_bytes().to_vec());
            fields
        })
        .collect();
    // The label of none, -1, reads as a very large unsigned number: none as well.
    let with_warning = |bytes: &[u8]| {
        let (file, findings) = cloud(bytes);
        assert_eq!(file.cloud.len(), 60, "{findings:?}");
        let segments = file.segments.unwrap();
        assert_eq!(
            [segments[0].points.len(), segments[1].points.len()],
            [30, 29]
        );
        assert_eq!(findings.last().unwrap().found, "1 of 60, first row 60");
    };
    let by_row = numbers.iter().flatten().flatten().copied();
    with_warning(&[head("binary").into_bytes(), by_row.collect()].concat());
    let by_column: Vec<u8> = (0..5)
        .flat_map(|field| numbers.iter().flat_map(move |row| row[field].clone()))
        .collect();
    // Literals alone are LZF too.
    let packed: Vec<u8> = by_column
        .chunks(32)
        .flat_map(|part| [&[part.len() as u8 - 1], part].concat())
        .collect();
    let sizes = [packed.len() as u32, by_column.len() as u32].map(u32::to_le_bytes);
    with_warning(
        &[
            head("binary_compressed").into_bytes(),
            sizes.concat(),
            packed,
        ]
        .concat(),
    );
    let lines: String = rows()
        .iter()
        .map(|([x, y, z], label)| format!("{x} {y} {z} 0 nan {label}\n"))
        .collect();
    is_whole((head("ascii") + &lines).as_bytes(), true);
}

#[test]
fn what_was_found_is_told_in_few_characters() {
    let head = format!(
        "# .PCD v0.7\nFIELDS {}\nDATA ascii\n",
        "a\u{1} ".repeat(10_000)
    );
    let (_, found) = read_foreign("a.pcd", head.as_bytes(), Purpose::Truth).expect("a PCD file");
    assert!(found.iter().all(|it| it.to_string().len() < 2000));
    assert!(found[0].found.starts_with("a\u{FFFD} a"), "{:?}", found[0]);
}

#[test]
fn vertices_of_meshes_are_read() {
    let lines: String = rows()
        .iter()
        .map(|([x, y, z], _)| format!("v {x} {y} {z} 0.5 0.5 0.5\nvn 0 0 1\n"))
        .collect();
    let obj = format!("# made by hand\nmtllib a.mtl\no part\n{lines}f 1//1 2//2 3//3\n");
    is_whole(obj.as_bytes(), false);
    // Each triangle has the corner of the next as its first.
    let corners: Vec<[f64; 3]> = rows().iter().map(|&(row, _)| row).collect();
    let triangles: Vec<[[f64; 3]; 3]> = corners
        .windows(3)
        .map(|three| [three[0], three[1], three[2]])
        .collect();
    let mut binary = vec![b's'; 80];
    binary.extend((triangles.len() as u32).to_le_bytes());
    for triangle in &triangles {
        binary.extend([0; 12]);
        binary.extend(
            triangle
                .iter()
                .flatten()
                .flat_map(|&value| (value as f32).to_le_bytes()),
        );
        binary.extend([0; 2]);
    }
    // Where both faces share points, STL has them once.
    let count = |bytes: &[u8]| cloud(bytes).0.cloud.len();
    let distinct = {
        let mut keys: Vec<[u64; 3]> = corners.iter().map(|row| row.map(f64::to_bits)).collect();
        keys.sort_unstable();
        keys.dedup();
        keys.len()
    };
    assert_eq!(count(&binary), distinct);
    let facets: String = triangles
        .iter()
        .map(|triangle| {
            let corner = |[x, y, z]: [f64; 3]| format!("vertex {x} {y} {z}\n");
            let corners = triangle.map(corner).concat();
            format!("facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n")
        })
        .collect();
    assert_eq!(
        count(format!("solid a\n{facets}endsolid a\n").as_bytes()),
        distinct
    );
}

#[test]
fn vertex_groups_are_read_as_easy3d_and_as_its_documentation_write_them() {
    let points: String = rows()
        .iter()
        .map(|([x, y, z], _)| format!("{x} {y} {z}\n"))
        .collect();
    for (key, colon) in [("group_num_point", ": "), ("group_num_points", ":")] {
        let list = |range: std::ops::Range<u32>| {
            range.map(|i| i.to_string()).collect::<Vec<_>>().join(" ")
        };
        let text = format!(
            "num_points: 60\n{points}num_colors: 1\n1 0 0\nnum_normals: 0\nnum_groups: 2\n\
             group_type: 0\nnum_group_parameters: 4\ngroup_parameters: 0 1 0 0\ngroup_label: unknown\n\
             group_color: 0 0 1\n{key}{colon}30\n{}\nnum_children: 0\ngroup_type: 5\n\
             num_group_parameters: 0\ngroup_parameters:\ngroup_label: b\ngroup_color: 0 0 1\n\
             {key}{colon}29\n{}\nnum_children: 0\n",
            list(0..30),
            list(30..59)
        );
        let (file, findings) = cloud(text.as_bytes());
        assert!(findings.is_empty(), "{findings:?}");
        let segments = file.segments.unwrap();
        assert_eq!(segments[0].kind, Some(SurfaceType::Plane));
        assert_eq!((segments[1].kind, segments[1].points[0]), (None, 30));
    }
}

/// A LAS file of a version and point format, in units of a quarter, with labels added to each point or without.
fn las(minor: u8, format: u8, own: usize, label: Option<(u8, Store)>) -> Vec<u8> {
    let head: u16 = if minor >= 4 { 375 } else { 227 };
    let mut bytes = vec![0; usize::from(head)];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    let size = label.map_or(0, |(_, store)| store(0.0).len());
    let described = if size > 0 { 54 + 2 * 192 } else { 0 };
    put(0, b"LASF");
    put(24, &[1, minor]);
    put(94, &head.to_le_bytes());
    put(96, &(u32::from(head) + described).to_le_bytes());
    put(100, &u32::from(size > 0).to_le_bytes());
    put(104, &[format]);
    // Three bytes without a meaning, and the label.
    let added = if size > 0 { 3 + size } else { 0 };
    put(105, &((own + added) as u16).to_le_bytes());
    if minor >= 4 {
        put(247, &60u64.to_le_bytes());
    } else {
        put(107, &60u32.to_le_bytes());
    }
    let offset = [1.0f64, -2.0, 0.5];
    for (axis, from) in offset.iter().enumerate() {
        put(131 + 8 * axis, &0.25f64.to_le_bytes());
        put(155 + 8 * axis, &from.to_le_bytes());
    }
    if let Some((code, _)) = label {
        let mut about = [0; 54];
        about[2..11].copy_from_slice(b"LASF_Spec");
        about[18] = 4;
        about[20..22].copy_from_slice(&(2 * 192u16).to_le_bytes());
        let mut padding = [0; 192];
        padding[3] = 3;
        let mut column = [0; 192];
        column[2] = code;
        column[4..9].copy_from_slice(b"Label");
        bytes.extend(about.into_iter().chain(padding).chain(column));
    }
    for (point, number) in rows() {
        let mut record = vec![7; own];
        for (axis, from) in offset.iter().enumerate() {
            let count = ((point[axis] - from) / 0.25) as i32;
            record[4 * axis..4 * axis + 4].copy_from_slice(&count.to_le_bytes());
        }
        if let Some((_, store)) = label {
            record.extend([9; 3]);
            record.extend(store(f64::from(number)));
        }
        bytes.extend(record);
    }
    bytes
}

#[test]
fn las_of_each_version_is_read_and_what_is_packed_is_told() {
    let int: Store = |value| (value as i32).to_le_bytes().to_vec();
    let byte: Store = |value| (value as i8).to_le_bytes().to_vec();
    is_whole(&las(2, 3, 34, None), false);
    is_whole(&las(4, 6, 30, None), false);
    is_whole(&las(4, 7, 36, Some((6, int))), true);
    is_whole(&las(2, 1, 28, Some((2, byte))), true);
    is_whole(&las(2, 0, 20, Some((9, FLOATS[0].1))), true);
    let whole = las(4, 6, 30, Some((10, FLOATS[2].1)));
    is_whole(&whole, true);
    let (file, findings) = cloud(&whole[..whole.len() - 1]);
    assert_eq!(file.cloud.len(), 59);
    assert_eq!(findings.last().unwrap().found, "59 points of 60");
    let told = |bytes: &[u8]| cloud(bytes).1[0].to_string();
    let mut packed = whole.clone();
    packed[104] |= 0x80;
    assert!(told(&packed).contains("LAZ"));
    assert!(told(&whole[..150]).contains("ends within its head"));
    let mut strange = whole.clone();
    strange[104] = 11;
    assert!(told(&strange).contains("no point format"));
}

#[test]
fn files_packed_by_gzip_are_unpacked_whatever_they_are() {
    let packed = |content: &[u8]| {
        let mut bytes = vec![0x1F, 0x8B, 8, 8, 0, 0, 0, 0, 0, 3];
        bytes.extend(b"name\0");
        bytes.extend(miniz_oxide::deflate::compress_to_vec(content, 6));
        bytes.extend([0; 8]);
        bytes
    };
    let array = npy("<f8", "(60, 3)", &points(FLOATS[2].1, false));
    is_whole(&packed(&array), false);
    // Of several members, as tools that pack on many cores write them, all are read; what follows them is nothing.
    let (first, second) = array.split_at(700);
    is_whole(&[packed(first), packed(second), vec![0; 9]].concat(), false);
    let text = read_foreign("a.xyz.gz", &packed(b"1 2 3\n"), Purpose::Truth);
    assert_eq!(text, Some((Content::Text(b"1 2 3\n".to_vec()), vec![])));
    let (file, findings) = cloud(&[0x1F, 0x8B, 8, 0, 1, 2]);
    assert!(file.cloud.is_empty() && findings[0].message.contains("unpacked"));
}

#[test]
fn what_is_packed_is_had_from_any_place() {
    let whole: Vec<u8> = (0..300_000u32)
        .flat_map(|at| at.wrapping_mul(at).to_le_bytes())
        .collect();
    let mut packed = vec![0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 3];
    packed.extend(miniz_oxide::deflate::compress_to_vec(&whole, 6));
    packed.extend([0; 8]);
    let asked = std::cell::Cell::new(0);
    let part = |from: u64, to: u64| {
        asked.set(asked.get() + to - from);
        Ok(std::borrow::Cow::Borrowed(
            &packed[from as usize..to as usize],
        ))
    };
    let mut unpacking = Unpacking::new(packed.len() as u64, &part);
    assert_eq!(unpacking.length(), Ok(whole.len() as u64));
    asked.set(0);
    let mut read = |from: usize, to: usize| {
        assert_eq!(
            unpacking.read(from as u64, to as u64).unwrap(),
            whole[from.min(whole.len())..to.min(whole.len())],
            "{from}"
        );
    };
    // Forwards, with what was had before once more.
    for from in (0..whole.len()).step_by(100_000) {
        read(from, from + 100_000);
        read(from + 10, from + 20);
    }
    assert!(asked.get() < 2 * packed.len() as u64, "it is unpacked once");
    read(7, 9);
    read(1_000_000, 1_000_001);
    read(1_199_999, 5_000_000);
    read(2_000_000, 2_000_001);
    // One that is cut off is not taken for a shorter one.
    let cut = &packed[..packed.len() / 2];
    let part =
        |from: u64, to: u64| Ok(std::borrow::Cow::Borrowed(&cut[from as usize..to as usize]));
    assert!(Unpacking::new(cut.len() as u64, &part).length().is_err());
}

#[test]
fn texts_of_this_project_are_not_taken_for_others() {
    for text in [
        "Points:=[\n[1, 2, 3],\n]",
        "Primitive1:=[1 2];",
        "1 2 3\n4 5 6\n",
        "x y z\n1 2 3\n",
        "vx vy vz\n1 2 3\n",
        "",
        "solid rock, 3 points\n1 2 3\n",
    ] {
        assert_eq!(
            read_foreign("a.txt", text.as_bytes(), Purpose::Truth),
            None,
            "{text}"
        );
    }
}

#[test]
fn ply_and_las_read_the_same_by_pieces_of_any_size() {
    let lines: Vec<String> = rows()
        .iter()
        .map(|([x, y, z], label)| format!("{x} {y} 2 7 7 {z} {label}.0\r\n"))
        .collect();
    let text = format!(
        "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex 60\n\
         property double x\nproperty double y\nproperty list uchar uchar odd\nproperty double z\n\
         property float label\nend_header\n3 0 1 2\n0\n{}",
        lines.concat()
    );
    let mut files = vec![
        text.clone().into_bytes(),
        text.as_bytes()[..text.len() - 9].to_vec(),
    ];
    files.extend([las(2, 3, 34, None), las(4, 6, 30, Some((10, FLOATS[2].1)))]);
    let short = files[2][..files[2].len() - 5].to_vec();
    files.push(short);
    for file in files {
        let Some((Content::Cloud(whole), findings)) = read_foreign("PC1", &file, Purpose::Truth)
        else {
            panic!("it is no cloud");
        };
        for piece in [1, 2, 7, 31, 64, 500, 5000] {
            let found = crate::format::read_foreign_cloud_by_pieces("PC1", &file, piece);
            assert_eq!(found, Some((whole.clone(), findings.clone())), "{piece}");
        }
    }
}
