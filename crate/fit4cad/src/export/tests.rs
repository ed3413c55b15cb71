use super::*;
use crate::cloud::Point;
use crate::format::foreign::{Content, Purpose, read_foreign};
use crate::format::{CloudFile, read_cloud};
use crate::sample;

/// A generated part with its truth, and a row that could not be read.
fn part() -> (Cloud, Segmentation) {
    let options = sample::Options {
        spacing: 0.03,
        ..sample::Options::default()
    };
    let model = sample::generate("flange", &options).unwrap();
    (model.cloud, model.truth.unwrap())
}

fn about() -> About {
    About {
        model: "flange".to_owned(),
        method: "HT \"2\"\n".to_owned(),
        fitted: true,
        colours: vec![[1, 2, 3], [255, 0, 0], [0, 255, 0]],
    }
}

fn again(export: Export) -> (CloudFile, CloudFile) {
    let (cloud, segmentation) = part();
    let bytes = write(export, &cloud, &segmentation, &about());
    let read = match read_foreign("a", &bytes, Purpose::Truth) {
        Some((Content::Cloud(file), findings)) => {
            let notes = |it: &crate::diagnostics::Diagnostic| {
                it.severity == crate::diagnostics::Severity::Note
            };
            assert!(findings.iter().all(notes), "{findings:?}");
            file
        }
        _ => read_cloud("a.xyzc", &bytes).0,
    };
    let given = CloudFile {
        cloud,
        segments: None,
    };
    (given, read)
}

#[test]
fn points_with_labels_read_back_to_the_last_digit() {
    let (cloud, segmentation) = part();
    let owners = points::owners(&cloud, &segmentation);
    for export in [
        Export::Ply,
        Export::PlyText,
        Export::Xyzc,
        Export::Npz,
        Export::Groups,
    ] {
        let (given, read) = again(export);
        assert_eq!(read.cloud, given.cloud, "{export:?}");
        assert!(read.segments.is_some(), "{export:?}");
        let segments = read.segments.unwrap();
        for (place, primitive) in (0u32..).zip(&segmentation.primitives) {
            // Nearest to other surfaces, all points of one may be theirs.
            let own = segments.iter().find(|it| it.number == primitive.number);
            let segment = own.cloned().unwrap_or_default();
            if export == Export::Groups {
                // Groups may share points.
                assert_eq!(segment.points, primitive.points);
                assert_eq!(segment.kind, primitive.kind);
            } else {
                let own = (0u32..)
                    .zip(&owners)
                    .filter(|(_, owner)| **owner == Some(place));
                if export == Export::Npz && !segment.points.is_empty() {
                    assert_eq!(segment.kind, primitive.kind);
                }
                assert_eq!(
                    segment.points,
                    own.map(|(index, _)| index).collect::<Vec<_>>()
                );
            }
        }
    }
}

#[test]
fn rows_that_could_not_be_read_keep_their_places() {
    let (file, _) = read_cloud("a.xyz", b"0 0 0\nx 0 0\n1 0 0\n0 1 0\n");
    let segmentation = Segmentation {
        primitives: vec![crate::model::Primitive {
            number: 4,
            points: vec![0, 2],
            ..Default::default()
        }],
    };
    for export in [Export::Ply, Export::PlyText, Export::Npz] {
        let bytes = write(export, &file.cloud, &segmentation, &About::default());
        let Some((Content::Cloud(read), _)) = read_foreign("a", &bytes, Purpose::Truth) else {
            panic!("{export:?}");
        };
        assert_eq!(read.cloud, file.cloud, "{export:?}");
        assert_eq!(read.segments.unwrap()[0].points, [0, 2]);
    }
}

#[test]
fn meshes_hold_the_patches() {
    let (cloud, segmentation) = part();
    let near = |point: &Point| {
        let surfaces = segmentation.primitives.iter().filter_map(|it| it.surface);
        let distances = surfaces.map(|surface| surface.distance(point));
        distances.fold(f64::INFINITY, f64::min)
    };
    for export in [Export::Obj, Export::Stl, Export::Mesh] {
        let (_, read) = again(export);
        assert!(read.cloud.len() > 100, "{export:?}");
        let farthest = read.cloud.points().iter().map(near).fold(0.0, f64::max);
        assert!(
            farthest < 1e-4 * cloud.bounds().diagonal(),
            "{export:?} {farthest}"
        );
    }
    let glb = write(Export::Glb, &cloud, &segmentation, &about());
    let length = u32::from_le_bytes(glb[8..12].try_into().unwrap());
    assert_eq!((&glb[..4], length as usize), (&b"glTF"[..], glb.len()));
    let json = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&glb[20..20 + json]).unwrap();
    let nodes = json["nodes"].as_array().unwrap();
    assert_eq!(nodes.len(), segmentation.primitives.len());
    assert_eq!(
        json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][0],
        1.0
    );
}

#[test]
fn tables_hold_every_parameter() {
    let (cloud, segmentation) = part();
    let csv = String::from_utf8(write(Export::Csv, &cloud, &segmentation, &about())).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), segmentation.primitives.len() + 1);
    let columns = lines[0].split(',').count();
    assert!(lines.iter().all(|line| line.split(',').count() == columns));
    let json = write(Export::Json, &cloud, &segmentation, &about());
    let json: serde_json::Value = serde_json::from_slice(&json).unwrap();
    assert_eq!(json["method"], "HT \"2\"\n");
    assert_eq!(json["surfacesFitted"], true);
    let primitives = json["primitives"].as_array().unwrap();
    for (row, primitive) in primitives.iter().zip(&segmentation.primitives) {
        assert_eq!(row["points"], primitive.points.len());
        if let Some(crate::surface::Surface::Cylinder(cylinder)) = primitive.surface {
            assert_eq!(row["radius"], cylinder.radius);
            assert_eq!(row["axis"][0], cylinder.axis.x);
        }
    }
    // Nothing at all is a table of nothing, and a mesh of nothing.
    for export in Export::ALL {
        write(
            export,
            &Cloud::default(),
            &Segmentation::default(),
            &About::default(),
        );
    }
}
