//! ParseNet's segment IoU (Sharma, Liu, Maji, Kalogerakis, Chaudhuri and Měch 2020).

use super::assignment::most_iou;
use super::over;
use super::overlaps::Overlaps;

/// True primitives of fewer points are not looked at.
pub const LEAST: usize = 100;
/// How many primitives of either side exist: the columns of the original's tables.
pub const MOST: usize = 50;

/// **Definition.** The first 50 primitives of either side are matched one to one so that the sum of
/// 1 − IoU is smallest, as many pairs as the shorter side has primitives; the score is the mean of IoU
/// over the pairs whose sides both have points and whose true primitive has at least 100.
///
/// **Source.** `Hippogriff/parsenet-codebase`, `src/segment_utils.py`: `SIOU_matched_segments`,
/// `mean_IOU_primitive_segment`, `to_one_hot` (`maxx=50`).
///
/// **Labels.** Sets. The original reads one label a point.
///
/// **Trap.** True primitives without a partner do not count: one face found perfectly and nothing else
/// scores 1. Pairs that share no point do count, as 0, and among them a solver may choose as it
/// likes; here predictions that overlap with nothing that is left go to the true primitives that are
/// left in the order of the file, which is what the usual solvers do. So the figure can hang on the
/// order of the primitives, and those after the fiftieth do not enter it at all. The paper's "type
/// IoU" is an accuracy over the same pairs.
///
/// `None` where none of the first 50 true primitives has 100 points, or where the lists are too
/// entangled to be matched (see [`most_iou`]); 0 where no pair is looked at.
pub fn score(overlaps: &Overlaps) -> Option<f64> {
    let is_large = |&size: &usize| size >= LEAST;
    if !overlaps.truth.iter().take(MOST).any(is_large) {
        return None;
    }
    let partners = most_iou(overlaps, &|pair| pair.truth < MOST && pair.predicted < MOST)?;
    // What is left of either side: pairs without overlap.
    let matched = partners.iter().flatten().count();
    let there = |sizes: &[usize]| sizes.iter().take(MOST).filter(|&&size| size > 0).count();
    let pairs = there(&overlaps.truth).min(there(&overlaps.predicted));
    let mut without_overlap = pairs.saturating_sub(matched);
    let (mut sum, mut count) = (0.0, 0);
    for (size, partner) in overlaps.truth.iter().zip(&partners).take(MOST) {
        let iou = match partner {
            Some(partner) => partner.iou,
            None if without_overlap > 0 && *size > 0 => {
                without_overlap -= 1;
                0.0
            }
            None => continue,
        };
        if is_large(size) {
            sum += iou;
            count += 1;
        }
    }
    over(sum, count).or(Some(0.0))
}
