//! Figures against figures: differences, wins and losses, means over the same models.

use super::signed_rank::SignedRank;
use super::{Better, mean};

/// Published figures are rounded to six digits: a difference of half of the last is none. A millionth
/// part of that is room for the rounding of the subtraction itself.
const EVEN: f64 = 5e-7 * (1.0 + 2e-6);

/// Which of two figures is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The own one.
    Better,
    /// The other one.
    Worse,
    /// Neither, as far as six digits tell.
    Even,
}

/// An own figure against another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// Own minus theirs.
    pub by: f64,
    /// Which of them is better.
    pub outcome: Outcome,
}

impl Difference {
    /// Compares two figures of which one kind is `better`; `None` where either is missing.
    pub fn of(better: Better, own: Option<f64>, theirs: Option<f64>) -> Option<Self> {
        let by = own? - theirs?;
        let outcome = if by.abs() <= EVEN {
            Outcome::Even
        } else if (by > 0.0) == (better == Better::Higher) {
            Outcome::Better
        } else {
            Outcome::Worse
        };
        Some(Self { by, outcome })
    }
}

/// One figure of two methods over models.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The difference on each model; `None` where either figure is missing.
    pub differences: Vec<Option<Difference>>,
    /// Own mean over the models where both figures are there, so that like is compared with like;
    /// `None` where there is no such model.
    pub own: Option<f64>,
    /// Their mean over the same models.
    pub theirs: Option<f64>,
    /// The difference of the two means.
    pub mean: Option<Difference>,
    /// Wilcoxon's test of the differences, those that six digits do not tell left out; `None` where
    /// none is left.
    pub test: Option<SignedRank>,
}

impl Comparison {
    /// Compares pairs of own and other figures, a pair per model. O(models).
    ///
    /// ```
    /// use fit4cad::metrics::{Better, comparison::{Comparison, Outcome}};
    /// let pairs = [(Some(0.5), Some(0.25)), (Some(1.0), None), (Some(0.25), Some(0.75))];
    /// let comparison = Comparison::of(Better::Higher, &pairs);
    /// assert_eq!((comparison.own, comparison.theirs), (Some(0.375), Some(0.5)));
    /// assert_eq!(comparison.count(Outcome::Better), 1);
    /// ```
    pub fn of(better: Better, pairs: &[(Option<f64>, Option<f64>)]) -> Self {
        let both = || pairs.iter().filter_map(|&(own, theirs)| own.zip(theirs));
        let own = mean(both().map(|(own, _)| Some(own)));
        let theirs = mean(both().map(|(_, theirs)| Some(theirs)));
        let differences = pairs.iter();
        let differences = differences.map(|&(own, theirs)| Difference::of(better, own, theirs));
        let differences: Vec<Option<Difference>> = differences.collect();
        let told = differences.iter().flatten();
        let told = told.filter(|difference| difference.outcome != Outcome::Even);
        Self {
            own,
            theirs,
            mean: Difference::of(better, own, theirs),
            test: SignedRank::of(told.map(|difference| difference.by)),
            differences,
        }
    }

    /// On how many models it came out so.
    pub fn count(&self, outcome: Outcome) -> usize {
        let known = self.differences.iter().flatten();
        known
            .filter(|difference| difference.outcome == outcome)
            .count()
    }
}

#[cfg(test)]
mod tests {
    use super::super::Measure;
    use super::*;

    fn outcome(measure: Measure, own: f64, theirs: f64) -> Outcome {
        Difference::of(measure.better(), Some(own), Some(theirs))
            .unwrap()
            .outcome
    }

    #[test]
    fn what_is_good_decides_who_wins() {
        assert_eq!(outcome(Measure::Dsc, 0.9, 0.8), Outcome::Better);
        assert_eq!(outcome(Measure::Mfe, 0.9, 0.8), Outcome::Worse);
        assert_eq!(outcome(Measure::D1, 0.1, 0.2), Outcome::Better);
    }

    #[test]
    fn rounding_decides_nothing() {
        assert_eq!(outcome(Measure::Mfe, 0.800_000_4, 0.8), Outcome::Even);
        assert_eq!(outcome(Measure::Acc, 0.800_000_5, 0.8), Outcome::Even);
        assert_eq!(outcome(Measure::Dsc, 0.800_000_6, 0.8), Outcome::Better);
    }

    #[test]
    fn a_missing_figure_is_neither_won_nor_lost() {
        assert_eq!(Difference::of(Better::Higher, None, Some(0.8)), None);
        let some = Some;
        let pairs = [
            (some(0.9), some(0.8)),
            (some(0.7), some(0.8)),
            (some(0.8), some(0.8)),
            (None, some(0.1)),
            (some(0.2), None),
        ];
        let comparison = Comparison::of(Better::Higher, &pairs);
        let counts = [Outcome::Better, Outcome::Worse, Outcome::Even];
        assert_eq!(counts.map(|outcome| comparison.count(outcome)), [1, 1, 1]);
        assert_eq!(comparison.differences[3], None);
        // One difference either way: nothing could be less certain.
        let test = comparison.test.unwrap();
        assert_eq!((test.pairs, test.probability), (2, 1.0));
    }

    #[test]
    fn no_common_model_no_mean() {
        let comparison = Comparison::of(Better::Higher, &[(None, Some(1.0)), (Some(1.0), None)]);
        assert_eq!((comparison.own, comparison.theirs), (None, None));
        assert_eq!(comparison.mean, None);
    }
}
