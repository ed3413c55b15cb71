//! What is wrong with a ground truth.

use std::collections::BTreeMap;

use fit4cad::audit::{self as engine, FormAudit};
use fit4cad::diagnostics::Diagnostic;
use fit4cad::format::write_surfaces;
use fit4cad::metrics::accuracy::FitAccuracy;
use fit4cad::model::Model;
use fit4cad::surface::{Form, SurfaceType};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::dict;
use crate::files::Findings;
use crate::segmentation::Segmentation;

fn model_of(name: &str, cloud: &Cloud, truth: Option<&Segmentation>) -> Model {
    Model {
        name: name.to_owned(),
        cloud: cloud.cloud.clone(),
        truth: truth.map(|truth| truth.segmentation.clone()),
        submissions: Vec::new(),
    }
}

/// Audits a ground truth; the findings of reading it become findings as well.
#[pyfunction]
#[pyo3(signature = (name, cloud, truth, findings = None))]
pub(crate) fn audit<'py>(
    py: Python<'py>,
    name: &str,
    cloud: &Cloud,
    truth: Option<&Segmentation>,
    findings: Option<&Findings>,
) -> PyResult<Bound<'py, PyDict>> {
    let model = model_of(name, cloud, truth);
    let told: Vec<Diagnostic> = findings.map_or_else(Vec::new, Findings::of_truth);
    let found = py.detach(|| engine::audit(&model, &told));
    let rows = PyList::empty(py);
    for finding in &found.findings {
        rows.append(dict!(py;
            "primitive" => finding.primitive,
            "check" => finding.check.name(),
            "severity" => finding.severity.to_string(),
            "value" => finding.value.and_then(finite),
            "limit" => finding.limit,
            "message" => &finding.message,
            "hint" => &finding.hint,
        ))?;
    }
    let primitives = PyList::empty(py);
    for primitive in &found.primitives {
        let form = |form: Option<FormAudit>| {
            form.map(|form| {
                Ok::<_, PyErr>(dict!(py;
                    "mean" => form.accuracy.and_then(mean),
                    "max" => form.accuracy.and_then(|accuracy| finite(accuracy.d_haus)),
                    "misfit" => finite(form.misfit),
                    "euclidean" => form.euclidean,
                ))
            })
            .transpose()
        };
        primitives.append(dict!(py;
            "number" => primitive.number,
            "type" => primitive.kind.map(SurfaceType::name),
            "points" => primitive.points,
            "off" => primitive.off,
            "parametric" => form(primitive.parametric)?,
            "implicit" => form(primitive.implicit)?,
            "firstOrder" => primitive.first_order.and_then(mean),
            "agreement" => primitive.agreement.and_then(finite),
        ))?;
    }
    Ok(dict!(py; "model" => name, "findings" => rows, "primitives" => primitives))
}

/// What was replaced, as (primitive, form, converted from), and the texts of the files it was replaced in.
type Corrected = (
    Vec<(u32, &'static str, &'static str)>,
    BTreeMap<&'static str, String>,
);

/// The surface files of a truth with wrong vectors replaced by exact conversions of right ones.
#[pyfunction]
pub(crate) fn corrected(py: Python<'_>, cloud: &Cloud, truth: &Segmentation) -> Corrected {
    let model = model_of("", cloud, Some(truth));
    let (truth, corrections) = py.detach(|| engine::correct(&model).unwrap_or_default());
    let changed = |form: &Form| {
        corrections
            .iter()
            .any(|correction| correction.form == *form)
    };
    let texts = Form::ALL.into_iter().filter(changed);
    let texts = texts.map(|form| (form.name(), write_surfaces(&truth, form)));
    let rows = corrections.iter();
    let rows = rows.map(|it| (it.primitive, it.form.name(), it.from.name()));
    (rows.collect(), texts.collect())
}

fn mean(accuracy: FitAccuracy) -> Option<f64> {
    finite(accuracy.mfe)
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
