//! Methods that make a submission from a bare cloud.
//!
//! A method differs from another only in how it **finds** surfaces. Everything around that is
//! shared: a [`Search`] holds the cloud with its neighbours, scale and what is explained so far;
//! a method hands it surfaces that might be there ([`Search::grow`] polishes one by least squares
//! and grows its patch into a [`Candidate`], [`Search::best`] lets candidates compete,
//! [`Search::accept`] keeps the winner); then [`stages`] prune, label and split into patches.
//!
//! ```text
//! cloud → Search → hough::find or growing::find → prune → label → patches → Segmentation
//!                  local::hypotheses → grow → best → accept
//! ```

pub mod hough;
pub mod least_squares;
pub mod local;
pub mod parameters;
pub mod progress;
pub mod scale;
pub mod search;
pub mod trace;

pub use parameters::Parameters;
pub use progress::{Cancelled, Observer, Stage};
pub use scale::Scale;
pub use search::Search;

use crate::surface::Surface;

/// How surfaces are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// HT: votes in parameter space (paper, section "HT").
    Hough,
    /// PG: primitive growing from neighbourhoods (paper, section "PG").
    Growing,
}

/// A surface that may be one of the cloud's primitives, with the points that speak for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The surface, fitted to its support.
    pub surface: Surface,
    /// Indices of the points on it, connected, ascending.
    pub support: Vec<u32>,
    /// Root mean square distance of the support to the surface, in the units of the cloud.
    pub error: f64,
}
