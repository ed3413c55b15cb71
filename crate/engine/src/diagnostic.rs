//! Diagnostics as plain objects.

use fit4cad::diagnostics;
use serde::Serialize;
use tsify::Tsify;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
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

/// One finding about an input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct DiagnosticInfo {
    /// How much it matters.
    pub severity: Severity,
    /// Path of the file as it was given.
    pub file: String,
    /// Line, from 1, where it is about one place.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub line: Option<u32>,
    /// Byte within the line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
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
