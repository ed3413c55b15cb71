//! SHREC 2022's tables of segments.

use fit4cad::metrics::recognition::{Rates, recognise};
use fit4cad::surface::SurfaceType;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::segmentation::Segmentation;
use crate::surface::kind_of;

/// Sets every true primitive beside the answer: lengths over the unit of a normalisation. Nothing where
/// primitives are too entangled to be matched.
#[pyfunction]
pub(crate) fn segments<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    truth: &Segmentation,
    prediction: &Segmentation,
    normalisation: &str,
) -> PyResult<Bound<'py, PyList>> {
    let normalisation = normalisation.parse().map_err(refused)?;
    let (truth, prediction) = (&truth.segmentation, &prediction.segmentation);
    let found = py.detach(|| recognise(&cloud.cloud, truth, prediction, normalisation));
    let list = PyList::empty(py);
    for segment in found.into_iter().flatten() {
        list.append(dict!(py;
            "truth" => segment.number,
            "type" => segment.kind.map(SurfaceType::name),
            "answer" => segment.answer.map(SurfaceType::name),
            "mfe" => segment.mfe,
            "hausdorff" => segment.hausdorff,
            "parameters" => segment.parameters,
        ))?;
    }
    Ok(list)
}

/// How well types are told, of pairs of a true and an answered one, each rate the mean over types. Of a
/// segment of none of the five nothing is counted.
#[pyfunction]
pub(crate) fn rates(
    py: Python<'_>,
    answered: Vec<(Option<String>, Option<String>)>,
) -> PyResult<Bound<'_, PyDict>> {
    let mut pairs = Vec::new();
    for (kind, answer) in answered {
        if let Some(kind) = kind {
            let answer = answer.map(|name| kind_of(&name)).transpose()?;
            pairs.push((kind_of(&kind)?, answer));
        }
    }
    let found = Rates::of(&pairs);
    Ok(dict!(py;
        "PPV" => found.ppv,
        "NPV" => found.npv,
        "TPR" => found.tpr,
        "TNR" => found.tnr,
        "ACC" => found.acc,
    ))
}
