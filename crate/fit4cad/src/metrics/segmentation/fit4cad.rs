//! Fit4CAD's own: the mean Sørensen–Dice index.

use super::over;
use super::overlaps::Overlaps;

/// **Definition.** Each true primitive G takes the predicted primitive P with which it shares most
/// points, of equals the first; the score is the mean over all G of 2 |G ∩ P| / (|G| + |P|), 0 for a G
/// that shares no point with any. The same by both of the benchmark's protocols.
///
/// **Source.** The paper, section "Quality indicators"; the measure [`Dsc`](crate::metrics::Measure::Dsc).
///
/// **Labels.** Sets, as the benchmark's files have them.
///
/// **Trap.** One P may serve many G: merging small neighbours into one primitive costs little, and
/// splinters that serve no G cost nothing.
///
/// `None` without true primitives. O(pairs).
pub fn score(overlaps: &Overlaps) -> Option<f64> {
    let mut best: Vec<(usize, f64)> = vec![(0, 0.0); overlaps.truth.len()];
    for pair in &overlaps.pairs {
        // Pairs ascend by prediction, so the first of equals stays.
        if let Some(found) = best.get_mut(pair.truth)
            && pair.shared > found.0
        {
            *found = (pair.shared, overlaps.dice(*pair));
        }
    }
    over(best.iter().map(|&(_, dice)| dice).sum(), best.len())
}
