//! What reading and the structure of a truth already tell.

use std::collections::BTreeSet;

use super::{Check, Finding};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::model::{Coefficients, Primitive, Segmentation};

/// The diagnostics as findings; vectors that are no surface of their type are left to the
/// measurements, which look at both forms.
pub(super) fn findings(diagnostics: &[Diagnostic]) -> Vec<Finding> {
    let kept = diagnostics
        .iter()
        .filter(|diagnostic| diagnostic.subject != Subject::Family);
    kept.map(|diagnostic| Finding {
        primitive: diagnostic.primitive,
        check: diagnostic.subject.into(),
        severity: diagnostic.severity,
        value: None,
        limit: None,
        message: message(diagnostic),
        hint: diagnostic.hint.clone(),
    })
    .collect()
}

/// Place, message and what was found, in one line.
fn message(diagnostic: &Diagnostic) -> String {
    let place = match diagnostic.position {
        Some(position) => format!(":{}:{}", position.line, position.column),
        None => String::new(),
    };
    let found = if diagnostic.found.is_empty() {
        String::new()
    } else {
        format!(" (found {})", diagnostic.found)
    };
    let Diagnostic { file, message, .. } = diagnostic;
    format!("{message}{found}: {file}{place}")
}

/// Adds what the segmentation itself shows and no finding says yet: of the same diagnostics only the
/// first are kept, and a truth that was not read from files has none.
pub(super) fn add_structural(truth: &Segmentation, findings: &mut Vec<Finding>) {
    let told: BTreeSet<(Option<u32>, Check)> = findings
        .iter()
        .map(|finding| (finding.primitive, finding.check))
        .collect();
    let mut numbers: Vec<u32> = truth.primitives.iter().map(|p| p.number).collect();
    numbers.sort_unstable();
    let repeated = numbers
        .chunk_by(|a, b| a == b)
        .filter_map(|same| match same {
            [number, _, ..] => Some(Problem {
                number: *number,
                check: Check::Numbering,
                severity: Severity::Warning,
                message: format!("{} primitives have the number {number}", same.len()),
            }),
            _ => None,
        });
    let problems = repeated.chain(truth.primitives.iter().flat_map(problems));
    // An entry of an unknown type is as good as none, which need not be said twice.
    let untold = problems.filter(|problem| {
        let is_told = |check| told.contains(&(Some(problem.number), check));
        let of_unknown_type = problem.check == Check::Vector && is_told(Check::Type);
        !(is_told(problem.check) || of_unknown_type)
    });
    findings.extend(untold.map(|problem| Finding {
        primitive: Some(problem.number),
        check: problem.check,
        severity: problem.severity,
        value: None,
        limit: None,
        message: problem.message,
        hint: String::new(),
    }));
}

/// What the segmentation shows about one primitive.
struct Problem {
    number: u32,
    check: Check,
    severity: Severity,
    message: String,
}

fn problems(primitive: &Primitive) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut add = |check, severity, message: String| {
        problems.push(Problem {
            number: primitive.number,
            check,
            severity,
            message,
        });
    };
    if primitive.points.is_empty() {
        add(
            Check::Index,
            Severity::Warning,
            "The primitive has no points".to_owned(),
        );
    }
    let (parametric, implicit) = (&primitive.parametric, &primitive.implicit);
    for (name, vector) in [("parametric", parametric), ("implicit", implicit)] {
        match (vector, primitive.kind) {
            (Coefficients::Malformed, None) => {
                let message = format!("The {name} form is of a type outside the five families");
                add(Check::Type, Severity::Warning, message);
            }
            (Coefficients::Malformed, Some(_)) => {
                let message = format!("The {name} vector cannot be used");
                add(Check::Vector, Severity::Error, message);
            }
            (Coefficients::Missing, _) => {
                let message = format!("There is no {name} form");
                add(Check::Vector, Severity::Note, message);
            }
            (Coefficients::Given(_), _) => {}
        }
    }
    problems
}
