//! All measures of one submission on one model.

use super::accuracy::fit_accuracy;
use super::classification::Counts;
use super::coefficients::{coefficient_distance, published_distance, published_mean};
use super::hidden::{Hidden, Pairing};
use super::matching::{Incidence, best_matches};
use super::measure::Published;
use super::{Measure, Measures, Protocol, Source, mean};
use crate::cloud::Cloud;
use crate::model::{Coefficients, Model, Primitive, Segmentation};
use crate::surface::SurfaceType;

/// The score of one submission on one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The rules that were applied.
    pub protocol: Protocol,
    /// Number of points of the cloud.
    pub points: usize,
    /// Number of true primitives.
    pub truth: usize,
    /// Number of predicted primitives.
    pub predicted: usize,
    /// Classification measures averaged over the true primitives, fit accuracy over the predicted.
    pub mean: Measures,
    /// Predictions whose type differs from that of their most overlapping true primitive, where
    /// both name one of the five.
    pub type_errors: usize,
    /// One row per true primitive, in their order.
    pub primitives: Vec<TruthRow>,
    /// One row per predicted primitive, in their order.
    pub predictions: Vec<PredictionRow>,
    /// What the paper's measures hide.
    pub hidden: Hidden,
}

impl Report {
    /// The measures of the true primitive at a place: the classification of its points, and the fit
    /// of its match; d1 only where the match's own most overlapping primitive is this one, as d1
    /// compares those two. `None` beyond the last.
    pub fn measures_of(&self, place: usize) -> Option<Measures> {
        let row = self.primitives.get(place)?;
        let matched = row.matched.and_then(|index| self.predictions.get(index));
        let mutual = matched.filter(|prediction| prediction.matched == Some(place));
        Some(Measures::from_fn(|measure| {
            let fit = match measure.source() {
                Source::Points(_) => return row.classification[measure],
                Source::Distances(_) => matched,
                Source::Coefficients => mutual,
            };
            fit.and_then(|prediction| prediction.fit[measure])
        }))
    }
}

/// How one true primitive was recognised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TruthRow {
    /// Its number in the file.
    pub number: u32,
    /// Its type, where it is one of the five.
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub size: usize,
    /// Place of its match among the predictions.
    pub matched: Option<usize>,
    /// The counts, in the universe of the protocol; FP and FN as defined, whatever the protocol.
    pub counts: Counts,
    /// The measures of its points under the protocol's headings.
    pub classification: Measures,
}

impl TruthRow {
    /// What enters the mean: where a measure is 0/0, what stands for the one that is meant, whatever
    /// heading it is published under.
    fn for_mean(&self, measure: Measure, protocol: Protocol) -> Option<f64> {
        let ratio = measure.ratio(protocol)?;
        self.classification[measure].or_else(|| ratio.for_mean(self.counts))
    }
}

/// How well one predicted primitive fits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PredictionRow {
    /// Its number in the file.
    pub number: u32,
    /// Its type, where it is one of the five.
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub size: usize,
    /// Place of its most overlapping true primitive.
    pub matched: Option<usize>,
    /// How many points it shares with it.
    pub shared: usize,
    /// DSC with it; 0 if there is none.
    pub dsc: Option<f64>,
    /// The measures of its surface. Those of distances are `None` without surface or points; the
    /// coefficient distance, by the protocol, if there is no true primitive, if the types differ
    /// (by definition) or the lengths do (as published), or a vector is missing.
    pub fit: Measures,
    /// Whether its type differs from that of its true primitive, where both are known.
    pub type_error: bool,
}

/// Why there is no report.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ScoreError {
    /// The model has no ground truth.
    #[error("{model} has no ground truth to score against; add its `_primitives.txt`")]
    NoTruth {
        /// Name of the model.
        model: String,
    },
    /// The model has no submission of that method.
    #[error("{model} has no submission of method `{method}`")]
    NoSubmission {
        /// Name of the model.
        model: String,
        /// The method asked for.
        method: String,
    },
}

/// Scores the submission of one method.
///
/// # Errors
/// [`ScoreError`] if the model lacks a truth or that submission.
///
/// ```
/// use fit4cad::metrics::{Measure, Protocol, score};
/// use fit4cad::sample::{Options, generate, imperfect};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let mut model = generate("flange", &options)?;
/// model.submit("MINE", imperfect(&model, 1));
/// let report = score(&model, "MINE", Protocol::Definition);
/// assert!(report.is_ok_and(|report| report.mean[Measure::Dsc].is_some_and(|dsc| dsc > 0.5)));
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn score(model: &Model, method: &str, protocol: Protocol) -> Result<Report, ScoreError> {
    let truth = model.truth.as_ref().ok_or_else(|| ScoreError::NoTruth {
        model: model.name.clone(),
    })?;
    let submissions = &mut model.submissions.iter();
    let submission = submissions
        .find(|submission| submission.method == method)
        .ok_or_else(|| ScoreError::NoSubmission {
            model: model.name.clone(),
            method: method.to_owned(),
        })?;
    Ok(evaluate(
        &model.cloud,
        truth,
        &submission.segmentation,
        protocol,
    ))
}

