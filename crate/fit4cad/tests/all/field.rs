//! The protocols of the field on the benchmark's own test models, where they are there, against what
//! an independent script says of the same files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(
    clippy::approx_constant,
    reason = "one of the figures happens to be near π/4"
)]

use super::benchmark::{self, MODELS, TRUTH};
use fit4cad::metrics::segmentation::{Overlaps, fit4cad as ours, hpnet, panoptic, parsenet, spfn};
use fit4cad::model::{Model, Segmentation};

type Score = fn(&Overlaps) -> Option<f64>;

const PROTOCOLS: [(&str, Score); 7] = [
    ("DSC", ours::score),
    ("SPFN", spfn::score),
    ("SPFN, < 0.5 % removed", spfn::score_without_small),
    ("ParseNet", parsenet::score),
    ("HPNet", hpnet::score),
    ("F1@.5", panoptic::f1),
    ("PQ", panoptic::quality),
];

/// What to score, on which models, and the figures in the order of the protocols.
const TABLE: [(&str, &[&str], [f64; 7]); 9] = [
    (
        "HT",
        &MODELS,
        [0.8778, 0.8134, 0.7778, 0.9209, 0.9175, 0.9080, 0.8381],
    ),
    (
        "HT",
        &["PC1"],
        [0.9866, 0.9740, 0.9740, 0.9740, 0.9740, 1.0, 0.9740],
    ),
    (
        "HT",
        &["PC5"],
        [0.8464, 0.7853, 0.6162, 0.8768, 0.8444, 0.9014, 0.7922],
    ),
    (
        "HT",
        &["PC9"],
        [0.5677, 0.2628, 0.2242, 0.7496, 0.7479, 0.5556, 0.3797],
    ),
    (
        "PG",
        &MODELS,
        [0.6242, 0.5039, 0.4928, 0.6715, 0.6517, 0.5959, 0.4994],
    ),
    (
        "PG",
        &["PC1"],
        [0.3699, 0.2339, 0.2339, 0.2339, 0.2339, 0.2, 0.1371],
    ),
    (
        "PG",
        &["PC5"],
        [0.4798, 0.3894, 0.3534, 0.5409, 0.4808, 0.5217, 0.3586],
    ),
    (
        "PG",
        &["PC9"],
        [0.4030, 0.1667, 0.1237, 0.5533, 0.4999, 0.1088, 0.0911],
    ),
    ("truth", &MODELS, [1.0, 1.0, 0.8607, 1.0, 1.0, 1.0, 1.0]),
];

/// The answer of a method; the truth can answer as well.
fn answer<'a>(model: &'a Model, method: &str) -> &'a Segmentation {
    let mut submissions = model.submissions.iter();
    let found = submissions.find(|submission| submission.method == method);
    found.map_or(model.truth.as_ref().unwrap(), |found| &found.segmentation)
}

#[test]
fn the_published_answers_score_by_each_protocol_as_an_independent_script_says() {
    let Some(folder) = benchmark::folder() else {
        return;
    };
    let read = |name: &&str| benchmark::read(&folder, name, &[TRUTH, Some("HT"), Some("PG")]).0;
    let models: Vec<Model> = MODELS.iter().map(read).collect();
    for (method, names, expected) in TABLE {
        let chosen = || {
            models
                .iter()
                .filter(|model| names.contains(&&model.name[..]))
        };
        for ((protocol, score), expected) in PROTOCOLS.iter().zip(expected) {
            let scores = chosen().map(|model| {
                let truth = model.truth.as_ref().unwrap();
                let overlaps = Overlaps::of(model.cloud.len(), truth, answer(model, method));
                score(&overlaps.unwrap()).unwrap()
            });
            let mean = scores.sum::<f64>() / chosen().count() as f64;
            assert!(
                (mean - expected).abs() <= 0.0005,
                "{protocol} of {method} on {names:?}: {mean:.4}, not {expected}"
            );
        }
    }
}
