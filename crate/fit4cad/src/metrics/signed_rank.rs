//! Whether two methods differ on the same models by more than chance.

use crate::sorting::sort_by;

/// Pairs up to which the probability is counted exactly; beyond, the normal distribution is less than
/// 0.003 off, and a third of that below 0.05.
const EXACT: usize = 50;

/// Wilcoxon's signed-rank test of paired differences (Wilcoxon 1945).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignedRank {
    /// Differences that are not zero: the pairs that the test looks at.
    pub pairs: usize,
    /// Sum of the ranks of the positive differences.
    pub positive: f64,
    /// Sum of the ranks of the negative ones.
    pub negative: f64,
    /// Probability, two-sided, of rank sums at least as far apart if either sign were as likely for
    /// every pair.
    pub probability: f64,
    /// Whether the probability is counted over all signs; else it is that of the normal
    /// distribution, with corrections for ties and for continuity.
    pub is_exact: bool,
}

impl SignedRank {
    /// Tests differences. Zeros are left out, and equal ones share their mean rank. `None` where no
    /// difference is left. O(n³) up to 50 pairs, O(n log n) beyond.
    ///
    /// ```
    /// use fit4cad::metrics::signed_rank::SignedRank;
    /// let test = SignedRank::of([0.3, 0.1, 0.2, 0.5, 0.4]).unwrap();
    /// // All of one sign: 2 of the 2⁵ ways.
    /// assert_eq!((test.positive, test.negative, test.probability), (15.0, 0.0, 2.0 / 32.0));
    /// ```
    pub fn of(differences: impl IntoIterator<Item = f64>) -> Option<Self> {
        let is_told = |difference: &f64| difference.abs() > 0.0 && difference.is_finite();
        let mut told: Vec<f64> = differences.into_iter().filter(is_told).collect();
        if told.is_empty() {
            return None;
        }
        sort_by(&mut told, |one, other| one.abs().total_cmp(&other.abs()));
        let (mut doubled, mut positive, mut below) = (Vec::new(), 0u64, 0u64);
        let mut ties = 0.0;
        for equal in told.chunk_by(|one, other| one.abs() == other.abs()) {
            let size = equal.len() as u64;
            // Twice the mean of ranks below + 1 … below + size: a whole number.
            let rank = 2 * below + size + 1;
            let above_zero = equal.iter().filter(|&&difference| difference > 0.0).count();
            positive += rank * above_zero as u64;
            doubled.extend(std::iter::repeat_n(rank as usize, equal.len()));
            ties += (size * size * size - size) as f64;
            below += size;
        }
        let total: u64 = below * (below + 1);
        let negative = total - positive;
        let smaller = positive.min(negative);
        let is_exact = told.len() <= EXACT;
        Some(Self {
            pairs: told.len(),
            positive: positive as f64 / 2.0,
            negative: negative as f64 / 2.0,
            probability: if is_exact {
                exact(&doubled, smaller as usize)
            } else {
                normal(told.len() as f64, smaller as f64 / 2.0, ties)
            },
            is_exact,
        })
    }
}

/// Twice the share of all choices of signs whose positive ranks sum to at most `most`; ranks doubled.
fn exact(ranks: &[usize], most: usize) -> f64 {
    let total: usize = ranks.iter().sum();
    let mut ways = vec![0.0; total + 1];
    if let Some(none) = ways.first_mut() {
        *none = 1.0;
    }
    for &rank in ranks {
        for sum in (rank..=total).rev() {
            let more = ways.get(sum - rank).copied().unwrap_or(0.0);
            if let Some(way) = ways.get_mut(sum) {
                *way += more;
            }
        }
    }
    let tail: f64 = ways.iter().take(most + 1).sum();
    let all: f64 = ways.iter().sum();
    (2.0 * tail / all).min(1.0)
}

