//! SPFN's mean IoU (Li, Sung, Dubrovina, Yi and Guibas 2019).

use super::assignment::most_iou;
use super::over;
use super::overlaps::{Overlap, Overlaps};

/// Share of the cloud's points below which a prediction is removed.
pub const SMALL: f64 = 0.005;

/// **Definition.** True and predicted primitives are matched one to one so that the sum of their IoU
/// is largest; the score is the mean of IoU over *all* true primitives, 0 for those without a partner.
///
/// **Source.** `lingxiaoli94/SPFN`, `spfn/lib/evaluation.py`: `hungarian_matching`,
/// `compute_miou_loss`, `reduce_mean_masked_instance`.
///
/// **Labels.** Sets. The original reads one label a point.
///
/// **Trap.** Shapes of more than 24 primitives are skipped by the original, which has room for no
/// more; they are scored here. Predictions without a partner cost nothing.
///
/// `None` without true primitives, or where the lists are too entangled to be matched (see
/// [`most_iou`]).
pub fn score(overlaps: &Overlaps) -> Option<f64> {
    mean_iou(overlaps, &|_| true)
}

/// The same once predictions of fewer than 0.5 % of the cloud's points are removed: what SPFN's code
/// does to the answers of networks (`nn_filter_W`, `W_null_threshold`).
///
/// **Trap.** The truth itself does not score 1 where the part has faces that small.
pub fn score_without_small(overlaps: &Overlaps) -> Option<f64> {
    let least = SMALL * overlaps.points as f64;
    mean_iou(overlaps, &|pair| {
        let size = overlaps.predicted.get(pair.predicted);
        size.is_some_and(|&size| size as f64 >= least)
    })
}

fn mean_iou(overlaps: &Overlaps, keep: &dyn Fn(Overlap) -> bool) -> Option<f64> {
    let partners = most_iou(overlaps, keep)?;
    let sum = partners.iter().flatten().map(|partner| partner.iou).sum();
    over(sum, overlaps.truth.len())
}
