//! Files of other programs, read and written.

use fit4cad::export::{About, Export, write};
use fit4cad::format::foreign::{Content, Purpose, read_foreign};
use fit4cad::format::read_foreign_cloud_by_pieces;
use fit4cad::format::{read_answer, read_cloud, write_answer};

use super::{MIB, text};
use crate::{Bytes, Target, shapes};

/// The forms of export that are of points, and so are read again.
const OF_POINTS: [Export; 4] = [Export::Ply, Export::PlyText, Export::Npz, Export::Groups];

/// A LAS file of two points with a column of labels.
fn las() -> Vec<u8> {
    let mut bytes = vec![0; 227 + 54 + 192];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &[227]);
    put(96, &(227u32 + 54 + 192).to_le_bytes());
    put(100, &[1]);
    put(105, &[24]);
    put(107, &[2]);
    for axis in 0..3 {
        put(131 + 8 * axis, &0.001f64.to_le_bytes());
    }
    put(229, b"LASF_Spec");
    put(245, &[4, 0, 192]);
    put(227 + 54 + 2, &[6, 0]);
    put(227 + 54 + 4, b"label");
    bytes.extend([1; 48]);
    bytes
}

pub const FOREIGN: Target = Target {
    name: "foreign",
    run: |input| {
        // Names decide where content does not.
        for name in ["PC1.txt", "PC1.stl"] {
            for purpose in [Purpose::Truth, Purpose::Submission] {
                let Some((content, found)) = read_foreign(name, input, purpose) else {
                    continue;
                };
                text::check_findings(&found);
                match content {
                    Content::Cloud(file) => {
                        let piece = 1 + input.len() % 61;
                        let pieced = read_foreign_cloud_by_pieces(name, input, piece);
                        if let Some(pieced) = pieced.filter(|_| purpose == Purpose::Truth) {
                            assert_eq!(pieced, (file.clone(), found), "by pieces of {piece}");
                        }
                        text::check_points(&file.cloud);
                        for segment in file.segments.iter().flatten() {
                            text::check_list(&segment.points, file.cloud.len());
                        }
                    }
                    Content::Labels(labels, _) => assert!(labels.len() <= 1000 * input.len()),
                    Content::Text(_) => {}
                }
            }
        }
    },
    seeds: || {
        let mut seeds: Vec<Vec<u8>> = small_models().flat_map(|model| exports(&model)).collect();
        let files: [&[u8]; 8] = [
            b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar int n\nproperty int label\nend_header\n0 0 0 2 1 2 1\n1 1 1 0 2\n",
            b"ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
            b"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb label\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n0 0 0 0 1\n1 1 1 0 2\n",
            b"# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary_compressed\n\x0e\0\0\0\x0c\0\0\0\x0b\0\0\0\0\0\0\0\0\0\0\0\0\0",
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\n",
            b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
            b"\x93NUMPY\x01\0\x46\0{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }            \n\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
            b"num_points: 2\n0 0 0\n1 1 1\nnum_colors: 0\nnum_normals: 0\nnum_groups: 1\ngroup_type: 0\nnum_group_parameters: 4\ngroup_parameters: 0 0 1 0\ngroup_label: a\ngroup_color: 1 0 0\ngroup_num_point: 2\n0 1\nnum_children: 0\n",
        ];
        seeds.extend(files.map(<[u8]>::to_vec));
        seeds.push(las());
        // Stored without being packed.
        seeds.push(
            b"\x1f\x8b\x08\0\0\0\0\0\0\x03\x01\x06\0\xf9\xff0 0 0\n\0\0\0\0\x06\0\0\0".to_vec(),
        );
        seeds
    },
    words: &[
        "ply\n",
        "format ascii 1.0\n",
        "format binary_little_endian 1.0\n",
        "element vertex ",
        "element face ",
        "property float x\n",
        "property list uchar int vertex_indices\n",
        "end_header\n",
        "FIELDS x y z label\n",
        "SIZE 4 4 4 4\n",
        "COUNT 1 1 1 1\n",
        "DATA binary\n",
        "DATA binary_compressed\n",
        "POINTS 4294967295\n",
        "\x1f",
        "PK\x03\x04",
        "PK\x01\x02",
        "PK\x05\x06",
        "'shape': (",
        "'descr': '<f4'",
        "'descr': '|O'",
        "'fortran_order': True",
        "99999999999999999999",
        "-1",
        "NaN",
        "solid ",
        "vertex ",
        "num_points: ",
        "num_groups: ",
        "group_num_point: ",
        "v ",
        "f 1//2 3/4/5 -1\n",
    ],
    longest: 4096,
    floor: 2 * MIB,
    quick: 20_000,
};

pub const EXPORT: Target = Target {
    name: "export",
    run: |input| {
        let model = shapes::readable_model(&mut Bytes::new(input));
        let Some(truth) = &model.truth else {
            return;
        };
        let about = About {
            model: model.name.clone(),
            method: "M".to_owned(),
            ..About::default()
        };
        for export in Export::ALL {
            let bytes = write(export, &model.cloud, truth, &about);
            if !OF_POINTS.contains(&export) || model.cloud.is_empty() {
                continue;
            }
            let read = match read_foreign(export.name(), &bytes, Purpose::Truth) {
                Some((Content::Cloud(file), _)) => Some(file.cloud),
                _ => None,
            };
            assert_eq!(
                read.as_ref().map(|cloud| cloud.points()),
                Some(model.cloud.points()),
                "{export:?}"
            );
        }
        let (file, _) = read_cloud("a.xyzc", &write(Export::Xyzc, &model.cloud, truth, &about));
        assert_eq!(file.cloud.points(), model.cloud.points());
        for surface in truth.primitives.iter().filter_map(|it| it.surface) {
            let answer = write_answer(&surface);
            assert!(
                read_answer(&answer).is_none_or(|again| again.kind() == surface.kind()),
                "{answer}"
            );
        }
    },
    seeds: super::none,
    words: &[],
    longest: 2048,
    floor: 16 * MIB,
    quick: 800,
};

fn small_models() -> impl Iterator<Item = fit4cad::model::Model> {
    text::models()
        .into_iter()
        .filter(|model| model.cloud.len() < 200)
}

fn exports(model: &fit4cad::model::Model) -> Vec<Vec<u8>> {
    let Some(truth) = &model.truth else {
        return Vec::new();
    };
    OF_POINTS
        .iter()
        .map(|&export| write(export, &model.cloud, truth, &About::default()))
        .collect()
}