/// The same by the normal distribution of the rank sum.
fn normal(pairs: f64, smaller: f64, ties: f64) -> f64 {
    let mean = pairs * (pairs + 1.0) / 4.0;
    let variance = pairs * (pairs + 1.0) * (2.0 * pairs + 1.0) / 24.0 - ties / 48.0;
    let z = (smaller - mean + 0.5).min(0.0) / variance.sqrt();
    if z.is_nan() {
        1.0
    } else {
        libm::erfc(-z / std::f64::consts::SQRT_2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn probability(differences: &[f64]) -> f64 {
        SignedRank::of(differences.iter().copied())
            .unwrap()
            .probability
    }

    /// Every choice of signs, one by one.
    fn counted(differences: &[f64]) -> f64 {
        let told: Vec<f64> = differences
            .iter()
            .copied()
            .filter(|it| *it != 0.0)
            .collect();
        let ranks: Vec<f64> = told
            .iter()
            .map(|one| {
                let below = told.iter().filter(|it| it.abs() < one.abs()).count() as f64;
                let equal = told.iter().filter(|it| it.abs() == one.abs()).count() as f64;
                below + (equal + 1.0) / 2.0
            })
            .collect();
        let total: f64 = ranks.iter().sum();
        let sum = |is_positive: &dyn Fn(usize) -> bool| -> f64 {
            let own = ranks.iter().enumerate().filter(|(at, _)| is_positive(*at));
            own.map(|(_, rank)| rank).sum()
        };
        let away = |sum: f64| (sum - total / 2.0).abs();
        let found = away(sum(&|at| told[at] > 0.0));
        let all = 1u32 << told.len();
        let far = (0..all).filter(|signs| away(sum(&|at| signs >> at & 1 == 1)) >= found - 1e-9);
        far.count() as f64 / f64::from(all)
    }

    #[test]
    fn it_counts_as_trying_every_sign_does() {
        let samples: [&[f64]; 4] = [
            &[0.1, -0.2, 0.3, 0.4, -0.5, 0.6, 0.7],
            &[0.1, 0.1, -0.1, 0.2, -0.2, 0.2, 0.3, 0.3],
            &[1.0, 0.0, -1.0, 0.0],
            &[-0.4, -0.3, -0.2, -0.1, 0.05, -0.6],
        ];
        for sample in samples {
            let (found, expected) = (probability(sample), counted(sample));
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }

    #[test]
    fn a_textbook_example_comes_out() {
        // Wilcoxon 1945, cross- and self-fertilised corn: rank sum 24 of 15 pairs.
        let corn = [49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48].map(f64::from);
        let test = SignedRank::of(corn).unwrap();
        assert_eq!((test.pairs, test.negative), (15, 24.0));
        assert!(
            (test.probability - 0.041_26).abs() < 1e-4,
            "{}",
            test.probability
        );
    }

    #[test]
    fn where_the_normal_distribution_takes_over_it_is_as_good() {
        let ranks: Vec<usize> = (1..=EXACT).map(|rank| 2 * rank).collect();
        for smaller in [300, 400, 500, 600] {
            let counted = exact(&ranks, 2 * smaller);
            let approximate = normal(EXACT as f64, smaller as f64, 0.0);
            assert!(
                (counted - approximate).abs() < 3e-3,
                "{counted}, {approximate}"
            );
        }
        let many = |count: usize| SignedRank::of((1..=count).map(|rank| rank as f64)).unwrap();
        assert!(many(EXACT).is_exact && !many(EXACT + 1).is_exact);
    }

    #[test]
    fn no_difference_says_nothing_and_signs_change_sides() {
        assert_eq!(SignedRank::of([0.0, 0.0]), None);
        let (one, other) = (
            SignedRank::of([0.3, -0.1, 0.2]).unwrap(),
            SignedRank::of([-0.3, 0.1, -0.2]).unwrap(),
        );
        assert_eq!(
            (one.positive, one.negative),
            (other.negative, other.positive)
        );
        assert_eq!(one.probability, other.probability);
    }
}
