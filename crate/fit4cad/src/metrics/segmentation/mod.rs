//! How the rest of the field scores a segmentation, beside the benchmark's own measures.
//!
//! A method's score hangs on whose script is run: the same answers of one method are worth 0.62, 0.50
//! or 0.67. Every protocol is a file of its own that says what it defines, where that is read off
//! (the evaluation code in public repositories, not the papers: where the two differ, people's
//! numbers come from the code), and what one has to know before comparing. All start from the same
//! table of [`overlaps`]: primitives are sets, and a point of several primitives is a member of each,
//! where the original scripts read one label a point; on files with one label a point the two
//! readings are the same. Those that match one to one share one [`assignment`].
//!
//! Figures are `None` where the truth leaves nothing to measure, and 0 where the prediction is to
//! blame, so that predicting nothing never pays.

pub mod assignment;
pub mod fit4cad;
pub mod hpnet;
pub mod nvdnet;
pub mod overlaps;
pub mod panoptic;
pub mod parsenet;
pub mod spfn;
#[cfg(test)]
mod tests;

pub use overlaps::{Overlap, Overlaps};

/// A sum over a number of things; `None` for none.
fn over(sum: f64, count: usize) -> Option<f64> {
    (count > 0).then(|| sum / count as f64)
}
