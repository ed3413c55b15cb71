//! What the transform saw, as plain data: accumulators, persistence pairs and peaks.

use super::family::{Rung, Settled};
use crate::surface::SurfaceType;

/// One accumulator as it stood when its peaks were picked.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// The family voted for.
    pub kind: SurfaceType,
    /// The rung of the family's ladder.
    pub rung: Rung,
    /// What the rungs below settled.
    pub settled: Settled,
    /// Every cell with a vote: the coordinates of its centre (a unit direction on the direction
    /// rung) and its height, in order of the cells.
    pub cells: Vec<Cell>,
    /// (birth, death) of every maximum in votes, most persistent first.
    pub pairs: Vec<[f64; 2]>,
    /// Position of each maximum in `cells`, in the order of `pairs`.
    pub peaks: Vec<u32>,
    /// Smallest persistence that counted.
    pub threshold: f64,
}

/// A cell that holds votes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Coordinates of its centre; those beyond the rung's number are 0.
    pub centre: [f64; 3],
    /// Its height in votes.
    pub height: f64,
}
