//! What a prediction makes of each point: the labels by which results are looked at.

use super::matching::{Incidence, best_matches};
use crate::model::Segmentation;

/// What one prediction makes of a point, seen from one true primitive. The numbers are those of
/// typed arrays.
#[repr(u8)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PointOutcome {
    /// In neither.
    #[default]
    TrueNegative = 0,
    /// In both: rightly found.
    TruePositive = 1,
    /// Predicted, and not of the true primitive.
    FalsePositive = 2,
    /// Of the true primitive, and not predicted.
    FalseNegative = 3,
}

/// The outcome at each of a cloud's points for a true and a predicted primitive, given by their
/// lists; an absent one lists nothing. Indices beyond the cloud are left out. O(points + listed).
///
/// ```
/// use fit4cad::metrics::outcome::{PointOutcome::*, outcomes};
/// let found = outcomes(4, &[0, 1], &[1, 2]);
/// assert_eq!(found, [FalseNegative, TruePositive, FalsePositive, TrueNegative]);
/// ```
pub fn outcomes(points: usize, truth: &[u32], predicted: &[u32]) -> Vec<PointOutcome> {
    let mut outcomes = vec![PointOutcome::TrueNegative; points];
    for &index in truth {
        if let Some(outcome) = outcomes.get_mut(index as usize) {
            *outcome = PointOutcome::FalseNegative;
        }
    }
    for &index in predicted {
        if let Some(outcome) = outcomes.get_mut(index as usize) {
            *outcome = match outcome {
                PointOutcome::FalseNegative | PointOutcome::TruePositive => {
                    PointOutcome::TruePositive
                }
                _ => PointOutcome::FalsePositive,
            };
        }
    }
    outcomes
}

/// The paper's figures of results: a label per point, 0 where nothing is predicted, i + 1 where the
/// true primitive at place i has a point that its match rightly lists, and one more than there are
/// true primitives where the point is predicted and rightly so for none. Of several true primitives
/// the first is seen. O(points + listed indices · log classes), as for matching.
pub fn figure(points: usize, truth: &Segmentation, prediction: &Segmentation) -> Vec<u32> {
    let incidence = Incidence::new(prediction, points);
    let matches = best_matches(truth, &incidence);
    let wrong = truth.primitives.len() as u32 + 1;
    let mut labels = vec![0; points];
    for &index in prediction.primitives.iter().flat_map(|it| &it.points) {
        if let Some(label) = labels.get_mut(index as usize) {
            *label = wrong;
        }
    }
    // Which true primitive's match last listed a point: its number, so that nothing is cleared.
    let mut listed = vec![0; points];
    let places = (1..wrong).zip(truth.primitives.iter().zip(&matches));
    for (number, (primitive, found)) in places.rev() {
        let matched = found.and_then(|found| prediction.primitives.get(found.index));
        for &index in matched.iter().flat_map(|it| &it.points) {
            if let Some(mark) = listed.get_mut(index as usize) {
                *mark = number;
            }
        }
        for &index in &primitive.points {
            if listed.get(index as usize) == Some(&number)
                && let Some(label) = labels.get_mut(index as usize)
            {
                *label = number;
            }
        }
    }
    labels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Cloud, Point};
    use crate::metrics::{Counts, Protocol, evaluate};
    use crate::model::Primitive;

    fn listing(lists: &[&[u32]]) -> Segmentation {
        let primitive = |list: &&[u32]| Primitive {
            points: list.to_vec(),
            ..Primitive::default()
        };
        Segmentation {
            primitives: lists.iter().map(primitive).collect(),
        }
    }

    #[test]
    fn the_labels_are_the_points_that_the_counts_count() {
        let truth = listing(&[&[0, 1, 2, 3, 4], &[5, 6]]);
        let prediction = listing(&[&[3, 4, 5, 6, 7], &[0]]);
        let cloud = Cloud::new(vec![Point::origin(); 9]);
        let report = evaluate(&cloud, &truth, &prediction, Protocol::Definition);
        for (primitive, row) in truth.primitives.iter().zip(&report.primitives) {
            let matched = row
                .matched
                .map(|at| prediction.primitives[at].points.clone());
            let labels = outcomes(9, &primitive.points, &matched.unwrap_or_default());
            let count = |wanted| labels.iter().filter(|&&label| label == wanted).count();
            let counted = Counts {
                true_positives: count(PointOutcome::TruePositive),
                false_positives: count(PointOutcome::FalsePositive),
                false_negatives: count(PointOutcome::FalseNegative),
                true_negatives: count(PointOutcome::TrueNegative),
            };
            assert_eq!(counted, row.counts);
        }
    }

    #[test]
    fn lists_that_repeat_or_reach_too_far_change_nothing() {
        let twice = outcomes(3, &[0, 0, 9], &[0, 0, 1, u32::MAX]);
        assert_eq!(twice, outcomes(3, &[0], &[0, 1]));
        assert_eq!(outcomes(2, &[], &[]), [PointOutcome::TrueNegative; 2]);
    }

    #[test]
    fn the_figure_shows_what_is_rightly_found_and_blackens_the_rest() {
        // The second true primitive is found, with a point of the first; the first has no match.
        let truth = listing(&[&[0, 1], &[2, 3, 4]]);
        let prediction = listing(&[&[3, 4, 5], &[6]]);
        assert_eq!(figure(8, &truth, &prediction), [0, 0, 0, 2, 2, 3, 3, 0]);
    }

    #[test]
    fn where_true_primitives_share_a_point_the_first_is_seen() {
        let truth = listing(&[&[0, 1], &[1, 2]]);
        assert_eq!(figure(3, &truth, &truth), [1, 1, 2]);
        // One prediction for both: every point is right.
        assert_eq!(figure(3, &truth, &listing(&[&[0, 1, 2]])), [1, 1, 2]);
    }
}
