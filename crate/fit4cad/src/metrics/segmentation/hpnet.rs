//! HPNet's segment IoU (Yan, Yang, Ma, Huang, Vouga and Huang 2021).

use super::assignment::most_iou;
use super::over;
use super::overlaps::Overlaps;

/// True primitives of no more points are background.
pub const BACKGROUND: usize = 100;

/// **Definition.** True primitives of at most 100 points become background; the others are matched one
/// to one with the predictions so that the sum of IoU is largest, as many pairs as the shorter side
/// has primitives, and the score is the mean of IoU over these pairs.
///
/// **Source.** `SimingYan/HPNet`, `utils/loss_utils.py`: `hungarian_matching`, `compute_miou`; the
/// background in its data loader.
///
/// **Labels.** Sets. The original reads one label a point.
///
/// **Trap.** As with ParseNet, true primitives without a partner do not count where there are fewer
/// predictions than true primitives: one face found perfectly and nothing else scores 1. Unlike there,
/// every prediction is paired, and what overlaps with nothing that is left counts as 0.
///
/// `None` where no true primitive has more than 100 points, or where the lists are too entangled to
/// be matched (see [`most_iou`]); 0 without predictions.
pub fn score(overlaps: &Overlaps) -> Option<f64> {
    let is_foreground = |place: usize| {
        let size = overlaps.truth.get(place);
        size.is_some_and(|&size| size > BACKGROUND)
    };
    let truth = (0..overlaps.truth.len()).filter(|&place| is_foreground(place));
    let truth = truth.count();
    if truth == 0 {
        return None;
    }
    let partners = most_iou(overlaps, &|pair| is_foreground(pair.truth))?;
    let sum = partners.iter().flatten().map(|partner| partner.iou).sum();
    over(sum, truth.min(overlaps.predicted.len())).or(Some(0.0))
}