/// Scores a segmentation against the true one. O(points + listed indices + overlaps).
///
/// ```
/// use fit4cad::metrics::{Measure, Protocol, evaluate};
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let model = generate("flange", &options)?;
/// let truth = model.truth.unwrap_or_default();
/// let report = evaluate(&model.cloud, &truth, &truth, Protocol::Definition);
/// assert_eq!((report.mean[Measure::Dsc], report.type_errors), (Some(1.0), 0));
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn evaluate(
    cloud: &Cloud,
    truth: &Segmentation,
    prediction: &Segmentation,
    protocol: Protocol,
) -> Report {
    let truth_incidence = Incidence::new(truth, cloud.len());
    let prediction_incidence = Incidence::new(prediction, cloud.len());
    let pairing = Pairing {
        of_truth: best_matches(truth, &prediction_incidence),
        of_prediction: best_matches(prediction, &truth_incidence),
        truth,
        prediction,
        truth_incidence,
        prediction_incidence,
    };
    let primitives = truth_rows(&pairing, cloud.len(), protocol);
    let predictions = prediction_rows(&pairing, cloud, protocol);
    Report {
        protocol,
        points: cloud.len(),
        truth: truth.primitives.len(),
        predicted: prediction.primitives.len(),
        mean: means(&pairing, &primitives, &predictions, protocol),
        type_errors: predictions.iter().filter(|row| row.type_error).count(),
        hidden: Hidden::of(&pairing, cloud.len()),
        primitives,
        predictions,
    }
}

fn truth_rows(pairing: &Pairing, points: usize, protocol: Protocol) -> Vec<TruthRow> {
    let universe = match protocol {
        Protocol::Definition => points,
        Protocol::Published => pairing.truth_incidence.labelled_count(),
    };
    let in_universe = |prediction: &Primitive| match protocol {
        Protocol::Definition => prediction.points.len(),
        Protocol::Published => {
            let labelled = |point: &&u32| pairing.truth_incidence.is_labelled(**point);
            prediction.points.iter().filter(labelled).count()
        }
    };
    let predictions = &pairing.prediction.primitives;
    let sizes: Vec<usize> = predictions.iter().map(in_universe).collect();
    let rows = pairing.truth.primitives.iter().zip(&pairing.of_truth);
    rows.map(|(primitive, found)| {
        let size = primitive.points.len();
        let index = found.map(|found| found.index);
        let shared = found.map_or(0, |found| found.shared);
        let predicted = index
            .and_then(|index| sizes.get(index))
            .copied()
            .unwrap_or(0);
        let counts = Counts::of_sets(size, predicted, shared, universe);
        let whole = index.and_then(|index| predictions.get(index));
        let whole = whole.map_or(0, |prediction| prediction.points.len());
        let whole = Counts::of_sets(size, whole, shared, points);
        let classification = Measures::from_fn(|measure| {
            let ratio = measure.ratio(protocol)?;
            ratio.of(match ratio.published {
                Published::Whole => whole,
                Published::Labelled | Published::Other(_) => counts,
            })
        });
        TruthRow {
            number: primitive.number,
            kind: primitive.kind,
            size,
            matched: index,
            counts,
            classification,
        }
    })
    .collect()
}

fn prediction_rows(pairing: &Pairing, cloud: &Cloud, protocol: Protocol) -> Vec<PredictionRow> {
    let predictions = pairing.prediction.primitives.iter();
    let rows = predictions
        .zip(&pairing.of_prediction)
        .zip(pairing.prediction_dsc());
    rows.map(|((prediction, found), dsc)| {
        let partner = found.and_then(|found| pairing.truth.primitives.get(found.index));
        let surface = prediction.surface.as_ref();
        let accuracy = surface.and_then(|surface| fit_accuracy(cloud, &prediction.points, surface));
        PredictionRow {
            number: prediction.number,
            kind: prediction.kind,
            size: prediction.points.len(),
            matched: found.map(|found| found.index),
            shared: found.map_or(0, |found| found.shared),
            dsc,
            fit: Measures::from_fn(|measure| match measure.source() {
                Source::Points(_) => None,
                Source::Distances(of) => accuracy.map(of),
                Source::Coefficients => distance(prediction, partner?, protocol),
            }),
            type_error: partner.is_some_and(|partner| types_differ(prediction, partner)),
        }
    })
    .collect()
}

fn types_differ(prediction: &Primitive, truth: &Primitive) -> bool {
    matches!((prediction.kind, truth.kind), (Some(one), Some(other)) if one != other)
}

fn distance(prediction: &Primitive, truth: &Primitive, protocol: Protocol) -> Option<f64> {
    let (v, w) = (prediction.implicit.values()?, truth.implicit.values()?);
    match protocol {
        Protocol::Definition if types_differ(prediction, truth) => None,
        Protocol::Definition => coefficient_distance(v, w),
        Protocol::Published => published_distance(v, w),
    }
}

fn means(
    pairing: &Pairing,
    primitives: &[TruthRow],
    predictions: &[PredictionRow],
    protocol: Protocol,
) -> Measures {
    Measures::from_fn(|measure| match (measure.source(), protocol) {
        (Source::Points(_), _) => {
            let rows = primitives.iter();
            mean(rows.map(|row| row.for_mean(measure, protocol)))
        }
        (Source::Coefficients, Protocol::Published) => {
            published_mean(vectors(pairing), pairing.truth.primitives.len())
        }
        (Source::Distances(_) | Source::Coefficients, _) => {
            mean(predictions.iter().map(|row| row.fit[measure]))
        }
    })
}

/// The vector of each prediction with that of its true primitive.
fn vectors<'a>(
    pairing: &'a Pairing,
) -> impl Iterator<Item = (&'a Coefficients, Option<&'a Coefficients>)> {
    let rows = pairing
        .prediction
        .primitives
        .iter()
        .zip(&pairing.of_prediction);
    rows.map(|(prediction, found)| {
        let partner = found.and_then(|found| pairing.truth.primitives.get(found.index));
        (
            &prediction.implicit,
            partner.map(|partner| &partner.implicit),
        )
    })
}
