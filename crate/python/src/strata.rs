//! What true primitives are told apart by, and under what conditions a model is scored.

use fit4cad::metrics::field::{By, Conditions};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::segmentation::Segmentation;

/// A condition as a dictionary; `None` for what is no condition.
fn condition(
    py: Python<'_>,
    by: By,
    value: Option<f64>,
    declared: bool,
) -> PyResult<Option<Bound<'_, PyDict>>> {
    let Some(stratum) = by.of_value(value) else {
        return Ok(None);
    };
    Ok(Some(dict!(py;
        "by" => by.name(),
        "value" => value,
        "stratum" => stratum,
        "declared" => declared,
    )))
}

/// The conditions under which a model is scored, measured from its points and its truth.
#[pyfunction]
pub(crate) fn conditions<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    truth: &Segmentation,
) -> PyResult<Bound<'py, PyList>> {
    let measured = py.detach(|| Conditions::of(&cloud.cloud, &truth.segmentation));
    let list = PyList::empty(py);
    for by in By::ALL {
        if let Some(found) = condition(py, by, measured.value(by), false)? {
            list.append(found)?;
        }
    }
    Ok(list)
}

/// A condition whose value is known from elsewhere; `None` for what is no condition.
#[pyfunction]
pub(crate) fn declared_condition<'py>(
    py: Python<'py>,
    by: &str,
    value: f64,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let by = By::from_name(by).ok_or_else(|| {
        let names = By::ALL.map(By::name).join(", ");
        refused(format!("there are no strata by `{by}`; there are {names}"))
    })?;
    condition(py, by, Some(value), true)
}
