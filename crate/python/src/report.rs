//! Scores as dictionaries: the JSON of the command line.

use fit4cad::metrics::hidden::TypeConfusion;
use fit4cad::metrics::{FieldReport, Group, Measures, Report};
use fit4cad::surface::{OTHER, SurfaceType};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::dict::dict;

/// The score of one submission, with names in the place of positions.
pub(crate) fn to_dict<'py>(
    py: Python<'py>,
    model: &str,
    method: &str,
    report: &Report,
) -> PyResult<Bound<'py, PyDict>> {
    let mean = PyDict::new(py);
    add(&mean, &report.mean, |_| true)?;
    Ok(dict!(py;
        "model" => model,
        "method" => method,
        "protocol" => report.protocol.name(),
        "points" => report.points,
        "truth" => report.truth,
        "predicted" => report.predicted,
        "mean" => mean,
        "type_errors" => report.type_errors,
        "primitives" => truth_rows(py, report)?,
        "predictions" => prediction_rows(py, report)?,
        "hidden" => hidden(py, report)?,
    ))
}

fn add(
    dict: &Bound<'_, PyDict>,
    measures: &Measures,
    wanted: impl Fn(Group) -> bool,
) -> PyResult<()> {
    for (measure, value) in measures.iter().filter(|(it, _)| wanted(it.group())) {
        dict.set_item(measure.name(), value)?;
    }
    Ok(())
}

fn truth_rows<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyList>> {
    let rows = PyList::empty(py);
    for (place, row) in report.primitives.iter().enumerate() {
        let matched = row.matched.and_then(|index| report.predictions.get(index));
        let dict = dict!(py;
            "truth" => row.number,
            "match" => matched.map(|prediction| prediction.number),
            "type" => row.kind.map(SurfaceType::name),
            "size" => row.size,
        );
        let measures = report.measures_of(place).unwrap_or_default();
        add(&dict, &measures, |_| true)?;
        rows.append(dict)?;
    }
    Ok(rows)
}

fn prediction_rows<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyList>> {
    let rows = PyList::empty(py);
    for row in &report.predictions {
        let matched = row.matched.and_then(|place| report.primitives.get(place));
        let dict = dict!(py;
            "prediction" => row.number,
            "match" => matched.map(|primitive| primitive.number),
            "type" => row.kind.map(SurfaceType::name),
            "size" => row.size,
            "DSC" => row.dsc,
        );
        add(&dict, &row.fit, |group| group == Group::Accuracy)?;
        dict.set_item("type_error", row.type_error)?;
        rows.append(dict)?;
    }
    Ok(rows)
}

fn hidden<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyDict>> {
    let truth = |places: &[usize]| {
        let rows = places.iter().filter_map(|&at| report.primitives.get(at));
        rows.map(|row| row.number).collect::<Vec<u32>>()
    };
    let predictions = |places: &[usize]| {
        let rows = places.iter().filter_map(|&at| report.predictions.get(at));
        rows.map(|row| row.number).collect::<Vec<u32>>()
    };
    let hidden = &report.hidden;
    Ok(dict!(py;
        "missed" => truth(&hidden.missed),
        "merged" => truth(&hidden.merged),
        "spurious" => predictions(&hidden.spurious),
        "prediction_dsc" => hidden.prediction_dsc,
        "types" => types(py, &hidden.types)?,
        "labelled" => hidden.labelled,
        "truth_labelled" => hidden.truth_labelled,
    ))
}

fn types<'py>(py: Python<'py>, types: &TypeConfusion) -> PyResult<Bound<'py, PyDict>> {
    let names = |others: &[&'static str]| {
        let five = SurfaceType::ALL.map(SurfaceType::name).into_iter();
        five.chain(others.iter().copied()).collect::<Vec<_>>()
    };
    Ok(dict!(py;
        "truth" => names(&[OTHER]),
        "match" => names(&[OTHER, "Missed"]),
        "counts" => types.table().map(Vec::from).to_vec(),
    ))
}

/// What the field reports of one submission.
pub(crate) fn field_to_dict<'py>(
    py: Python<'py>,
    model: &str,
    method: &str,
    report: &FieldReport,
) -> PyResult<Bound<'py, PyDict>> {
    let figures = PyDict::new(py);
    for (figure, value) in report.figures.iter() {
        figures.set_item(figure.name(), value)?;
    }
    let rows = PyList::empty(py);
    for row in &report.rows {
        rows.append(dict!(py;
            "truth" => row.number,
            "type" => row.kind.map(SurfaceType::name),
            "size" => row.size,
            "stratum" => row.stratum.name(),
            "iou" => row.iou,
        ))?;
    }
    let scale = dict!(py;
        "normalisation" => report.scale.normalisation.name(),
        "epsilon" => report.scale.epsilon,
    );
    Ok(dict!(py;
        "model" => model,
        "method" => method,
        "scale" => scale,
        "figures" => figures,
        "types" => types(py, &report.types)?,
        "primitives" => rows,
    ))
}
