//! A figure over many models: what a box plot shows.

/// How a figure is spread over models.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    /// Number of models that have the figure; at least one.
    pub count: usize,
    /// Arithmetic mean.
    pub mean: f64,
    /// Smallest value.
    pub min: f64,
    /// First quartile.
    pub lower_quartile: f64,
    /// Second quartile.
    pub median: f64,
    /// Third quartile.
    pub upper_quartile: f64,
    /// Largest value.
    pub max: f64,
}

impl Distribution {
    /// The distribution of the values that are numbers; `None` if there are none. Quartiles lie
    /// between the two nearest values in proportion (Hyndman and Fan 1996, definition 7, as R and
    /// NumPy have it). O(n log n).
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.into_iter().filter(|value| !value.is_nan()).collect();
        sorted.sort_by(f64::total_cmp);
        let (&min, &max) = (sorted.first()?, sorted.last()?);
        let quantile = |share: f64| {
            let place = share * (sorted.len() - 1) as f64;
            let below = place.floor();
            let at = |index: f64| sorted.get(index as usize).copied().unwrap_or(max);
            let (low, high) = (at(below), at(below + 1.0));
            low + (high - low) * (place - below)
        };
        Some(Self {
            count: sorted.len(),
            mean: sorted.iter().sum::<f64>() / sorted.len() as f64,
            min,
            lower_quartile: quantile(0.25),
            median: quantile(0.5),
            upper_quartile: quantile(0.75),
            max,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_the_nearest_values_in_proportion() {
        let distribution = Distribution::of([4.0, 1.0, 3.0, 2.0]).unwrap();
        assert_eq!(distribution.count, 4);
        assert_eq!(distribution.mean, 2.5);
        assert_eq!((distribution.min, distribution.max), (1.0, 4.0));
        assert_eq!(distribution.lower_quartile, 1.75);
        assert_eq!(distribution.median, 2.5);
        assert_eq!(distribution.upper_quartile, 3.25);
    }

    #[test]
    fn one_value_is_all_its_quartiles() {
        let distribution = Distribution::of([0.25]).unwrap();
        assert_eq!(
            (distribution.lower_quartile, distribution.upper_quartile),
            (0.25, 0.25)
        );
        assert_eq!(Distribution::of([f64::NAN]), None);
    }
}
