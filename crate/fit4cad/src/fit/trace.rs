//! Intermediate results as plain data, for the lessons. Nothing is gathered unless asked for.

use crate::cloud::Point;
use crate::surface::{Surface, SurfaceType};

/// One intermediate result of a fit.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// Scale of the cloud as the fitters see it.
    Scale(super::Scale),
    /// A surface was accepted with these points.
    Accepted {
        /// The surface.
        surface: Surface,
        /// Indices of its points.
        support: Vec<u32>,
    },
    /// A slice of an accumulator: votes over two of its axes at the best place of the others.
    Accumulator {
        /// The family voted for.
        kind: SurfaceType,
        /// Which parameters are voted for.
        space: &'static str,
        /// Cells along the two axes.
        size: [usize; 2],
        /// Votes, row after row.
        votes: Vec<f32>,
        /// Range of the first axis.
        first: [f64; 2],
        /// Range of the second axis.
        second: [f64; 2],
    },
    /// The persistence pairs of an accumulator, most persistent first.
    Persistence {
        /// The family voted for.
        kind: SurfaceType,
        /// (birth, death) of each maximum, in votes.
        pairs: Vec<[f64; 2]>,
        /// Smallest persistence that counts.
        threshold: f64,
    },
    /// A peak of an accumulator and the surface it stands for.
    Peak {
        /// The surface at the middle of the cell.
        surface: Surface,
        /// Votes of the cell.
        votes: f64,
    },
    /// Surface variation of every point and the threshold above which a point is sharp.
    SurfaceVariation {
        /// σ of every point.
        values: Vec<f32>,
        /// The quantile η used.
        quantile: f64,
        /// The value at that quantile.
        threshold: f64,
    },
    /// The coarse partition: region of every point, `u32::MAX` for sharp ones.
    Regions(Vec<u32>),
    /// Slippage signature of a region.
    Slippage {
        /// Which region.
        region: u32,
        /// Eigenvalues of the 6 × 6 matrix, smallest first.
        eigenvalues: [f64; 6],
        /// Name of the ISO GPS invariance class.
        class: &'static str,
        /// Centre of the region.
        centre: Point,
    },
}
