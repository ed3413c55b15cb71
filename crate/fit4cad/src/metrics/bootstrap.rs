//! How certain a mean over models is.

use crate::random::Random;

/// How often models are drawn anew: the ends of the interval are then known to about a fortieth of
/// its length (the standard error of a 2.5 % quantile of 2,000 normal draws is 0.06 of a standard
/// deviation, of the 3.92 that the interval is long).
const DRAWS: usize = 2000;

/// Any: the same models have the same interval.
const SEED: u64 = 0x0b00_7574;

/// The bootstrap 95 % interval of the mean (Efron 1979, percentiles): between the 2.5 % and the 97.5 %
/// quantile of the means of as many values drawn with replacement. Values that are no numbers are left
/// out; `None` of fewer than two. Does not hang on the order of the values. O(2,000 n).
///
/// ```
/// use fit4cad::metrics::bootstrap::mean_interval;
/// let [low, high] = mean_interval([0.2, 0.4, 0.6, 0.8]).unwrap();
/// assert!(0.2 < low && low < 0.5 && 0.5 < high && high < 0.8);
/// assert_eq!(mean_interval([0.7, 0.7]), Some([0.7, 0.7]));
/// assert_eq!(mean_interval([0.7]), None);
/// ```
pub fn mean_interval(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let mut values: Vec<f64> = values.into_iter().filter(|value| !value.is_nan()).collect();
    values.sort_by(f64::total_cmp);
    let (&least, &most) = (values.first()?, values.last()?);
    if values.len() < 2 {
        return None;
    }
    let mut random = Random::new(SEED, values.len() as u64);
    let mut mean_of_draw = || {
        let draw = (0..values.len()).map(|_| values.get(random.below(values.len())));
        let mean = draw.flatten().sum::<f64>() / values.len() as f64;
        // Rounding alone would put the mean of equal values beside them.
        mean.clamp(least, most)
    };
    let mut means: Vec<f64> = (0..DRAWS).map(|_| mean_of_draw()).collect();
    means.sort_by(f64::total_cmp);
    let at = |share: f64| {
        means
            .get((share * (DRAWS - 1) as f64).round() as usize)
            .copied()
    };
    Some([at(0.025)?, at(0.975)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_about_four_standard_errors_long() {
        let mut random = Random::new(5, 0);
        let values: Vec<f64> = (0..400).map(|_| random.normal()).collect();
        let [low, high] = mean_interval(values.iter().copied()).unwrap();
        let mean = values.iter().sum::<f64>() / 400.0;
        assert!(low < mean && mean < high);
        // 2 · 1.96 / √400.
        assert!((high - low - 0.196).abs() < 0.02, "{low} to {high}");
    }

    #[test]
    fn it_covers_the_true_mean_nineteen_times_in_twenty() {
        let mut covered = 0;
        for stream in 0..200 {
            let mut random = Random::new(11, stream);
            let values: Vec<f64> = (0..50).map(|_| random.unit()).collect();
            let [low, high] = mean_interval(values).unwrap();
            covered += u32::from(low <= 0.5 && 0.5 <= high);
        }
        // Four standard deviations of 200 draws.
        assert!((178..=200).contains(&covered), "{covered} of 200");
    }

    #[test]
    fn the_order_of_models_decides_nothing_and_what_is_missing_is_left_out() {
        let forwards = mean_interval([0.1, 0.5, f64::NAN, 0.9]);
        assert_eq!(forwards, mean_interval([0.9, 0.1, 0.5]));
        assert_eq!(mean_interval([]), None);
    }
}
