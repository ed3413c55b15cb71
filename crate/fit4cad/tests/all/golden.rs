//! The benchmark's own test models, where they are there, score as an independent implementation
//! says they do.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test fails by panicking"
)]

use std::fs;
use std::path::Path;

use super::benchmark::{self, MODELS, TRUTH};
use fit4cad::metrics::accuracy::fit_accuracy;
use fit4cad::metrics::{Measure, Protocol, Report, score};
use fit4cad::model::Model;
use fit4cad::surface::{Form, Surface};
use serde_json::Value;

const METHODS: [&str; 2] = ["HT", "PG"];

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

/// A model with its truth and both published results.
fn model(folder: &Path, name: &str) -> Model {
    benchmark::read(folder, name, &[TRUTH, Some("HT"), Some("PG")]).0
}

/// Every report that an expectation speaks of, with that expectation.
fn reports(folder: &Path, expectations: &Value) -> Vec<(String, Protocol, Report, Value, Value)> {
    let mut reports = Vec::new();
    for (name, expected) in expectations.as_object().unwrap() {
        let model = model(folder, name);
        if model.cloud.is_empty() {
            continue;
        }
        for method in METHODS {
            let Some(of_method) = expected.get(method) else {
                continue;
            };
            for protocol in Protocol::ALL {
                let report = score(&model, method, protocol).unwrap();
                let label = format!("{name} {method} {protocol}");
                assert_eq!(
                    Some(report.points as u64),
                    expected["points"].as_u64(),
                    "{label}"
                );
                assert_eq!(
                    Some(report.truth as u64),
                    expected["truth"].as_u64(),
                    "{label}"
                );
                let predicted = of_method["predicted"].as_u64();
                assert_eq!(Some(report.predicted as u64), predicted, "{label}");
                let figures = of_method[protocol.name()].clone();
                reports.push((label, protocol, report, figures, of_method["paper"].clone()));
            }
        }
    }
    reports
}

fn is_accuracy(measure: Measure) -> bool {
    matches!(measure, Measure::Mfe | Measure::DHaus)
}

#[test]
fn every_golden_value_is_met() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let golden = json(&folder.join("golden.json"));
    let reports = reports(&folder, &golden);
    let expected = MODELS.len() * METHODS.len() * Protocol::ALL.len();
    assert_eq!(reports.len(), expected);
    let (mut compared, mut worst) = (0, [0.0f64; 2]);
    let mut misses = Vec::new();
    for (label, protocol, report, figures, _) in &reports {
        for measure in Measure::ALL {
            let Some(expected) = figures[measure.name()].as_f64() else {
                // The published protocol has no figures of its own for distances.
                if *protocol == Protocol::Definition || !is_accuracy(measure) {
                    assert_eq!(report.mean.get(measure), None, "{label} {measure}");
                }
                continue;
            };
            let found = report
                .mean
                .get(measure)
                .expect("a value where the golden file has one");
            let deviation = (found - expected).abs();
            let tolerance = if is_accuracy(measure) { 1e-7 } else { 1e-9 };
            if deviation > tolerance {
                misses.push(format!("{label} {measure}: {found} instead of {expected}"));
            }
            let kind = usize::from(is_accuracy(measure));
            worst[kind] = worst[kind].max(deviation);
            compared += 1;
        }
        if let Some(expected) = figures["type_errors"].as_u64() {
            assert_eq!(report.type_errors as u64, expected, "{label}");
            compared += 1;
        }
    }
    eprintln!(
        "{compared} values; largest deviation {:e}, of distances {:e}",
        worst[0], worst[1]
    );
    assert!(misses.is_empty(), "{}", misses.join("\n"));
    // HT: 10 by definition and 7 as published for each model; PG: 6 and 6.
    assert_eq!(compared, 290);
}

#[test]
fn the_rounded_figures_of_both_methods_are_met() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let published = json(&folder.join("published_methods.json"));
    for (label, _, report, figures, _) in reports(&folder, &published) {
        for measure in Measure::ALL {
            if let Some(expected) = figures[measure.name()].as_f64() {
                let found = report.mean.get(measure).unwrap();
                assert!(
                    (found - expected).abs() < 1e-6,
                    "{label} {measure}: {found}"
                );
            }
        }
    }
}

#[test]
fn the_published_protocol_meets_the_tables_of_the_paper() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let golden = json(&folder.join("golden.json"));
    for (label, protocol, report, _, paper) in reports(&folder, &golden) {
        if protocol != Protocol::Published {
            continue;
        }
        for measure in Measure::ALL
            .into_iter()
            .filter(|measure| !is_accuracy(*measure))
        {
            let Some(printed) = paper[measure.name()].as_f64() else {
                continue;
            };
            // The published result files themselves contradict the table here.
            if label.starts_with("PC5 HT") && matches!(measure, Measure::Dsc | Measure::Tpr) {
                continue;
            }
            let found = report.mean.get(measure).unwrap();
            assert!(
                (found - printed).abs() < 0.0015,
                "{label} {measure}: {found}"
            );
        }
    }
}

#[test]
fn both_forms_of_every_true_surface_describe_the_points() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let golden = json(&folder.join("golden.json"));
    let (mut compared, mut off) = (0, Vec::new());
    for name in golden.as_object().unwrap().keys() {
        let model = model(&folder, name);
        for primitive in &model.truth.as_ref().unwrap().primitives {
            let kind = primitive.kind.unwrap();
            for form in Form::ALL {
                let values = primitive.coefficients(form).values().unwrap();
                let surface = Surface::from_form(form, kind, values).unwrap().surface;
                let fit = fit_accuracy(&model.cloud, &primitive.points, &surface).unwrap();
                compared += 1;
                if fit.mfe > 1e-3 {
                    off.push((name.clone(), primitive.number));
                }
            }
        }
    }
    assert_eq!(compared, 2 * 256);
    // The known errata: these lists of PC31 hold points far off their surfaces.
    off.dedup();
    let known = [7, 10, 11, 15, 16, 17, 19].map(|number| ("PC31".to_owned(), number));
    assert_eq!(off, known);
}
