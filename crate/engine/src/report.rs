//! A score as a plain object: the JSON of the command line.

use fit4cad::{metrics, surface};
use serde::{Deserialize, Serialize, Serializer};
use tsify::Tsify;

use crate::diagnostic::DiagnosticInfo;
use crate::primitive::SurfaceType;

/// Which rules apply.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Protocol {
    /// The formulas of the paper, computed exactly.
    Definition,
    /// What the authors' evaluation scripts do.
    Published,
}

impl From<metrics::Protocol> for Protocol {
    fn from(protocol: metrics::Protocol) -> Self {
        match protocol {
            metrics::Protocol::Definition => Self::Definition,
            metrics::Protocol::Published => Self::Published,
        }
    }
}

impl From<Protocol> for metrics::Protocol {
    fn from(protocol: Protocol) -> Self {
        match protocol {
            Protocol::Definition => Self::Definition,
            Protocol::Published => Self::Published,
        }
    }
}

/// The measures by their keys; `null` where one cannot be had.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(transparent)]
pub struct Measures(
    #[serde(serialize_with = "by_key")]
    #[tsify(type = "Record<Measure, number | null>")]
    metrics::Measures,
);

fn by_key<S: Serializer>(measures: &metrics::Measures, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(
        measures
            .iter()
            .map(|(measure, value)| (measure.name(), value)),
    )
}

/// Those of predicted surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(transparent)]
pub struct FitMeasures(
    #[serde(serialize_with = "of_surfaces")]
    #[tsify(type = "Record<AccuracyMeasure, number | null>")]
    metrics::Measures,
);

fn of_surfaces<S: Serializer>(
    measures: &metrics::Measures,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let own = measures.iter();
    let own = own.filter(|(measure, _)| measure.group() == metrics::Group::Accuracy);
    serializer.collect_map(own.map(|(measure, value)| (measure.name(), value)))
}

/// How one true primitive was recognised.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct TruthReport {
    /// Its number.
    pub truth: u32,
    /// Number of the prediction that shares most points with it.
    #[serde(rename = "match")]
    pub matched: Option<u32>,
    /// Its type, where it is one of the five.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub size: u32,
    /// Classification of its points, and the fit of its match; d1 only where the match's own most
    /// overlapping primitive is this one, as d1 compares those two.
    #[serde(flatten)]
    pub measures: Measures,
}

/// How well one predicted primitive fits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct PredictionReport {
    /// Its number.
    pub prediction: u32,
    /// Number of the true primitive with which it shares most points.
    #[serde(rename = "match")]
    pub matched: Option<u32>,
    /// Its type, where it is one of the five.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub size: u32,
    /// DSC with that true primitive; 0 where there is none.
    #[serde(rename = "DSC")]
    pub dsc: Option<f64>,
    /// How its surface fits.
    #[serde(flatten)]
    pub fit: FitMeasures,
    /// Whether its type is another than that of the true primitive.
    pub type_error: bool,
}

/// Types of true primitives against types of their matches.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct TypeConfusion {
    /// Names of the rows: the five types, then `Other`.
    pub truth: Vec<&'static str>,
    /// Names of the columns: the five types, then `Other`, then `Missed`.
    #[serde(rename = "match")]
    pub matched: Vec<&'static str>,
    /// Number of true primitives, by row and column.
    pub counts: Vec<Vec<u32>>,
}

impl From<&metrics::hidden::TypeConfusion> for TypeConfusion {
    fn from(types: &metrics::hidden::TypeConfusion) -> Self {
        Self {
            truth: names(&[surface::OTHER]),
            matched: names(&[surface::OTHER, "Missed"]),
            counts: types.table().map(Vec::from).to_vec(),
        }
    }
}

/// What the paper's measures hide. Primitives are given by their numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Hidden {
    /// True primitives that share no point with any prediction.
    pub missed: Vec<u32>,
    /// True primitives whose match serves another one as well.
    pub merged: Vec<u32>,
    /// Predictions that are the match of no true primitive.
    pub spurious: Vec<u32>,
    /// Mean DSC from the predictions' side.
    pub prediction_dsc: Option<f64>,
    /// Types of true primitives against types of their matches.
    pub types: TypeConfusion,
    /// Share of the points that some prediction lists.
    pub labelled: Option<f64>,
    /// Share of the points that some true primitive lists.
    pub truth_labelled: Option<f64>,
}

