//! Coefficient distance d1 between implicit vectors (paper, section "Approximation accuracy").

use crate::model::Coefficients;

/// d1(v, v′) = ‖v − v′‖₁ of the vectors scaled to norm 1, where the sign of v′ is free: the
/// smaller of ‖v − v′‖₁ and ‖v + v′‖₁. `None` if the lengths differ, or a vector cannot be scaled
/// to norm 1: it is zero, or its norm overflows.
///
/// The paper makes the first nonzero entry positive. That is the same sign, except where the
/// entry is rounding noise, whose sign means nothing.
pub fn coefficient_distance(predicted: &[f64], truth: &[f64]) -> Option<f64> {
    let (difference, sum) = difference_and_sum(predicted, truth)?;
    Some(difference.min(sum))
}

/// d1 as the authors' script has it: v is negated if *any* pair of entries has opposite signs, be
/// it −1e-18 against 1e-18. `None` as in [`coefficient_distance`].
pub fn published_distance(predicted: &[f64], truth: &[f64]) -> Option<f64> {
    let (difference, sum) = difference_and_sum(predicted, truth)?;
    let negated = opposite_signs(predicted, truth).next().is_some();
    Some(if negated { sum } else { difference })
}

/// The places at which two vectors have entries of opposite signs, ascending: any of them makes the
/// authors' script negate.
pub fn opposite_signs(predicted: &[f64], truth: &[f64]) -> impl Iterator<Item = usize> {
    let pairs = predicted.iter().zip(truth).enumerate();
    pairs
        .filter(|&(_, (v, w))| (*v < 0.0 && *w > 0.0) || (*v > 0.0 && *w < 0.0))
        .map(|(place, _)| place)
}

/// A vector scaled to norm 1; `None` if it is zero or its norm overflows.
pub fn normalised(vector: &[f64]) -> Option<Vec<f64>> {
    let norm = norm(vector)?;
    Some(vector.iter().map(|value| value / norm).collect())
}

/// The mean of d1 as the authors' script has it. `pairs` holds, for each predicted primitive, its
/// vector and that of its most overlapping true primitive (`None` if it overlaps none); `truth` is
/// the number of true primitives. The mean runs over a row of zeros as long as the longer of the
/// two segmentations, less the pairs left out: those of different length or with a malformed
/// vector. So primitives that are missing, and vectors that are, count as perfect.
///
/// `None` if no prediction gives a vector: a method that has none has no d1.
pub fn published_mean<'a>(
    pairs: impl IntoIterator<Item = (&'a Coefficients, Option<&'a Coefficients>)>,
    truth: usize,
) -> Option<f64> {
    let (mut predicted, mut left_out, mut sum, mut any) = (0usize, 0usize, 0.0, false);
    for (vector, partner) in pairs {
        predicted += 1;
        any |= vector.values().is_some();
        match (vector, partner) {
            (_, None) | (Coefficients::Missing, _) | (_, Some(Coefficients::Missing)) => {}
            (Coefficients::Given(vector), Some(Coefficients::Given(partner))) => {
                match published_distance(vector, partner) {
                    Some(distance) => sum += distance,
                    None => left_out += 1,
                }
            }
            (Coefficients::Malformed, _) | (_, Some(Coefficients::Malformed)) => left_out += 1,
        }
    }
    let slots = predicted.max(truth).saturating_sub(left_out);
    (any && slots > 0).then(|| sum / slots as f64)
}

/// ‖v − v′‖₁ and ‖v + v′‖₁ of the vectors scaled to norm 1.
fn difference_and_sum(v: &[f64], w: &[f64]) -> Option<(f64, f64)> {
    if v.len() != w.len() {
        return None;
    }
    let (v_norm, w_norm) = (norm(v)?, norm(w)?);
    let (mut difference, mut sum) = (0.0, 0.0);
    for (v, w) in v.iter().zip(w) {
        let (v, w) = (v / v_norm, w / w_norm);
        difference += (v - w).abs();
        sum += (v + w).abs();
    }
    Some((difference, sum))
}

/// The Euclidean norm, if one can divide by it.
fn norm(vector: &[f64]) -> Option<f64> {
    let norm = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    (norm > 0.0 && norm.is_finite()).then_some(norm)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(values: &[f64]) -> Coefficients {
        Coefficients::Given(values.to_vec())
    }

    #[test]
    fn norm_and_sign_do_not_matter() {
        let distance = coefficient_distance(&[0.0, 3.0, 0.0, -4.0], &[0.0, -0.6, 0.0, 0.8]);
        assert!(distance.unwrap() < 1e-15);
    }

    #[test]
    fn the_distance_of_two_crossed_planes_is_two() {
        let distance = coefficient_distance(&[2.0, 0.0, 0.0, 0.0], &[0.0, 5.0, 0.0, 0.0]);
        assert_eq!(distance, Some(2.0));
    }

    #[test]
    fn noise_in_the_first_entry_does_not_turn_the_sign() {
        let (v, w) = ([-1e-18, 0.0, 1.0, 2.0], [1e-18, 0.0, 1.0, 2.0]);
        assert!(coefficient_distance(&v, &w).unwrap() < 1e-15);
        // The authors' script negates the whole vector: 2 (|1| + |2|) / √5.
        let published = published_distance(&v, &w).unwrap();
        assert!((published - 6.0 / 5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn vectors_of_different_length_or_of_zeros_have_no_distance() {
        assert_eq!(coefficient_distance(&[1.0; 4], &[1.0; 10]), None);
        assert_eq!(coefficient_distance(&[0.0; 4], &[1.0; 4]), None);
    }

    #[test]
    fn in_the_published_mean_missing_counts_as_perfect_and_malformed_is_left_out() {
        let (x, y) = (given(&[1.0, 0.0, 0.0, 0.0]), given(&[0.0, 1.0, 0.0, 0.0]));
        // One distance of 2 over five true primitives.
        assert_eq!(published_mean([(&x, Some(&y))], 5), Some(2.0 / 5.0));
        // Three predictions for two true primitives: three slots.
        let (missing, malformed) = (Coefficients::Missing, Coefficients::Malformed);
        let pairs = [(&x, Some(&y)), (&missing, Some(&y)), (&x, None)];
        assert_eq!(published_mean(pairs, 2), Some(2.0 / 3.0));
        let pairs = [(&x, Some(&y)), (&malformed, Some(&y)), (&x, None)];
        assert_eq!(published_mean(pairs, 2), Some(2.0 / 2.0));
        let quadric = given(&[1.0; 10]);
        assert_eq!(
            published_mean([(&x, Some(&y)), (&quadric, Some(&y))], 2),
            Some(2.0)
        );
    }

    #[test]
    fn a_method_without_vectors_has_no_published_mean() {
        let missing = Coefficients::Missing;
        assert_eq!(published_mean([(&missing, Some(&given(&[1.0])))], 3), None);
        assert_eq!(published_mean([], 3), None);
    }
}
