//! Intermediate results as plain data, for the lessons. Nothing is gathered unless asked for.

use super::Candidate;
use crate::cloud::Point;
use crate::surface::Surface;

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
    /// An accumulator of the Hough transform, its persistence pairs and peaks.
    Hough(super::hough::trace::Snapshot),
    /// A peak of an accumulator and the surface it stands for.
    Peak {
        /// The consensus of its voters.
        surface: Surface,
        /// How many they are.
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

impl Event {
    /// That a candidate was accepted.
    pub fn accepted(candidate: &Candidate) -> Self {
        Self::Accepted {
            surface: candidate.surface,
            support: candidate.support.clone(),
        }
    }
}
