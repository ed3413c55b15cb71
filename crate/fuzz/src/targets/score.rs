//! What is computed of models: scores, summaries, statistics, audits.

use fit4cad::audit;
use fit4cad::metrics::comparison::Comparison;
use fit4cad::metrics::field::Conditions;
use fit4cad::metrics::geometry::{Normalisation, Scale};
use fit4cad::metrics::histogram::{Bins, farthest};
use fit4cad::metrics::outcome::{figure, outcomes};
use fit4cad::metrics::recognition::recognise;
use fit4cad::metrics::{
    Distribution, Group, Measure, Protocol, Report, Score, agreement, evaluate, field_report,
    summarise,
};
use fit4cad::model::{Model, Segmentation};
use fit4cad::statistics::{DatasetStatistics, ModelStatistics};

use super::{MIB, text};
use crate::{Bytes, Target, shapes};

pub const SCORE: Target = Target {
    name: "score",
    run: |input| {
        let model = model(input);
        let empty = Segmentation::default();
        let (truth, submitted) = sides(&model, &empty);
        for protocol in Protocol::ALL {
            check(&evaluate(&model.cloud, truth, submitted, protocol));
            check(&evaluate(&model.cloud, submitted, truth, protocol));
        }
        let itself = evaluate(&model.cloud, truth, truth, Protocol::Definition);
        if truth
            .primitives
            .iter()
            .any(|primitive| !primitive.points.is_empty())
        {
            let dsc = itself.mean[Measure::Dsc];
            assert!(
                dsc.is_some_and(|dsc| dsc > 0.0 && dsc <= 1.0),
                "{dsc:?} of itself"
            );
        }
        figure(model.cloud.len(), truth, submitted);
        agreement::changed(model.cloud.len(), truth, submitted);
        let (first, second) = (truth.primitives.first(), submitted.primitives.last());
        let list = |primitive: Option<&fit4cad::model::Primitive>| {
            primitive.map(|it| it.points.clone()).unwrap_or_default()
        };
        outcomes(model.cloud.len(), &list(first), &list(second));
        let limit = farthest(&model, &submitted.primitives);
        for logarithmic in [false, true] {
            let bins = Bins::new(truth.primitives.len() * 7, limit, logarithmic);
            assert!(bins.edges().all(f64::is_finite));
            for primitive in &submitted.primitives {
                bins.counts(&model, primitive);
            }
        }
    },
    seeds: models,
    words: &[],
    longest: 8192,
    floor: MIB,
    quick: 18_000,
};

pub const FIELD: Target = Target {
    name: "field",
    run: |input| {
        let model = model(input);
        let empty = Segmentation::default();
        let (truth, submitted) = sides(&model, &empty);
        for normalisation in Normalisation::ALL {
            let scale = Scale {
                normalisation,
                ..Scale::default()
            };
            for (truth, submitted) in [(truth, submitted), (submitted, truth), (truth, truth)] {
                let report = field_report(&model.cloud, truth, submitted, scale);
                assert_eq!(report.rows.len(), truth.primitives.len());
                for (figure, value) in report.figures.iter() {
                    assert!(value.is_none_or(|value| value >= 0.0), "{figure} {value:?}");
                }
                let segments = recognise(&model.cloud, truth, submitted, normalisation);
                for segment in segments.into_iter().flatten() {
                    for value in [segment.mfe, segment.hausdorff, segment.parameters] {
                        assert!(value.is_none_or(|value| value >= 0.0), "{segment:?}");
                    }
                }
            }
        }
        for truth in [truth, submitted] {
            let found = Conditions::of(&model.cloud, truth);
            for value in [found.noise, found.spacing] {
                assert!(value.is_none_or(|value| value >= 0.0), "{found:?}");
            }
            assert!(
                found
                    .missing
                    .is_none_or(|share| (0.0..1.0).contains(&share))
            );
        }
    },
    seeds: models,
    words: &[],
    longest: 8192,
    floor: 4 * MIB,
    quick: 1_000,
};

