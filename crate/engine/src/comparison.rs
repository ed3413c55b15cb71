//! A method against another over the models that both have.

use fit4cad::metrics::{Better, Measure, comparison, signed_rank};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::summary::{known, rows_of};

/// Which of two figures is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// The own one.
    Better,
    /// The other one.
    Worse,
    /// Neither, as far as six digits tell.
    Even,
}

impl From<comparison::Outcome> for Outcome {
    fn from(outcome: comparison::Outcome) -> Self {
        match outcome {
            comparison::Outcome::Better => Self::Better,
            comparison::Outcome::Worse => Self::Worse,
            comparison::Outcome::Even => Self::Even,
        }
    }
}

/// An own figure against another.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct Difference {
    /// Own minus theirs.
    pub by: f64,
    /// Which of them is better.
    pub outcome: Outcome,
}

impl From<comparison::Difference> for Difference {
    fn from(difference: comparison::Difference) -> Self {
        Self {
            by: difference.by,
            outcome: difference.outcome.into(),
        }
    }
}

/// Wilcoxon's signed-rank test of the differences.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct SignedRank {
    /// Differences that are not zero: the pairs that the test looks at.
    pub pairs: u32,
    /// Sum of the ranks of the positive differences.
    pub positive: f64,
    /// Sum of the ranks of the negative ones.
    pub negative: f64,
    /// Probability, two-sided, that chance alone drives the rank sums as far apart.
    pub probability: f64,
    /// Whether it is counted over all signs, and not that of the normal distribution.
    pub exact: bool,
}

impl From<signed_rank::SignedRank> for SignedRank {
    fn from(test: signed_rank::SignedRank) -> Self {
        Self {
            pairs: test.pairs as u32,
            positive: test.positive,
            negative: test.negative,
            probability: test.probability,
            exact: test.is_exact,
        }
    }
}

/// One figure of two methods over models; `null` where a figure is missing.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Paired {
    /// The difference on each model.
    #[tsify(type = "(Difference | null)[]")]
    pub differences: Vec<Option<Difference>>,
    /// Own mean over the models where both figures are there.
    pub own: Option<f64>,
    /// Their mean over the same models.
    pub theirs: Option<f64>,
    /// The difference of the two means.
    pub mean: Option<Difference>,
    /// On how many models the own figure is the better one.
    pub better: u32,
    /// On how many the other is.
    pub worse: u32,
    /// On how many neither is.
    pub even: u32,
    /// Whether the differences are more than chance; `null` where there is none.
    pub test: Option<SignedRank>,
}

impl Paired {
    fn of(better: Better, pairs: impl Iterator<Item = (Option<f64>, Option<f64>)>) -> Self {
        let found = comparison::Comparison::of(better, &pairs.collect::<Vec<_>>());
        let count = |outcome| found.count(outcome) as u32;
        let differences = found.differences.iter();
        Self {
            differences: differences.map(|it| it.map(Difference::from)).collect(),
            own: found.own,
            theirs: found.theirs,
            mean: found.mean.map(Difference::from),
            better: count(comparison::Outcome::Better),
            worse: count(comparison::Outcome::Worse),
            even: count(comparison::Outcome::Even),
            test: found.test.map(SignedRank::from),
        }
    }
}

/// One measure of two methods over models.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
// A flattened struct is written as a map, which is to be a plain object too.
#[tsify(missing_as_null, hashmap_as_object)]
pub struct Comparison {
    /// The measure.
    #[tsify(type = "Measure")]
    pub measure: &'static str,
    /// Its two figures.
    #[serde(flatten)]
    pub paired: Paired,
}

/// Compares own figures with others: a figure per model of both, NaN where it cannot be had.
///
/// # Errors
/// If there are not as many of both.
#[cfg(feature = "workshop")]
#[wasm_bindgen(js_name = compareFigures)]
pub fn compare_figures(
    own: &[f64],
    theirs: &[f64],
    higher_is_better: bool,
) -> Result<Ts<Paired>, JsError> {
    if own.len() != theirs.len() {
        return Err(JsError::new("figures are compared model by model"));
    }
    let better = if higher_is_better {
        Better::Higher
    } else {
        Better::Lower
    };
    let pairs = own.iter().zip(theirs);
    hand_over(&Paired::of(
        better,
        pairs.map(|(&own, &theirs)| (known(own), known(theirs))),
    ))
}

/// Compares own figures with others, measure by measure: both row after row, a row per model, in
/// the order of the list of measures, NaN where a figure cannot be had.
///
/// # Errors
/// If a row is incomplete, or there are not as many of both.
#[wasm_bindgen]
pub fn compare(own: &[f64], theirs: &[f64]) -> Result<Vec<Ts<Comparison>>, JsError> {
    let (own, theirs) = (rows_of(own)?, rows_of(theirs)?);
    if own.len() != theirs.len() {
        return Err(JsError::new("figures are compared model by model"));
    }
    let measures = Measure::ALL.into_iter().enumerate();
    let compared = measures.map(|(column, measure)| {
        let at = |row: &[f64]| row.get(column).copied().and_then(known);
        let pairs = own
            .iter()
            .zip(theirs)
            .map(|(own, theirs)| (at(own), at(theirs)));
        hand_over(&Comparison {
            measure: measure.name(),
            paired: Paired::of(measure.better(), pairs),
        })
    });
    compared.collect()
}
