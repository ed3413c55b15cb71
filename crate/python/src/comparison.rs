//! A method against another over the models that both have.

use fit4cad::metrics::Better;
use fit4cad::metrics::comparison::{Comparison, Difference, Outcome};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::dict::{dict, refused};

const fn word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Better => "better",
        Outcome::Worse => "worse",
        Outcome::Even => "even",
    }
}

fn difference<'py>(
    py: Python<'py>,
    found: Option<&Difference>,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let dict =
        found.map(|it| Ok::<_, PyErr>(dict!(py; "by" => it.by, "outcome" => word(it.outcome))));
    dict.transpose()
}

/// Compares own figures with others, a figure per model of both, NaN where it cannot be had: the differences,
/// both means, how often which is better, and Wilcoxon's signed-rank test.
#[pyfunction]
pub(crate) fn compare_figures<'py>(
    py: Python<'py>,
    own: Vec<f64>,
    theirs: Vec<f64>,
    higher_is_better: bool,
) -> PyResult<Bound<'py, PyDict>> {
    if own.len() != theirs.len() {
        return Err(refused("figures are compared model by model"));
    }
    let better = if higher_is_better {
        Better::Higher
    } else {
        Better::Lower
    };
    let known = |value: f64| value.is_finite().then_some(value);
    let pairs = own.into_iter().zip(theirs);
    let pairs: Vec<_> = pairs
        .map(|(own, theirs)| (known(own), known(theirs)))
        .collect();
    let found = Comparison::of(better, &pairs);
    let differences = PyList::empty(py);
    for each in &found.differences {
        differences.append(difference(py, each.as_ref())?)?;
    }
    let test = found.test.map(|test| {
        Ok::<_, PyErr>(dict!(py;
            "pairs" => test.pairs,
            "positive" => test.positive,
            "negative" => test.negative,
            "probability" => test.probability,
            "exact" => test.is_exact,
        ))
    });
    Ok(dict!(py;
        "differences" => differences,
        "own" => found.own,
        "theirs" => found.theirs,
        "mean" => difference(py, found.mean.as_ref())?,
        "better" => found.count(Outcome::Better),
        "worse" => found.count(Outcome::Worse),
        "even" => found.count(Outcome::Even),
        "test" => test.transpose()?,
    ))
}
