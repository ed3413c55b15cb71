//! Scoring.

use fit4cad::metrics::geometry::Scale;
use fit4cad::metrics::{self, Distribution, Measure, Protocol, Score, field_report};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::report::{field_to_dict, to_dict};
use crate::segmentation::Segmentation;

/// The protocol of that name.
pub(crate) fn protocol_of(name: &str) -> PyResult<Protocol> {
    let known = Protocol::ALL.into_iter().find(|known| known.name() == name);
    known.ok_or_else(|| {
        let names = Protocol::ALL.map(Protocol::name).join(", ");
        refused(format!(
            "there is no protocol `{name}`; there are {names}; the protocols of the field are in `score_field`"
        ))
    })
}

/// Every measure of a prediction against the truth.
#[pyfunction]
#[pyo3(signature = (cloud, truth, prediction, protocol, model = "", method = ""))]
pub(crate) fn score<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    truth: &Segmentation,
    prediction: &Segmentation,
    protocol: &str,
    model: &str,
    method: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let protocol = protocol_of(protocol)?;
    let (truth, prediction) = (&truth.segmentation, &prediction.segmentation);
    let report = py.detach(|| metrics::evaluate(&cloud.cloud, truth, prediction, protocol));
    to_dict(py, model, method, &report)
}

/// Every figure that the rest of the field reports of a prediction.
#[pyfunction]
#[pyo3(signature = (cloud, truth, prediction, normalisation = None, epsilon = None, model = "", method = ""))]
#[allow(
    clippy::too_many_arguments,
    reason = "they are those of the Python function"
)]
pub(crate) fn field<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    truth: &Segmentation,
    prediction: &Segmentation,
    normalisation: Option<&str>,
    epsilon: Option<f64>,
    model: &str,
    method: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let mut scale = Scale::default();
    if let Some(name) = normalisation {
        scale.normalisation = name.parse().map_err(refused)?;
    }
    if let Some(epsilon) = epsilon {
        if !(epsilon >= 0.0 && epsilon.is_finite()) {
            return Err(refused(format!(
                "epsilon is a number of at least 0, not {epsilon}"
            )));
        }
        scale.epsilon = epsilon;
    }
    let (truth, prediction) = (&truth.segmentation, &prediction.segmentation);
    let report = py.detach(|| field_report(&cloud.cloud, truth, prediction, scale));
    field_to_dict(py, model, method, &report)
}

/// A row of a summary: the method, its measures by key, its type errors.
type Row = (
    String,
    std::collections::BTreeMap<String, Option<f64>>,
    usize,
);

/// Sums up scores method by method, in the order in which the methods first appear.
#[pyfunction]
pub(crate) fn summarise<'py>(py: Python<'py>, rows: Vec<Row>) -> PyResult<Bound<'py, PyList>> {
    let scores = rows.iter().map(|(method, measures, type_errors)| Score {
        method,
        measures: Measure::ALL.map(|measure| measures.get(measure.name()).copied().flatten()),
        type_errors: *type_errors,
    });
    let list = PyList::empty(py);
    for summary in metrics::summarise(scores) {
        let over = PyDict::new(py);
        for measure in Measure::ALL {
            if let Some(found) = summary.over(measure) {
                over.set_item(measure.name(), spread(py, &found)?)?;
            }
        }
        list.append(dict!(py;
            "method" => &summary.method,
            "models" => summary.models,
            "typeErrors" => summary.type_errors,
            "over" => over,
        ))?;
    }
    Ok(list)
}

/// How values are spread, with the bootstrap 95 % interval of their mean; `None` where there is none.
#[pyfunction]
pub(crate) fn distribution<'py>(
    py: Python<'py>,
    values: Vec<f64>,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let Some(found) = Distribution::of(values.iter().copied()) else {
        return Ok(None);
    };
    let dict = spread(py, &found)?;
    let interval = metrics::bootstrap::mean_interval(values.iter().copied());
    dict.set_item("interval", interval)?;
    Ok(Some(dict))
}

pub(crate) fn spread<'py>(py: Python<'py>, found: &Distribution) -> PyResult<Bound<'py, PyDict>> {
    Ok(dict!(py;
        "count" => found.count,
        "mean" => found.mean,
        "min" => found.min,
        "lowerQuartile" => found.lower_quartile,
        "median" => found.median,
        "upperQuartile" => found.upper_quartile,
        "max" => found.max,
    ))
}
