//! What the performance measures of the point classification (paper, section of that name) count.

/// Points counted for one true primitive 𝒫_B against its matched prediction 𝒫_S.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// TP: points shared by 𝒫_B and 𝒫_S.
    pub true_positives: usize,
    /// FP: points of 𝒫_S that do not belong to 𝒫_B.
    pub false_positives: usize,
    /// FN: points of 𝒫_B that do not belong to 𝒫_S.
    pub false_negatives: usize,
    /// TN: points of the universe in neither.
    pub true_negatives: usize,
}

impl Counts {
    /// The counts of two sets within a universe that holds both.
    pub fn of_sets(truth: usize, predicted: usize, shared: usize, universe: usize) -> Self {
        let false_positives = predicted.saturating_sub(shared);
        Self {
            true_positives: shared,
            false_positives,
            false_negatives: truth.saturating_sub(shared),
            true_negatives: universe.saturating_sub(truth.saturating_add(false_positives)),
        }
    }
}

/// One of the counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Count {
    /// TP.
    TruePositives,
    /// FP.
    FalsePositives,
    /// FN.
    FalseNegatives,
    /// TN.
    TrueNegatives,
}

impl Count {
    /// The paper's abbreviation.
    pub const fn name(self) -> &'static str {
        match self {
            Self::TruePositives => "TP",
            Self::FalsePositives => "FP",
            Self::FalseNegatives => "FN",
            Self::TrueNegatives => "TN",
        }
    }

    /// How many there are.
    pub(super) const fn of(self, counts: Counts) -> usize {
        match self {
            Self::TruePositives => counts.true_positives,
            Self::FalsePositives => counts.false_positives,
            Self::FalseNegatives => counts.false_negatives,
            Self::TrueNegatives => counts.true_negatives,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Measure, Measures, Protocol};
    use super::*;

    fn by_definition(counts: Counts) -> Measures {
        Measures::from_fn(|measure| measure.ratio(Protocol::Definition)?.of(counts))
    }

    fn for_mean(counts: Counts) -> Measures {
        Measures::from_fn(|measure| measure.ratio(Protocol::Definition)?.for_mean(counts))
    }

    #[test]
    fn the_measures_follow_from_the_counts_by_hand() {
        // 100 points, truth 20, prediction 25, shared 15.
        let counts = Counts::of_sets(20, 25, 15, 100);
        assert_eq!(
            counts,
            Counts {
                true_positives: 15,
                false_positives: 10,
                false_negatives: 5,
                true_negatives: 70
            }
        );
        let measures = by_definition(counts);
        assert_eq!(measures[Measure::Dsc], Some(30.0 / 45.0));
        assert_eq!(measures[Measure::Ppv], Some(15.0 / 25.0));
        assert_eq!(measures[Measure::Tpr], Some(15.0 / 20.0));
        assert_eq!(measures[Measure::Tnr], Some(70.0 / 80.0));
        assert_eq!(measures[Measure::Npv], Some(70.0 / 75.0));
        assert_eq!(measures[Measure::Acc], Some(85.0 / 100.0));
        assert_eq!(measures[Measure::Mfe], None);
    }

    #[test]
    fn exchanging_prediction_and_truth_exchanges_what_is_published_under_another_heading() {
        let straight = Counts::of_sets(20, 25, 15, 100);
        let swapped = by_definition(Counts::of_sets(25, 20, 15, 100));
        for measure in Measure::ALL {
            let published = measure.ratio(Protocol::Published);
            let value = published.and_then(|ratio| ratio.of(straight));
            assert_eq!(value, swapped[measure], "{measure}");
        }
    }

    #[test]
    fn a_primitive_without_match_has_no_ppv_and_it_enters_the_mean_as_zero() {
        let counts = Counts::of_sets(20, 0, 0, 100);
        let measures = by_definition(counts);
        assert_eq!(measures[Measure::Dsc], Some(0.0));
        assert_eq!(measures[Measure::Tpr], Some(0.0));
        assert_eq!(measures[Measure::Ppv], None);
        assert_eq!(measures[Measure::Tnr], Some(1.0));
        assert_eq!(measures[Measure::Npv], Some(0.8));
        assert_eq!(for_mean(counts)[Measure::Ppv], Some(0.0));
    }

    #[test]
    fn predicting_everything_has_no_npv_and_it_enters_the_mean_as_zero() {
        let counts = Counts::of_sets(20, 100, 20, 100);
        let measures = by_definition(counts);
        assert_eq!(measures[Measure::Tnr], Some(0.0));
        assert_eq!(measures[Measure::Npv], None);
        assert_eq!(for_mean(counts)[Measure::Npv], Some(0.0));
    }

    #[test]
    fn a_primitive_that_is_the_whole_cloud_leaves_no_negatives_to_measure() {
        let counts = Counts::of_sets(100, 100, 100, 100);
        let measures = by_definition(counts);
        assert_eq!(
            (measures[Measure::Tnr], measures[Measure::Npv]),
            (None, None)
        );
        assert_eq!(for_mean(counts), measures);
        assert_eq!(measures[Measure::Acc], Some(1.0));
    }
}
