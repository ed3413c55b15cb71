//! Figures over many models: what a box plot shows, and what stands under a table.

use std::collections::BTreeMap;

use super::Measure;

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

/// What a summary takes of one report.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Score<'a> {
    /// The method.
    pub method: &'a str,
    /// The report's means over primitives, in the order of [`Measure::ALL`].
    pub measures: [Option<f64>; Measure::ALL.len()],
    /// Predictions whose type is another than their true primitive's.
    pub type_errors: usize,
}

/// One method over the models it was scored on.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodSummary {
    /// The method.
    pub method: String,
    /// Number of models it was scored on.
    pub models: usize,
    /// Type errors on all of them.
    pub type_errors: usize,
    /// Each measure in the order of [`Measure::ALL`], over the models that have it.
    over: Vec<Option<Distribution>>,
}

impl MethodSummary {
    /// How a measure is spread over the models that have it; `None` where none has.
    pub fn over(&self, measure: Measure) -> Option<Distribution> {
        let place = Measure::ALL.iter().position(|&each| each == measure)?;
        self.over.get(place).copied().flatten()
    }
}

/// Sums up reports method by method, in the order in which the methods first appear. A model that
/// lacks a measure is left out of its mean, and a mean over no model is `None`, never 0. O(n log n).
///
/// ```
/// use fit4cad::metrics::{Measure, Score, summarise};
/// let score = |value| Score { method: "HT", measures: Measure::ALL.map(|_| Some(value)), type_errors: 1 };
/// let [summary] = &summarise([score(0.5), score(1.0)])[..] else { unreachable!() };
/// assert_eq!(summary.type_errors, 2);
/// assert_eq!(summary.over(Measure::Dsc).map(|over| over.mean), Some(0.75));
/// ```
pub fn summarise<'a>(scores: impl IntoIterator<Item = Score<'a>>) -> Vec<MethodSummary> {
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    let mut groups: Vec<(&str, Vec<Score<'_>>)> = Vec::new();
    for score in scores {
        let place = *places.entry(score.method).or_insert(groups.len());
        match groups.get_mut(place) {
            Some((_, own)) => own.push(score),
            None => groups.push((score.method, vec![score])),
        }
    }
    let summary = |(method, own): (&str, Vec<Score<'_>>)| {
        let over = |place: usize| {
            let values = own.iter().map(|score| score.measures.get(place).copied());
            Distribution::of(values.flatten().flatten())
        };
        MethodSummary {
            method: method.to_owned(),
            models: own.len(),
            type_errors: own.iter().map(|score| score.type_errors).sum(),
            over: (0..Measure::ALL.len()).map(over).collect(),
        }
    };
    groups.into_iter().map(summary).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With a value of the first measure alone.
    fn score(method: &str, dsc: Option<f64>) -> Score<'_> {
        let mut measures = [None; Measure::ALL.len()];
        measures[0] = dsc;
        Score {
            method,
            measures,
            type_errors: 2,
        }
    }

    #[test]
    fn methods_keep_their_order_and_models_without_the_measure_are_left_out() {
        let scores = [
            score("PG", Some(0.5)),
            score("HT", None),
            score("PG", None),
            score("PG", Some(1.0)),
        ];
        let [pg, ht] = &summarise(scores)[..] else {
            panic!("two methods");
        };
        assert_eq!(
            (pg.method.as_str(), pg.models, pg.type_errors),
            ("PG", 3, 6)
        );
        let dsc = pg.over(Measure::Dsc).unwrap();
        assert_eq!((dsc.count, dsc.mean), (2, 0.75));
        assert_eq!((ht.method.as_str(), ht.models), ("HT", 1));
        assert_eq!(ht.over(Measure::Dsc), None);
        assert_eq!(summarise([]), []);
    }

    #[test]
    fn the_order_of_models_decides_nothing() {
        let values = [0.1, 0.7, 1e-17, 0.3, 1.0 / 3.0];
        let forwards = summarise(values.map(|value| score("HT", Some(value))));
        let mut values = values;
        values.reverse();
        assert_eq!(
            summarise(values.map(|value| score("HT", Some(value)))),
            forwards
        );
    }

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
