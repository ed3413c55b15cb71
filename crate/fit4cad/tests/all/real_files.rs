//! The benchmark's own files read as they should, where they are there.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use super::benchmark::{self, MODELS, TRUTH};
use fit4cad::diagnostics::{Diagnostic, Severity};
use fit4cad::model::{Coefficients, Model, Segmentation};

/// A model of the test sample with its truth and the results of both methods.
fn read(folder: &Path, name: &str) -> (Model, Vec<Diagnostic>) {
    benchmark::read(folder, name, &[TRUTH, Some("HT"), Some("PG")])
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

#[test]
fn the_test_sample_reads_with_one_error_the_cylinder_of_nine_numbers() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let mut all = Vec::new();
    for name in MODELS {
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
    let Some(folder) = benchmark::folder() else {
        return;
    };
    for name in MODELS {
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
    let Some(folder) = benchmark::folder() else {
        return;
    };
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