/// The score of one submission on one model.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
// A flattened struct is written as a map, which is to be a plain object too.
#[tsify(missing_as_null, hashmap_as_object)]
pub struct Report {
    /// Name of the model.
    pub model: String,
    /// Name of the method.
    pub method: String,
    /// The rules that were applied.
    pub protocol: Protocol,
    /// Number of points of the cloud.
    pub points: u32,
    /// Number of true primitives.
    pub truth: u32,
    /// Number of predicted primitives.
    pub predicted: u32,
    /// The measures of the whole submission.
    pub mean: Measures,
    /// Predictions whose type is another than their true primitive's.
    pub type_errors: u32,
    /// One row per true primitive.
    pub primitives: Vec<TruthReport>,
    /// One row per predicted primitive.
    pub predictions: Vec<PredictionReport>,
    /// What the paper's measures hide.
    pub hidden: Hidden,
    /// Findings about the cloud, the truth and this submission.
    pub diagnostics: Vec<DiagnosticInfo>,
}

impl Report {
    /// Puts names in the place of positions.
    pub(crate) fn new(
        model: &str,
        method: &str,
        protocol: Protocol,
        report: &metrics::Report,
        diagnostics: Vec<DiagnosticInfo>,
    ) -> Self {
        Self {
            model: model.to_owned(),
            method: method.to_owned(),
            protocol,
            points: report.points as u32,
            truth: report.truth as u32,
            predicted: report.predicted as u32,
            mean: Measures(report.mean),
            type_errors: report.type_errors as u32,
            primitives: truth_rows(report),
            predictions: prediction_rows(report),
            hidden: hidden(report),
            diagnostics,
        }
    }
}

fn truth_rows(report: &metrics::Report) -> Vec<TruthReport> {
    let rows = report.primitives.iter().enumerate();
    rows.map(|(place, row)| {
        let matched = row.matched.and_then(|index| report.predictions.get(index));
        TruthReport {
            truth: row.number,
            matched: matched.map(|prediction| prediction.number),
            kind: row.kind.map(SurfaceType::from),
            size: row.size as u32,
            measures: Measures(report.measures_of(place).unwrap_or_default()),
        }
    })
    .collect()
}

fn prediction_rows(report: &metrics::Report) -> Vec<PredictionReport> {
    let rows = report.predictions.iter();
    rows.map(|row| PredictionReport {
        prediction: row.number,
        matched: row
            .matched
            .and_then(|place| report.primitives.get(place))
            .map(|primitive| primitive.number),
        kind: row.kind.map(SurfaceType::from),
        size: row.size as u32,
        dsc: row.dsc,
        fit: FitMeasures(row.fit),
        type_error: row.type_error,
    })
    .collect()
}

fn hidden(report: &metrics::Report) -> Hidden {
    let truth = |places: &[usize]| {
        let rows = places.iter().filter_map(|&at| report.primitives.get(at));
        rows.map(|row| row.number).collect()
    };
    let predictions = |places: &[usize]| {
        let rows = places.iter().filter_map(|&at| report.predictions.get(at));
        rows.map(|row| row.number).collect()
    };
    let hidden = &report.hidden;
    Hidden {
        missed: truth(&hidden.missed),
        merged: truth(&hidden.merged),
        spurious: predictions(&hidden.spurious),
        prediction_dsc: hidden.prediction_dsc,
        types: TypeConfusion::from(&hidden.types),
        labelled: hidden.labelled,
        truth_labelled: hidden.truth_labelled,
    }
}

/// The five types, then what stands beside them.
fn names(others: &[&'static str]) -> Vec<&'static str> {
    let types = surface::SurfaceType::ALL.map(surface::SurfaceType::name);
    types.into_iter().chain(others.iter().copied()).collect()
}
