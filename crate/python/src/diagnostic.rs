//! What is wrong with an input, as dictionaries.

use fit4cad::diagnostics::{Diagnostic, OneLine, Position, Severity};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::dict::{dict, refused};

const SEVERITIES: [Severity; 3] = [Severity::Note, Severity::Warning, Severity::Error];

/// A finding with the keys of the command line's JSON.
pub(crate) fn to_dict<'py>(
    py: Python<'py>,
    diagnostic: &Diagnostic,
) -> PyResult<Bound<'py, PyDict>> {
    let dict = dict!(py;
        "severity" => diagnostic.severity.to_string(),
        "file" => &diagnostic.file,
    );
    if let Some(Position { line, column }) = diagnostic.position {
        dict.set_item("line", line)?;
        dict.set_item("column", column)?;
    }
    dict.set_item("message", &diagnostic.message)?;
    dict.set_item("found", &diagnostic.found)?;
    dict.set_item("expected", &diagnostic.expected)?;
    dict.set_item("hint", &diagnostic.hint)?;
    Ok(dict)
}

/// A finding as a compiler prints it, in one line whatever names and texts hold.
#[pyfunction]
#[pyo3(signature = (severity, file, position, message, found = "", expected = "", hint = ""))]
pub(crate) fn one_line(
    severity: &str,
    file: &str,
    position: Option<(u32, u32)>,
    message: &str,
    found: &str,
    expected: &str,
    hint: &str,
) -> PyResult<String> {
    let known = SEVERITIES
        .into_iter()
        .find(|known| known.to_string() == severity);
    let line = OneLine {
        severity: known.ok_or_else(|| refused(format!("there is no severity `{severity}`")))?,
        file,
        position: position.map(|(line, column)| Position { line, column }),
        message,
        found,
        expected,
        hint,
    };
    Ok(line.to_string())
}
