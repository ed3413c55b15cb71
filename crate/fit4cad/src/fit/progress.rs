//! What a fitter tells while it works, and how it is stopped.

use thiserror::Error;

use super::trace::Event;

/// The stages of a fit, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Neighbours, scale and noise level.
    Prepare,
    /// Finding surfaces: what the methods differ in.
    Find,
    /// Removing surfaces that others explain.
    Prune,
    /// Giving every point the labels of the surfaces it lies on.
    Label,
    /// Splitting each surface's points into connected patches.
    Patches,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 5] = [
        Self::Prepare,
        Self::Find,
        Self::Prune,
        Self::Label,
        Self::Patches,
    ];

    /// A word for progress bars and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Prepare => "prepare",
            Self::Find => "find",
            Self::Prune => "prune",
            Self::Label => "label",
            Self::Patches => "patches",
        }
    }

    /// What share of a fit's time it takes, roughly: finding surfaces is nearly all of it. All
    /// shares make 1.
    pub const fn share(self) -> f64 {
        match self {
            Self::Prepare => 0.1,
            Self::Find => 0.75,
            Self::Prune | Self::Label | Self::Patches => 0.05,
        }
    }
}

/// The fit was stopped by its observer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the fit was cancelled")]
pub struct Cancelled;

/// Follows a fit. Every method has a default that wants nothing, so `&mut ()` is an observer.
pub trait Observer {
    /// Called now and then with the stage and how much of it is done, from 0 to 1, never less than before.
    ///
    /// # Errors
    /// [`Cancelled`] ends the fit.
    fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        let _ = (stage, fraction);
        Ok(())
    }

    /// Whether [`Observer::trace`] wants to be called; asked before anything is gathered for it, and to
    /// be answered the same way all through a fit.
    fn wants_trace(&self) -> bool {
        false
    }

    /// Called with each intermediate result, if wanted.
    fn trace(&mut self, event: Event) {
        let _ = event;
    }
}

impl Observer for () {}
