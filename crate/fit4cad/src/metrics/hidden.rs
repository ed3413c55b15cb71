//! What the paper's measures hide.
//!
//! They look at each true primitive and the prediction that serves it best. Predictions that
//! serve none do not enter, nor does it show when one prediction serves several primitives, when
//! the surface is of another type, or how much of the cloud is labelled at all.

use super::classification::Counts;
use super::matching::{Incidence, Match};
use super::{Measure, Protocol, mean};
use crate::model::Segmentation;
use crate::surface::SurfaceType;

/// Findings beside the paper's measures. Primitives are given by their place in their segmentation.
#[derive(Debug, Clone, PartialEq)]
pub struct Hidden {
    /// True primitives that share no point with any prediction.
    pub missed: Vec<usize>,
    /// True primitives whose match serves another true primitive as well: they were merged.
    pub merged: Vec<usize>,
    /// Predictions that are the match of no true primitive: splinters and inventions.
    pub spurious: Vec<usize>,
    /// Mean over the predictions of DSC with the most overlapping true primitive, 0 where there is
    /// none; `None` without predictions.
    pub prediction_dsc: Option<f64>,
    /// Types of true primitives against types of their matches.
    pub types: TypeConfusion,
    /// Share of the cloud's points that some prediction lists, 0 to 1; `None` for an empty cloud.
    pub labelled: Option<f64>,
    /// Share of the cloud's points that some true primitive lists, for comparison.
    pub truth_labelled: Option<f64>,
}

/// Row and column of what is none of the five types.
const OTHER: usize = SurfaceType::ALL.len();
/// Column of what has no match.
const MISSED: usize = OTHER + 1;

/// How often a true primitive of one type was matched by a prediction of another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TypeConfusion {
    counts: [[u32; MISSED + 1]; OTHER + 1],
}

/// What stands in the column of a true primitive's type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MatchedType {
    /// Its match is of this type.
    Type(SurfaceType),
    /// Its match names none of the five types.
    Other,
    /// It has no match.
    Missed,
}

impl TypeConfusion {
    /// Number of true primitives of a type (`None`: none of the five) with such a match.
    pub fn count(&self, truth: Option<SurfaceType>, matched: MatchedType) -> u32 {
        let (row, column) = Self::place(truth, matched);
        self.counts
            .get(row)
            .and_then(|row| row.get(column))
            .copied()
            .unwrap_or(0)
    }

    /// The whole table. Rows: truth by [`SurfaceType::ALL`], then other; columns: match by
    /// [`SurfaceType::ALL`], then other, then missed.
    pub fn table(&self) -> &[[u32; MISSED + 1]; OTHER + 1] {
        &self.counts
    }

    pub(super) fn add(&mut self, truth: Option<SurfaceType>, matched: MatchedType) {
        let (row, column) = Self::place(truth, matched);
        if let Some(count) = self.counts.get_mut(row).and_then(|row| row.get_mut(column)) {
            *count += 1;
        }
    }

    fn place(truth: Option<SurfaceType>, matched: MatchedType) -> (usize, usize) {
        let column = match matched {
            MatchedType::Type(kind) => kind as usize,
            MatchedType::Other => OTHER,
            MatchedType::Missed => MISSED,
        };
        (truth.map_or(OTHER, |kind| kind as usize), column)
    }
}

/// Both segmentations with their points turned round and their matches.
pub(super) struct Pairing<'a> {
    pub truth: &'a Segmentation,
    pub prediction: &'a Segmentation,
    pub truth_incidence: Incidence,
    pub prediction_incidence: Incidence,
    /// For each true primitive, its match among the predictions.
    pub of_truth: Vec<Option<Match>>,
    /// For each prediction, its most overlapping true primitive.
    pub of_prediction: Vec<Option<Match>>,
}

impl Hidden {
    pub(super) fn of(pairing: &Pairing, points: usize) -> Self {
        let mut served = vec![0usize; pairing.prediction.primitives.len()];
        for found in pairing.of_truth.iter().flatten() {
            if let Some(count) = served.get_mut(found.index) {
                *count += 1;
            }
        }
        let mut missed = Vec::new();
        let mut merged = Vec::new();
        let mut types = TypeConfusion::default();
        let rows = pairing.truth.primitives.iter().zip(&pairing.of_truth);
        for (index, (primitive, found)) in rows.enumerate() {
            let matched = match found {
                None => {
                    missed.push(index);
                    MatchedType::Missed
                }
                Some(found) => {
                    if served.get(found.index).is_some_and(|&count| count > 1) {
                        merged.push(index);
                    }
                    let prediction = pairing.prediction.primitives.get(found.index);
                    prediction
                        .and_then(|prediction| prediction.kind)
                        .map_or(MatchedType::Other, MatchedType::Type)
                }
            };
            types.add(primitive.kind, matched);
        }
        let spurious = (0..served.len()).filter(|&index| served.get(index) == Some(&0));
        let share = |incidence: &Incidence| {
            (points > 0).then(|| incidence.labelled_count() as f64 / points as f64)
        };
        Self {
            missed,
            merged,
            spurious: spurious.collect(),
            prediction_dsc: mean(pairing.prediction_dsc()),
            types,
            labelled: share(&pairing.prediction_incidence),
            truth_labelled: share(&pairing.truth_incidence),
        }
    }
}

impl Pairing<'_> {
    /// DSC of each prediction with its most overlapping true primitive.
    pub fn prediction_dsc(&self) -> impl Iterator<Item = Option<f64>> {
        let rows = self.prediction.primitives.iter().zip(&self.of_prediction);
        rows.map(|(prediction, found)| {
            let Some(found) = found else {
                return Some(0.0);
            };
            let size = prediction.points.len();
            let truth = self.truth.primitives.get(found.index)?.points.len();
            let dice = Measure::Dsc.ratio(Protocol::Definition)?;
            dice.of(Counts::of_sets(truth, size, found.shared, 0))
        })
    }
}
