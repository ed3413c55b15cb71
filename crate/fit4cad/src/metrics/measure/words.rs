//! What is said of a measure.

use super::Term;

/// Which values are good.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Better {
    /// The higher the better.
    Higher,
    /// The lower the better.
    Lower,
}

/// What a measure looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Which points a true primitive and its match have: a value for each true primitive.
    Classification,
    /// How the surface of a predicted primitive fits: a value for each predicted primitive.
    Accuracy,
}

/// What is said of a measure, beside what it is computed from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Words {
    /// Its name in full.
    pub(super) name: &'static str,
    /// What it tells, in a sentence or two.
    pub(super) meaning: &'static str,
    /// Which values are good.
    pub(super) better: Better,
    /// How it is written in formulas; its key where absent.
    pub(super) symbol: Option<fn() -> Term>,
    /// The right side of its formula; that of the ratio where absent.
    pub(super) formula: Option<fn() -> Term>,
    /// What is to be known about its range.
    pub(super) remark: &'static str,
    /// Whether its values lie orders of magnitude apart.
    pub(super) logarithmic: bool,
    /// Section of the paper.
    pub(super) section: &'static str,
    /// What the published protocol changes, where it does not follow from the ratio.
    pub(super) published: &'static str,
}
