//! Performance measures of the point classification (paper, section of that name).

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

/// The six measures of one true primitive; `None` where a measure is 0/0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Classification {
    /// DSC = 2 TP / (2 TP + FP + FN), Sørensen-Dice index.
    pub dsc: Option<f64>,
    /// PPV = TP / (TP + FP), positive predictive value.
    pub ppv: Option<f64>,
    /// TPR = TP / (TP + FN), true positive rate.
    pub tpr: Option<f64>,
    /// TNR = TN / (TN + FP), true negative rate.
    pub tnr: Option<f64>,
    /// NPV = TN / (TN + FN), negative predictive value.
    pub npv: Option<f64>,
    /// ACC = (TP + TN) / (TP + TN + FP + FN), accuracy.
    pub acc: Option<f64>,
}

impl Classification {
    /// The measures of the counts.
    pub fn of(counts: Counts) -> Self {
        let Counts {
            true_positives: tp,
            false_positives: fp,
            false_negatives: fn_,
            true_negatives: tn,
        } = counts;
        Self {
            dsc: ratio(2 * tp, 2 * tp + fp + fn_),
            ppv: ratio(tp, tp + fp),
            tpr: ratio(tp, tp + fn_),
            tnr: ratio(tn, tn + fp),
            npv: ratio(tn, tn + fn_),
            acc: ratio(tp + tn, tp + tn + fp + fn_),
        }
    }

    /// PPV under the heading of TPR, TNR under that of NPV, and the other way round.
    pub(super) fn swapped(self) -> Self {
        Self {
            ppv: self.tpr,
            tpr: self.ppv,
            tnr: self.npv,
            npv: self.tnr,
            ..self
        }
    }

    /// What enters the mean where a measure is 0/0. If the prediction is to blame it is 0, so that
    /// predicting nothing (PPV) or everything (NPV) never pays; if the truth leaves nothing to
    /// measure (a primitive that is the whole universe has no negatives) it is left out.
    pub(super) fn for_mean(self) -> Self {
        let or_zero = |value: Option<f64>| Some(value.unwrap_or(0.0));
        // TNR is 0/0 exactly where the truth has no negatives.
        let has_negatives = self.tnr.is_some();
        Self {
            dsc: or_zero(self.dsc),
            ppv: or_zero(self.ppv),
            tpr: or_zero(self.tpr),
            npv: if has_negatives {
                or_zero(self.npv)
            } else {
                self.npv
            },
            ..self
        }
    }
}

fn ratio(part: usize, whole: usize) -> Option<f64> {
    (whole > 0).then(|| part as f64 / whole as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let measures = Classification::of(counts);
        assert_eq!(measures.dsc, Some(30.0 / 45.0));
        assert_eq!(measures.ppv, Some(15.0 / 25.0));
        assert_eq!(measures.tpr, Some(15.0 / 20.0));
        assert_eq!(measures.tnr, Some(70.0 / 80.0));
        assert_eq!(measures.npv, Some(70.0 / 75.0));
        assert_eq!(measures.acc, Some(85.0 / 100.0));
    }

    #[test]
    fn exchanging_prediction_and_truth_exchanges_ppv_with_tpr_and_tnr_with_npv() {
        let straight = Classification::of(Counts::of_sets(20, 25, 15, 100));
        let swapped = Classification::of(Counts::of_sets(25, 20, 15, 100));
        assert_eq!(straight.swapped(), swapped);
        assert_eq!((straight.ppv, straight.tpr), (swapped.tpr, swapped.ppv));
        assert_eq!((straight.tnr, straight.npv), (swapped.npv, swapped.tnr));
        assert_eq!((straight.dsc, straight.acc), (swapped.dsc, swapped.acc));
    }

    #[test]
    fn a_primitive_without_match_has_no_ppv_and_it_enters_the_mean_as_zero() {
        let measures = Classification::of(Counts::of_sets(20, 0, 0, 100));
        assert_eq!(measures.dsc, Some(0.0));
        assert_eq!(measures.tpr, Some(0.0));
        assert_eq!(measures.ppv, None);
        assert_eq!(measures.tnr, Some(1.0));
        assert_eq!(measures.npv, Some(0.8));
        assert_eq!(measures.for_mean().ppv, Some(0.0));
    }

    #[test]
    fn predicting_everything_has_no_npv_and_it_enters_the_mean_as_zero() {
        let measures = Classification::of(Counts::of_sets(20, 100, 20, 100));
        assert_eq!(measures.tnr, Some(0.0));
        assert_eq!(measures.npv, None);
        assert_eq!(measures.for_mean().npv, Some(0.0));
    }

    #[test]
    fn a_primitive_that_is_the_whole_cloud_leaves_no_negatives_to_measure() {
        let measures = Classification::of(Counts::of_sets(100, 100, 100, 100));
        assert_eq!((measures.tnr, measures.npv), (None, None));
        assert_eq!(measures.for_mean(), measures);
        assert_eq!(measures.acc, Some(1.0));
    }
}
