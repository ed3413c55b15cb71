//! Roots of the polynomials that rays and surfaces of the five families meet at.

/// Halvings until an interval within 0 to 1 is as narrow as numbers there are.
const HALVINGS: usize = 54;

/// The roots of a polynomial between 0 and 1, ascending; its coefficients begin with the constant one.
/// Where it only touches zero there is none. Between the roots of its derivative a polynomial has one root at
/// most, which halving finds: O(degree²) evaluations, safe whatever the coefficients.
pub(super) fn roots(coefficients: &[f64]) -> Vec<f64> {
    let [_, rest @ ..] = coefficients else {
        return Vec::new();
    };
    if rest.iter().all(|it| *it == 0.0) {
        return Vec::new();
    }
    let derivative: Vec<f64> = (1..).zip(rest).map(|(k, it)| f64::from(k) * it).collect();
    let value = |t: f64| coefficients.iter().rev().fold(0.0, |sum, it| sum * t + it);
    let mut borders = roots(&derivative);
    borders.push(1.0);
    let mut found = Vec::new();
    let mut from = 0.0;
    for to in borders {
        let rises = value(from) < 0.0;
        if rises != (value(to) < 0.0) {
            let (mut low, mut high) = (from, to);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if (value(middle) < 0.0) == rises {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push(0.5 * (low + high));
        }
        from = to;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::roots;

    #[test]
    fn the_roots_of_a_quartic_within_the_unit_interval_are_found_and_no_others() {
        // (t + 1) (t - 0.25) (t - 0.5) (t - 2).
        let found = roots(&[-0.25, 1.375, -1.125, -1.75, 1.0]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((found[0] - 0.25).abs() < 1e-14 && (found[1] - 0.5).abs() < 1e-14);
    }

    #[test]
    fn what_has_no_roots_has_none() {
        assert!(roots(&[]).is_empty());
        assert!(roots(&[0.0]).is_empty());
        assert!(roots(&[1.0, 0.0, 0.0]).is_empty());
        assert!(roots(&[1.0, 0.0, 1.0]).is_empty());
        assert!(roots(&[f64::NAN, 1.0]).len() <= 1);
    }
}
