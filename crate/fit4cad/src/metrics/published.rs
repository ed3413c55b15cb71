//! What was published of the paper's two methods.

/// The figures of primitive growing (PG) and the Hough transform (HT) on the 35 test models, as JSON: `measures` names
/// the columns, `models` holds for each its points, its true primitives and, for each method, the means by either
/// protocol, scored anew from the authors' result files and rounded to six digits, and those that the paper prints. PG
/// was published without surfaces, so its rows end before the fit accuracy.
///
/// Source: the result files of the public repository of Fit4CAD, and the tables of both methods in the paper.
pub const PUBLISHED: &str = include_str!("published.json");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::{Measure, Protocol};
    use serde_json::Value;

    #[test]
    fn every_test_model_has_the_figures_of_both_methods_by_both_protocols() {
        let published: Value = serde_json::from_str(PUBLISHED).unwrap();
        let measures: Vec<_> = published["measures"].as_array().unwrap().iter().collect();
        // A measure that came later was not published.
        assert!(
            measures
                .iter()
                .zip(Measure::ALL)
                .all(|(name, measure)| *name == measure.name())
        );
        let models = published["models"].as_object().unwrap();
        assert_eq!(models.len(), 35);
        for model in models.values() {
            for (method, columns) in [("PG", 6), ("HT", 9)] {
                for by in Protocol::ALL
                    .map(Protocol::name)
                    .into_iter()
                    .chain(["paper"])
                {
                    let figures = model[method][by].as_array().unwrap();
                    assert_eq!(figures.len(), columns);
                    assert!(
                        figures
                            .iter()
                            .all(|figure| figure.is_number() || figure.is_null())
                    );
                }
            }
        }
    }
}
