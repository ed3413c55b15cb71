//! What an audit finds in the benchmark's own test models, where they are there.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use super::benchmark::{self, MODELS, TRUTH};
use fit4cad::audit::{Check, audit, correct};
use fit4cad::diagnostics::Diagnostic;
use fit4cad::model::Model;

/// A model of the test sample with its truth.
fn read(folder: &Path, name: &str) -> (Model, Vec<Diagnostic>) {
    benchmark::read(folder, name, &[TRUTH])
}

fn found(model: &Model, diagnostics: &[Diagnostic]) -> Vec<(String, Option<u32>, Check)> {
    let findings = audit(model, diagnostics).findings;
    findings
        .iter()
        .map(|finding| (model.name.clone(), finding.primitive, finding.check))
        .collect()
}

/// The last index of each of sixteen lists of PC31 is a point far off a surface that all others
/// lie on; its parametric file is empty.
#[test]
fn the_test_sample_has_an_empty_file_and_sixteen_stray_points_and_nothing_else() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let mut all = Vec::new();
    for name in MODELS {
        let (model, diagnostics) = read(&folder, name);
        all.extend(found(&model, &diagnostics));
    }
    let with_stray = [5].into_iter().chain(7..=21);
    let stray = with_stray.map(|number| ("PC31".to_owned(), Some(number), Check::StrayPoint));
    let expected: Vec<_> = [("PC31".to_owned(), None, Check::File)]
        .into_iter()
        .chain(stray)
        .collect();
    assert_eq!(all, expected);
}

#[test]
fn taking_the_stray_points_out_leaves_no_finding() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let (mut model, _) = read(&folder, "PC31");
    let stray = audit(&model, &[]).findings;
    for primitive in &mut model.truth.as_mut().unwrap().primitives {
        if stray
            .iter()
            .any(|it| it.primitive == Some(primitive.number))
        {
            primitive.points.pop();
        }
    }
    assert_eq!(found(&model, &[]), []);
}

#[test]
fn forms_that_fit_are_left_as_they_are() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    for name in MODELS {
        let (model, _) = read(&folder, name);
        let (truth, corrections) = correct(&model).unwrap();
        assert_eq!(corrections, [], "{name}");
        assert_eq!(Some(truth), model.truth, "{name}");
    }
}
