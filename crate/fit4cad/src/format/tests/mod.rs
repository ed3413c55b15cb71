//! Every quirk of real files, each by example.

mod cloud;
mod joining;
mod pieces;
mod primitives;
mod segments;
mod surfaces;
mod types;

use crate::diagnostics::Diagnostic;

const NONE: [String; 0] = [];

/// `line:column severity`, and what was found, of each diagnostic.
fn shown(diagnostics: &[Diagnostic]) -> Vec<String> {
    diagnostics
        .iter()
        .map(|diagnostic| {
            let place = diagnostic
                .position
                .map_or(String::new(), |at| format!("{}:{} ", at.line, at.column));
            format!("{place}{} {}", diagnostic.severity, diagnostic.found)
                .trim_end()
                .to_owned()
        })
        .collect()
}
