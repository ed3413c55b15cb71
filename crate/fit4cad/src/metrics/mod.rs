//! How a submission is scored against the truth (paper, section "Quality indicators").
//!
//! [`matching`] pairs primitives, [`classification`] counts points, [`accuracy`] measures
//! distances to surfaces and [`coefficients`] compares implicit vectors. [`report`] puts them
//! together under one of two [`Protocol`]s, [`hidden`] adds what those measures do not show, and
//! [`summary`] describes a method over many reports. [`outcome`] and [`histogram`] say of single
//! points what the measures sum up; [`comparison`] sets figures against figures, [`bootstrap`] and
//! [`signed_rank`] say how certain that is, and [`agreement`] compares two answers with each other.
//! [`PUBLISHED`] has what the paper's methods reach.
//!
//! What the rest of the field reports stands beside these measures: [`segmentation`] scores by its
//! protocols, [`geometry`] compares surfaces, and [`field`] has both by name, with the strata that
//! primitives are told apart by; [`recognition`] has SHREC 2022's tables of single segments.

pub mod accuracy;
pub mod agreement;
pub mod bootstrap;
pub mod classification;
pub mod coefficients;
pub mod comparison;
pub mod field;
pub mod geometry;
pub mod hidden;
pub mod histogram;
pub mod matching;
mod measure;
pub mod outcome;
mod protocol;
mod published;
pub mod recognition;
pub mod report;
pub mod segmentation;
pub mod signed_rank;
pub mod summary;

pub use classification::Counts;
pub use field::{FieldReport, Figure, FigureGroup, FigureInfo, Figures, field_report};
pub use hidden::Hidden;
pub use measure::{Better, Group, Measure, MeasureInfo, Measures, Source, Term};
pub use protocol::{DIFFERENCES, Difference, Protocol};
pub use published::PUBLISHED;
pub use report::{PredictionRow, Report, ScoreError, TruthRow, evaluate, score};
pub use summary::{Distribution, MethodSummary, Score, summarise};

/// The mean of the values that are there; `None` if there are none.
fn mean(values: impl IntoIterator<Item = Option<f64>>) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0u32);
    for value in values.into_iter().flatten() {
        sum += value;
        count += 1;
    }
    (count > 0).then(|| sum / f64::from(count))
}
