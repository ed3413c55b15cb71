//! Diagnostics as plain objects.

use fit4cad::diagnostics;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// Worth knowing; nothing is lost.
    Note,
    /// Something was repaired or left out; the rest is used.
    Warning,
    /// Something that was needed could not be used.
    Error,
}

impl From<diagnostics::Severity> for Severity {
    fn from(severity: diagnostics::Severity) -> Self {
        match severity {
            diagnostics::Severity::Note => Self::Note,
            diagnostics::Severity::Warning => Self::Warning,
            diagnostics::Severity::Error => Self::Error,
        }
    }
}

impl From<Severity> for diagnostics::Severity {
    fn from(severity: Severity) -> Self {
        match severity {
            Severity::Note => Self::Note,
            Severity::Warning => Self::Warning,
            Severity::Error => Self::Error,
        }
    }
}

/// One finding about an input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, Tsify)]
pub struct DiagnosticInfo {
    /// How much it matters.
    pub severity: Severity,
    /// Path of the file as it was given.
    pub file: String,
    /// Line, from 1, where it is about one place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub line: Option<u32>,
    /// Byte within the line, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub column: Option<u32>,
    /// What is wrong.
    pub message: String,
    /// The text found, shortened; may be empty.
    pub found: String,
    /// What would have been right; may be empty.
    pub expected: String,
    /// What to do; may be empty.
    pub hint: String,
}

impl From<&diagnostics::Diagnostic> for DiagnosticInfo {
    fn from(diagnostic: &diagnostics::Diagnostic) -> Self {
        Self {
            severity: diagnostic.severity.into(),
            file: diagnostic.file.clone(),
            line: diagnostic.position.map(|position| position.line),
            column: diagnostic.position.map(|position| position.column),
            message: diagnostic.message.clone(),
            found: diagnostic.found.clone(),
            expected: diagnostic.expected.clone(),
            hint: diagnostic.hint.clone(),
        }
    }
}

/// Findings as a compiler prints them, a line each, whatever names and texts hold:
/// `file:line:column: severity: message (found …, expected …). hint`.
///
/// # Errors
/// Only if the argument is not of the declared type.
#[wasm_bindgen(js_name = oneLines)]
pub fn one_lines(diagnostics: Vec<Ts<DiagnosticInfo>>) -> Result<Vec<String>, JsError> {
    let line = |diagnostic: &Ts<DiagnosticInfo>| {
        let it = diagnostic.to_rust()?;
        let place = it.line.zip(it.column);
        let line = diagnostics::OneLine {
            severity: it.severity.into(),
            file: &it.file,
            position: place.map(|(line, column)| diagnostics::Position { line, column }),
            message: &it.message,
            found: &it.found,
            expected: &it.expected,
            hint: &it.hint,
        };
        Ok(line.to_string())
    };
    diagnostics.iter().map(line).collect()
}
