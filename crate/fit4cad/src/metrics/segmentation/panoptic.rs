//! Panoptic quality and the F1 score at half overlap (Kirillov, He, Girshick, Rother and Dollár 2019).

use super::over;
use super::overlaps::Overlaps;

/// A pair is a hit where it coincides in more than this.
pub const HIT: f64 = 0.5;

/// **Definition.** A true and a predicted primitive with IoU > 0.5 are a hit, TP. F1@0.5 is
/// 2 TP / (K + K′), for K predicted and K′ true primitives.
///
/// **Source.** The paper "Panoptic Segmentation", its recognition quality; types are not looked at.
///
/// **Labels.** Sets. The matching is unique where no point has two labels; where lists share points, a
/// primitive could hit two, and counts once on its own side.
///
/// **Trap.** None: the strict one. Missed primitives and invented ones cost the same; how well a hit
/// coincides does not show.
///
/// `None` where there is no primitive on either side. O(pairs).
pub fn f1(overlaps: &Overlaps) -> Option<f64> {
    let (hits, _) = hits(overlaps);
    let all = overlaps.truth.len() + overlaps.predicted.len();
    over(2.0 * hits as f64, all)
}

/// **Definition.** PQ is the sum of IoU over the hits, divided by (K + K′) / 2: F1@0.5 times the mean
/// IoU of the hits.
///
/// **Source, labels and trap** as for [`f1`].
pub fn quality(overlaps: &Overlaps) -> Option<f64> {
    let (_, sum) = hits(overlaps);
    let all = overlaps.truth.len() + overlaps.predicted.len();
    over(2.0 * sum, all)
}

/// How many pairs are hits, and the sum of their IoU. One to one: of several hits of a primitive,
/// which only overlapping lists allow, the better ones count.
fn hits(overlaps: &Overlaps) -> (usize, f64) {
    let with_iou = overlaps
        .pairs
        .iter()
        .map(|pair| (overlaps.iou(*pair), pair));
    let mut hits: Vec<_> = with_iou.filter(|&(iou, _)| iou > HIT).collect();
    hits.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let mut is_free = [
        vec![true; overlaps.truth.len()],
        vec![true; overlaps.predicted.len()],
    ];
    let (mut count, mut sum) = (0, 0.0);
    for (iou, pair) in hits {
        let [truth, predicted] = &mut is_free;
        if let (Some(truth), Some(predicted)) =
            (truth.get_mut(pair.truth), predicted.get_mut(pair.predicted))
            && *truth
            && *predicted
        {
            (*truth, *predicted) = (false, false);
            count += 1;
            sum += iou;
        }
    }
    (count, sum)
}
