//! Tells an observer what the transform sees. Nothing is copied unless somebody asked.

use super::accumulator::Accumulator;
use super::family::{Rung, Settled};
use super::persistence::Diagram;
use super::space::Space;
use super::trace::{Cell, Snapshot};
use crate::fit::trace::Event;
use crate::fit::{Cancelled, Candidate, Observer, Stage};
use crate::surface::{Surface, SurfaceType};

/// What is seen while climbing: one accumulator with its persistence diagram.
pub struct View<'a> {
    /// The family.
    pub kind: SurfaceType,
    /// The rung.
    pub rung: Rung,
    /// What earlier rungs settled.
    pub settled: &'a Settled,
    /// The votes by cell.
    pub accumulator: &'a Accumulator,
    /// The maxima.
    pub diagram: &'a Diagram,
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
    pub fn summit(&mut self, surface: &Surface, votes: usize) {
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
