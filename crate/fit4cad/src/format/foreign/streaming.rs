//! Files that come in pieces read as the whole.

use super::*;
use crate::format::read_foreign_cloud_by_pieces;

const ROWS: usize = 6000;

/// Numbers of a row: coordinates, and a label that changes along x.
fn row(at: usize) -> ([f32; 3], i32) {
    let (i, j) = (at / 60, at % 60);
    ([i as f32 * 0.25, j as f32 * -0.5, 1.0], (i / 20) as i32)
}

fn rows(of: impl FnMut(([f32; 3], i32)) -> Vec<u8>) -> Vec<u8> {
    (0..ROWS).map(row).flat_map(of).collect()
}

fn pcd(data: &str) -> Vec<u8> {
    format!(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F I\nCOUNT 1 1 1 1\n\
         WIDTH {ROWS}\nHEIGHT 1\nPOINTS {ROWS}\nDATA {data}\n"
    )
    .into_bytes()
}

fn npy(descr: &str, shape: &str, order: &str) -> Vec<u8> {
    let head = format!("{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let length = (head.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], head.as_bytes()].concat()
}

fn binary((point, label): ([f32; 3], i32)) -> Vec<u8> {
    let point = point.into_iter().flat_map(f32::to_le_bytes);
    point.chain(label.to_le_bytes()).collect()
}

/// A triangle of three rows beside each other, so that each comes thrice.
fn triangle(at: usize) -> [[f32; 3]; 3] {
    [0, 1, 2].map(|next| row((at + next) % ROWS).0)
}

fn files() -> Vec<(&'static str, Vec<u8>)> {
    let text = |(p, label): ([f32; 3], i32)| {
        format!("{} {} {} {label}\r\n", p[0], p[1], p[2]).into_bytes()
    };
    let columns: Vec<u8> = (0..3)
        .flat_map(|axis| (0..ROWS).flat_map(move |at| row(at).0[axis].to_le_bytes()))
        .collect();
    let points = rows(|(point, _)| point.into_iter().flat_map(f32::to_le_bytes).collect());
    let as_doubles = rows(|(p, label)| {
        let all = [f64::from(p[0]), p[1].into(), p[2].into(), label.into()];
        all.into_iter().flat_map(f64::to_be_bytes).collect()
    });
    let named = "[('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('label', '<i4')]";
    let stl: Vec<u8> = (0..ROWS)
        .flat_map(|at| {
            let corners = triangle(at)
                .into_iter()
                .flatten()
                .flat_map(f32::to_le_bytes);
            [0; 12]
                .into_iter()
                .chain(corners)
                .chain([0, 0])
                .collect::<Vec<u8>>()
        })
        .collect();
    let facets: String = (0..ROWS)
        .map(|at| {
            let vertex = |p: [f32; 3]| format!("vertex {} {} {}\n", p[0], p[1], p[2]);
            format!(
                "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n",
                triangle(at).map(vertex).concat()
            )
        })
        .collect();
    let obj = rows(|(p, _)| format!("v {} {} {}\nvn 0 0 1\n", p[0], p[1], p[2]).into_bytes());
    vec![
        ("a.pcd", [pcd("ascii"), rows(text)].concat()),
        ("a.pcd", [pcd("binary"), rows(binary)].concat()),
        (
            "a.npy",
            [npy("'<f4'", "(6000, 3)", "False"), points].concat(),
        ),
        (
            "a.npy",
            [npy("'<f4'", "(6000, 3)", "True"), columns.clone()].concat(),
        ),
        (
            "a.npy",
            [npy("'<f4'", "(3, 6000)", "False"), columns].concat(),
        ),
        (
            "a.npy",
            [npy("'>f8'", "(6000, 4)", "False"), as_doubles].concat(),
        ),
        (
            "a.npy",
            [npy(named, "(6000,)", "False"), rows(binary)].concat(),
        ),
        (
            "a.stl",
            [&[b' '; 80][..], &(ROWS as u32).to_le_bytes(), &stl].concat(),
        ),
        ("a.stl", format!("solid a\n{facets}endsolid\n").into_bytes()),
        ("a.obj", [b"# of points\n", &obj[..], b"f 1 2 3\n"].concat()),
    ]
}

#[test]
fn every_kind_of_cloud_reads_the_same_by_pieces_as_whole() {
    for (name, file) in files() {
        for length in [file.len(), file.len() - 7] {
            let file = &file[..length];
            let Some((Content::Cloud(whole), findings)) = read_foreign(name, file, Purpose::Truth)
            else {
                panic!("{name} is no cloud");
            };
            for piece in [1, 997, 70_000, 1 << 20] {
                // Those whose columns lie one after another, and arrays that are cut off, are read whole.
                if let Some(found) = read_foreign_cloud_by_pieces(name, file, piece) {
                    assert_eq!(found, (whole.clone(), findings.clone()), "{name}, {piece}");
                }
            }
        }
    }
}

#[test]
fn rows_that_lie_one_after_another_are_read_by_pieces() {
    let read: Vec<bool> = files()
        .iter()
        .map(|(name, file)| {
            let found = read_foreign_cloud_by_pieces(name, file, 1000);
            if let Some((found, findings)) = &found {
                assert_eq!(found.cloud.len(), ROWS, "{name}: {findings:?}");
                assert_eq!(found.cloud.points()[61].x, 0.25, "{name}");
            }
            found.is_some()
        })
        .collect();
    let by_columns = [3, 4];
    let expected: Vec<bool> = (0..read.len())
        .map(|at| !by_columns.contains(&at))
        .collect();
    assert_eq!(read, expected);
}
