//! The measures by name, what each is computed from, and a value for each.

mod declared;
mod info;
mod term;
mod words;

use std::fmt;
use std::ops::{Index, IndexMut};

pub use declared::Measure;
pub use info::MeasureInfo;
pub use term::Term;
pub use words::{Better, Group};

use super::Protocol;
use super::accuracy::FitAccuracy;
use super::classification::{Count, Counts};

/// What a measure is computed from.
#[derive(Debug, Clone, Copy)]
pub enum Source {
    /// The points counted for a true primitive against its match.
    Points(Ratio),
    /// The distances of a predicted primitive's points to its surface.
    Distances(fn(FitAccuracy) -> f64),
    /// The implicit coefficients of a predicted primitive and of its true one.
    Coefficients,
}

/// A count, so many times.
pub type Times = (usize, Count);

/// A measure of the point classification: a ratio of sums of counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ratio {
    /// The sum above the line.
    pub over: &'static [Times],
    /// The sum below the line.
    pub under: &'static [Times],
    /// What enters the mean where it is 0/0.
    pub undefined: Undefined,
    /// What the authors' scripts print in its place.
    pub published: Published,
}

/// What enters the mean where a measure is 0/0. If the prediction is to blame it is 0, so that
/// predicting nothing (PPV) or everything (NPV) never pays; if the truth leaves nothing to measure
/// (a primitive that is the whole universe has no negatives) it is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Undefined {
    /// 0.
    Zero,
    /// 0 where the truth has negatives, else nothing.
    ZeroAmongNegatives,
    /// Nothing.
    LeftOut,
}

/// What stands under the heading of a measure by [`Protocol::Published`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Published {
    /// The measure itself, of all points.
    Whole,
    /// The measure itself, of the points that some true primitive lists.
    Labelled,
    /// Another measure, of the points that some true primitive lists.
    Other(Measure),
}

impl Ratio {
    /// Its value; `None` where it is 0/0.
    ///
    /// ```
    /// use fit4cad::metrics::{Counts, Measure, Source};
    /// let counts = Counts::of_sets(20, 25, 15, 100);
    /// let Source::Points(dice) = Measure::Dsc.source() else { unreachable!() };
    /// assert_eq!(dice.of(counts), Some(2.0 * 15.0 / 45.0));
    /// ```
    pub fn of(&self, counts: Counts) -> Option<f64> {
        let sum = |parts: &[Times]| -> usize {
            let parts = parts.iter();
            parts.map(|&(times, count)| times * count.of(counts)).sum()
        };
        let (over, under) = (sum(self.over), sum(self.under));
        (under > 0).then(|| over as f64 / under as f64)
    }

    /// What enters the mean: its value or what stands for it.
    pub(in crate::metrics) fn for_mean(&self, counts: Counts) -> Option<f64> {
        let has_negatives = counts.false_positives + counts.true_negatives > 0;
        self.of(counts).or(match self.undefined {
            Undefined::Zero => Some(0.0),
            Undefined::ZeroAmongNegatives => has_negatives.then_some(0.0),
            Undefined::LeftOut => None,
        })
    }
}

impl Measure {
    /// What it looks at.
    pub const fn group(self) -> Group {
        match self.source() {
            Source::Points(_) => Group::Classification,
            Source::Distances(_) | Source::Coefficients => Group::Accuracy,
        }
    }

    /// Which values are good.
    pub const fn better(self) -> Better {
        self.words().better
    }

    /// The ratio whose value stands under its heading by a protocol; `None` for a measure of
    /// surfaces.
    pub(super) const fn ratio(self, protocol: Protocol) -> Option<Ratio> {
        let Source::Points(ratio) = self.source() else {
            return None;
        };
        match (protocol, ratio.published) {
            (Protocol::Published, Published::Other(other)) => other.ratio(Protocol::Definition),
            _ => Some(ratio),
        }
    }
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A value for each measure; `None` where it cannot be had.
///
/// ```
/// use fit4cad::metrics::{Measure, Measures};
/// let mut measures = Measures::default();
/// measures[Measure::Dsc] = Some(0.5);
/// assert_eq!(measures.iter().next(), Some((Measure::Dsc, Some(0.5))));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measures([Option<f64>; Measure::COUNT]);

impl Measures {
    /// The value that a function gives each measure.
    pub fn from_fn(value: impl FnMut(Measure) -> Option<f64>) -> Self {
        Self(Measure::ALL.map(value))
    }

    /// The value of one measure.
    pub const fn get(&self, measure: Measure) -> Option<f64> {
        self.0[measure as usize]
    }

    /// Each measure with its value, in the order of [`Measure::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Measure, Option<f64>)> {
        Measure::ALL.into_iter().zip(self.0)
    }
}

impl Index<Measure> for Measures {
    type Output = Option<f64>;

    fn index(&self, measure: Measure) -> &Option<f64> {
        &self.0[measure as usize]
    }
}

impl IndexMut<Measure> for Measures {
    fn index_mut(&mut self, measure: Measure) -> &mut Option<f64> {
        &mut self.0[measure as usize]
    }
}