pub const SUMMARIES: Target = Target {
    name: "summaries",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let figure = |bytes: &mut Bytes<'_>| bytes.flag().then(|| bytes.number());
        let rows = bytes.list(40, |bytes| {
            let method = bytes.one(["HT", "PG", "Ours", ""]);
            let mut measures = [None; Measure::ALL.len()];
            measures.iter_mut().for_each(|each| *each = figure(bytes));
            Score {
                method,
                measures,
                type_errors: bytes.below(5),
            }
        });
        let pairs = bytes.list(60, |bytes| (figure(bytes), figure(bytes)));
        for summary in summarise(rows.iter().copied()) {
            for measure in Measure::ALL {
                let spread = summary.over(measure);
                assert!(spread.is_none_or(|it| it.count >= 1 && it.min <= it.max));
            }
        }
        for measure in Measure::ALL {
            let compared = Comparison::of(measure.info().better, &pairs);
            assert_eq!(compared.differences.len(), pairs.len());
        }
        Distribution::of(pairs.iter().filter_map(|pair| pair.0));
        let (limit, count) = (bytes.number(), bytes.below(200));
        let bins = Bins::new(count, limit, bytes.flag());
        assert!(bins.of(bytes.number()) < count.max(1));
    },
    seeds: super::none,
    words: &[],
    longest: 2048,
    floor: MIB / 4,
    quick: 10_000,
};

pub const STATISTICS: Target = Target {
    name: "statistics",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let models = bytes.list(4, shapes::model);
        let each: Vec<ModelStatistics> = models.iter().map(ModelStatistics::of).collect();
        for model in &each {
            assert!(
                model
                    .unsegmented()
                    .is_none_or(|share| (0.0..=1.0).contains(&share))
            );
        }
        let all = DatasetStatistics::of(&each);
        assert_eq!(all.models, each.len());
        let shares = all.type_shares().unwrap_or_default();
        assert!(all.primitives == 0 || (shares.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    },
    seeds: super::none,
    words: &[],
    longest: 4096,
    floor: MIB,
    quick: 15_000,
};

pub const AUDIT: Target = Target {
    name: "audit",
    run: |input| {
        let (model, found) = if input.first().is_some_and(|first| first & 1 == 1) {
            text::read(&input[1..])
        } else {
            (model(input), Vec::new())
        };
        let audited = audit::audit(&model, &found);
        let truth = model
            .truth
            .as_ref()
            .map_or(0, |truth| truth.primitives.len());
        assert_eq!(audited.primitives.len(), truth);
        for finding in &audited.findings {
            assert!(!finding.message.is_empty() && finding.message.len() < 2000);
        }
        if let Some((corrected, corrections)) = audit::correct(&model) {
            assert!(corrections.len() <= 2 * truth);
            let model = Model {
                truth: Some(corrected),
                ..model
            };
            audit::audit(&model, &found);
        }
    },
    seeds: models,
    words: &[
        "Plane",
        "Torus",
        "Cone",
        "1e308",
        "-0",
        "NaN",
        "0.001",
        "Primitive1:=[",
    ],
    longest: 8192,
    floor: MIB,
    quick: 25_000,
};

/// A model decoded, or of texts where the first byte says so.
fn model(input: &[u8]) -> Model {
    let mut bytes = Bytes::new(input);
    if bytes.flag() {
        text::read(bytes.rest()).0
    } else {
        shapes::model(&mut bytes)
    }
}

/// The truth, and the first submission or the truth again.
fn sides<'a>(model: &'a Model, empty: &'a Segmentation) -> (&'a Segmentation, &'a Segmentation) {
    let truth = model.truth.as_ref().unwrap_or(empty);
    let first = model.submissions.first();
    (truth, first.map_or(truth, |each| &each.segmentation))
}

fn models() -> Vec<Vec<u8>> {
    let texts = text::whole_models().into_iter();
    texts.map(|text| [&[1], text.as_slice()].concat()).collect()
}

/// Shares lie between 0 and 1, distances are not negative, and nothing is NaN.
fn check(report: &Report) {
    let rows = report.primitives.iter().map(|row| &row.classification);
    let fits = report.predictions.iter().map(|row| &row.fit);
    for measures in rows.chain(fits).chain([&report.mean]) {
        for (measure, value) in measures.iter() {
            let most = match measure.group() {
                Group::Accuracy => f64::INFINITY,
                _ => 1.0 + 1e-12,
            };
            assert!(
                value.is_none_or(|value| (0.0..=most).contains(&value)),
                "{} {value:?}",
                measure.name()
            );
        }
    }
}
