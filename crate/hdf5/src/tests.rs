//! What becomes of files as h5py wrote them, `fixtures/make.py`.

use fit4cad::format::{Readers, Role, SourceFile, read_files};
use fit4cad::model::Model;
use fit4cad::surface::SurfaceType;

use crate::Opened;

const TRAIN: &[u8] = include_bytes!("../fixtures/train_data.h5");
const PREDICTIONS: &[u8] = include_bytes!("../fixtures/predictions.h5");
const HPNET: &[u8] = include_bytes!("../fixtures/00007.h5");
const SPFN: &[u8] = include_bytes!("../fixtures/shape.h5");
const SPFN_FOUND: &[u8] = include_bytes!("../fixtures/SPFN/shape.h5");
const LATEST: &[u8] = include_bytes!("../fixtures/latest.h5");

fn open(path: &str, bytes: &[u8]) -> Result<Opened, crate::Error> {
    let bytes = bytes.to_vec();
    Opened::open(path, bytes.len() as u64, move |from, length| {
        let from = usize::try_from(from).unwrap_or(usize::MAX);
        let part = bytes.get(from..from.saturating_add(length));
        part.map(<[u8]>::to_vec)
            .ok_or_else(|| "it is shorter".to_owned())
    })
}

/// The files in a file, by their paths.
fn files(path: &str, bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let opened = open(path, bytes).unwrap();
    let entries = opened.entries().iter();
    entries
        .map(|entry| (entry.path.clone(), opened.read(entry).unwrap()))
        .collect()
}

/// The model of a cloud, and of a method's labels.
fn model(cloud: &[u8], found: Option<&[u8]>) -> Model {
    let file = |path, role, method, bytes| SourceFile {
        path,
        role,
        method,
        bytes,
    };
    let mut files = vec![file("a.h5", Role::Cloud, None, cloud)];
    files.extend(found.map(|bytes| file("b.h5", Role::Primitives, Some("M"), bytes)));
    let reading = read_files("a", &files, &Readers::ALL);
    assert!(
        reading
            .diagnostics
            .iter()
            .all(|it| it.severity == fit4cad::diagnostics::Severity::Note),
        "{:?}",
        reading.diagnostics
    );
    reading.model
}

/// Numbers, types and points of the primitives of a segmentation.
fn told(found: &fit4cad::model::Segmentation) -> Vec<(u32, Option<SurfaceType>, usize)> {
    let primitives = found.primitives.iter();
    primitives
        .map(|it| (it.number, it.kind, it.points.len()))
        .collect()
}

const PLANE: Option<SurfaceType> = Some(SurfaceType::Plane);
const CYLINDER: Option<SurfaceType> = Some(SurfaceType::Cylinder);

#[test]
fn arrays_of_many_models_are_many_models_and_predictions_find_them() {
    let clouds = files("data/train_data.h5", TRAIN);
    let found = files("out/predictions.h5", PREDICTIONS);
    let paths = |files: &[(String, Vec<u8>)]| -> Vec<String> {
        files.iter().map(|it| it.0.clone()).collect()
    };
    assert_eq!(
        [paths(&clouds), paths(&found)].concat(),
        [
            "data/train_data/00000.npz",
            "data/train_data/00001.npz",
            "out/predictions/00000_labels.npz",
            "out/predictions/00001_labels.npz",
        ]
    );
    let grouping = fit4cad::format::group(
        &[paths(&clouds), paths(&found)].concat(),
        &Default::default(),
    );
    let methods: Vec<_> = grouping
        .models
        .iter()
        .map(|it| (it.name.as_str(), it.files[1].method.as_deref()))
        .collect();
    assert_eq!(
        methods,
        [
            ("00000", Some("predictions")),
            ("00001", Some("predictions"))
        ]
    );
    for (place, scale) in [(0, 1.0), (1, 2.0)] {
        let model = model(&clouds[place].1, Some(&found[place].1));
        assert_eq!(model.cloud.len(), 80);
        assert_eq!(model.cloud.points()[1].x, 0.25 * scale);
        // ParseNet's numbers: 1 is a plane, 4 a cylinder, 5 a sphere. A label of -1 is none.
        let truth = told(&model.truth.unwrap());
        assert_eq!(truth, [(0, PLANE, 39), (1, CYLINDER, 40)]);
        let found = told(&model.submissions[0].segmentation);
        assert_eq!(found, [(0, PLANE, 40), (1, Some(SurfaceType::Sphere), 40)]);
    }
}

#[test]
fn a_file_of_one_model_stays_a_file() {
    for bytes in [HPNET, LATEST] {
        let found = files("HPNet/00007.h5", bytes);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].0, "HPNet/00007.h5");
        let model = model(&found[0].1, None);
        assert_eq!(model.cloud.points()[41].x, {
            let x = 5.0 + (std::f64::consts::PI / 5.0).cos();
            if bytes == LATEST {
                f64::from(x as f32)
            } else {
                x
            }
        });
        let kinds = told(&model.truth.unwrap());
        let expected = if bytes == LATEST {
            [None; 2]
        } else {
            [PLANE, CYLINDER]
        };
        assert_eq!(kinds, [(0, expected[0], 39), (1, expected[1], 40)]);
    }
}

#[test]
fn what_is_pickled_is_left_and_said_so() {
    let opened = open("shape.h5", SPFN).unwrap();
    assert_eq!(opened.notes().len(), 2);
    assert!(opened.notes()[0].contains("pickled"));
    assert!(opened.notes()[1].contains("without noise"));
    let cloud = files("shape.h5", SPFN);
    // Shares of 24 segments a point, as SPFN has them: the largest is meant.
    let found = files("SPFN/shape.h5", SPFN_FOUND);
    assert_eq!(found[0].0, "SPFN/shape_labels.h5");
    let model = model(&cloud[0].1, Some(&found[0].1));
    assert_eq!(told(&model.truth.unwrap()), [(0, None, 39), (1, None, 40)]);
    let found = told(&model.submissions[0].segmentation);
    assert_eq!(found, [(3, PLANE, 40), (5, CYLINDER, 40)]);
}

#[test]
fn what_cannot_be_used_is_told() {
    let error = |bytes: &[u8]| open("a.h5", bytes).err().unwrap().to_string();
    assert!(error(b"no HDF5 at all").contains("could not be read as HDF5"));
    assert!(error(&TRAIN[..300]).contains("could not be read as HDF5"));
}

#[test]
fn damage_anywhere_ends_in_words() {
    let mut random = fastrand::Rng::with_seed(7);
    for bytes in [TRAIN, PREDICTIONS, SPFN, SPFN_FOUND, LATEST] {
        for _ in 0..300 {
            let mut bytes = bytes.to_vec();
            for _ in 0..random.usize(1..6) {
                let at = random.usize(..bytes.len());
                bytes[at] = random.u8(..);
            }
            if random.bool() {
                bytes.truncate(random.usize(..bytes.len()));
            }
            if let Ok(opened) = open("a.h5", &bytes) {
                for entry in opened.entries().iter().take(4) {
                    // Whatever it is, it does not stop the program.
                    let _ = opened.read(entry);
                }
            }
        }
    }
}
