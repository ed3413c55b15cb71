//! How a submission is scored against the truth (paper, section "Quality indicators").
//!
//! [`matching`] pairs primitives, [`classification`] counts points, [`accuracy`] measures
//! distances to surfaces and [`coefficients`] compares implicit vectors. [`report`] puts them
//! together under one of two [`Protocol`]s, [`hidden`] adds what those measures do not show, and
//! [`summary`] describes a figure over many reports. [`agreement`] compares two answers with each
//! other.

pub mod accuracy;
pub mod agreement;
pub mod classification;
pub mod coefficients;
pub mod hidden;
pub mod matching;
mod measure;
mod protocol;
pub mod report;
pub mod summary;

pub use classification::{Classification, Counts};
pub use hidden::Hidden;
pub use measure::{Measure, Measures};
pub use protocol::Protocol;
pub use report::{PredictionRow, Report, ScoreError, TruthRow, evaluate, score};
pub use summary::Distribution;

/// The mean of the values that are there; `None` if there are none.
fn mean(values: impl IntoIterator<Item = Option<f64>>) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0u32);
    for value in values.into_iter().flatten() {
        sum += value;
        count += 1;
    }
    (count > 0).then(|| sum / f64::from(count))
}
