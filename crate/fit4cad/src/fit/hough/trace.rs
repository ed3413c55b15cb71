//! What the transform saw, as plain data: accumulators, persistence pairs, peaks and the surfaces
//! they became. Nothing is copied unless somebody asked.

use super::family::{Rung, Settled};
use super::space::Space;
use super::vote::View;
use crate::fit::trace::Event;
use crate::fit::{Cancelled, Candidate, Observer, Stage};
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

/// Passes progress and, where wanted, intermediate results to an observer.
pub struct Recorder<'o> {
    observer: &'o mut dyn Observer,
    wants: bool,
}

impl<'o> Recorder<'o> {
    /// Asks the observer once whether it wants the trace.
    pub fn new(observer: &'o mut dyn Observer) -> Self {
        let wants = observer.wants_trace();
        Self { observer, wants }
    }

    /// Passes progress on.
    ///
    /// # Errors
    /// If the observer stops the fit.
    pub fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        self.observer.progress(stage, fraction)
    }

    /// Keeps an accumulator and its maxima.
    pub fn accumulator<S: Space>(&mut self, view: &View<'_>, share: f64, space: &S) {
        if !self.wants {
            return;
        }
        let cells: Vec<Cell> = view
            .accumulator
            .cells()
            .iter()
            .zip(view.accumulator.heights())
            .map(|(&cell, &height)| Cell {
                centre: space.centre(cell),
                height,
            })
            .collect();
        let highest = cells.iter().map(|cell| cell.height).fold(0.0, f64::max);
        let peaks = &view.diagram.peaks;
        self.observer.trace(Event::Hough(Snapshot {
            kind: view.kind,
            rung: view.rung,
            settled: *view.settled,
            cells,
            pairs: peaks.iter().map(|peak| [peak.birth, peak.death]).collect(),
            peaks: peaks.iter().map(|peak| peak.position as u32).collect(),
            threshold: share * highest,
        }));
    }

    /// Keeps the surface at the top of a ladder and how many voted for it.
    pub fn summit(&mut self, surface: &crate::surface::Surface, votes: usize) {
        if self.wants {
            self.observer.trace(Event::Peak {
                surface: *surface,
                votes: votes as f64,
            });
        }
    }

    /// Keeps a surface that was accepted.
    pub fn accepted(&mut self, candidate: &Candidate) {
        if self.wants {
            self.observer.trace(Event::accepted(candidate));
        }
    }
}
