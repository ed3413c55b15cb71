//! The benchmark's own files, read from `../shared/fit4cad` or `$FIT4CAD_SHARED/fit4cad`; skipped,
//! saying so, where they are not there.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use fit4cad::diagnostics::{Diagnostic, Severity};
use fit4cad::format::{Role, SourceFile, read_model};
use fit4cad::model::{Coefficients, Model, Segmentation};

fn test_sample() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let shared = std::env::var_os("FIT4CAD_SHARED").map_or(root.join("../shared"), PathBuf::from);
    let folder = shared.join("fit4cad/test_sample");
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: {} is not there", folder.display());
    None
}

/// Reads a model of the test sample with the results of both methods.
fn read(folder: &Path, name: &str) -> (Model, Vec<Diagnostic>) {
    let mut files = vec![(format!("pointCloud/{name}.txt"), Role::Cloud, None)];
    for (method, suffix) in [(None, ""), (Some("HT"), "_HT"), (Some("PG"), "_PG")] {
        for (role, word) in [
            (Role::Primitives, "primitives"),
            (Role::Parametric, "parametric"),
            (Role::Implicit, "implicit"),
        ] {
            let path = format!("pointCloud_{word}{suffix}/{name}_{word}.txt");
            if folder.join(&path).exists() {
                files.push((path, role, method));
            }
        }
    }
    let contents: Vec<Vec<u8>> = files
        .iter()
        .map(|(path, ..)| fs::read(folder.join(path)).unwrap())
        .collect();
    let sources: Vec<SourceFile<'_>> = files
        .iter()
        .zip(&contents)
        .map(|((path, role, method), bytes)| SourceFile {
            path,
            role: *role,
            method: *method,
            bytes,
        })
        .collect();
    read_model(name, &sources)
}

fn errors(diagnostics: &[Diagnostic]) -> Vec<String> {
    diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.severity == Severity::Error)
        .map(Diagnostic::to_string)
        .collect()
}

fn of_method<'a>(model: &'a Model, method: &str) -> &'a Segmentation {
    let submission = model
        .submissions
        .iter()
        .find(|submission| submission.method == method);
    &submission.unwrap().segmentation
}

const NAMES: [&str; 10] = [
    "PC1", "PC2", "PC5", "PC9", "PC11", "PC14", "PC16", "PC27", "PC31", "PC33",
];

#[test]
fn the_test_sample_reads_with_one_error_the_cylinder_of_nine_numbers() {
    let Some(folder) = test_sample() else { return };
    let mut all = Vec::new();
    for name in NAMES {
        let (model, diagnostics) = read(&folder, name);
        for diagnostic in &diagnostics {
            eprintln!("{diagnostic}");
        }
        all.extend(errors(&diagnostics));
        assert!(model.cloud.len() > 1000, "{name}");
        assert!(model.truth.is_some(), "{name}");
        assert_eq!(model.submissions.len(), 2, "{name}");
    }
    assert_eq!(all.len(), 1, "{all:#?}");
    assert!(
        all[0].contains("pointCloud_implicit_HT/PC2_implicit.txt:3:15"),
        "{}",
        all[0]
    );
    assert!(all[0].contains("9 numbers"), "{}", all[0]);
}

#[test]
fn every_truth_primitive_of_the_test_sample_has_points_and_a_surface() {
    let Some(folder) = test_sample() else { return };
    for name in NAMES {
        let truth = read(&folder, name).0.truth.unwrap();
        for primitive in &truth.primitives {
            assert!(!primitive.points.is_empty(), "{name} {}", primitive.number);
            assert!(primitive.surface.is_some(), "{name} {}", primitive.number);
            assert!(
                primitive.parametric.values().is_some(),
                "{name} {}",
                primitive.number
            );
            assert!(
                primitive.implicit.values().is_some(),
                "{name} {}",
                primitive.number
            );
        }
    }
}

#[test]
fn a_malformed_entry_and_a_missing_one_stay_so_where_the_file_is_there() {
    let Some(folder) = test_sample() else { return };
    let (pc2, _) = read(&folder, "PC2");
    let second = &of_method(&pc2, "HT").primitives[1];
    assert_eq!(second.implicit, Coefficients::Malformed);
    assert!(second.surface.is_some());
    let (pc27, _) = read(&folder, "PC27");
    let primitives = &of_method(&pc27, "HT").primitives;
    assert_eq!(primitives.len(), 9);
    let missing: Vec<u32> = primitives
        .iter()
        .filter(|primitive| primitive.implicit == Coefficients::Missing)
        .map(|primitive| primitive.number)
        .collect();
    assert_eq!(missing, [9]);
}
