//! Joining point lists and surfaces into a [`Segmentation`].

use super::findings::{Findings, Kind};
use super::primitives::PointList;
use super::surfaces::{SurfaceEntry, SurfaceFile};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::model::{Coefficients, Primitive, Segmentation};
use crate::sorting::sort_by;
use crate::surface::{Conversion, Form, Surface};

/// What was read from a file, and the file's path for the diagnostics.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Named<'a, T> {
    /// Path as it was given; empty where there is no file.
    pub file: &'a str,
    /// What it holds.
    pub content: T,
}

/// Joins the point lists of one method with its surfaces.
///
/// A surface file's entries belong to the primitives of the same number if every one of its
/// numbers is a primitive's; else to the primitives at the same position if there are as many;
/// else the file cannot be used. Where one surface file is absent or empty the other is converted
/// in its place; where it is there, an entry that is missing or malformed in it stays so.
///
/// O(p log p) for p primitives.
pub fn assemble(
    lists: Named<'_, Vec<PointList>>,
    parametric: Named<'_, SurfaceFile>,
    implicit: Named<'_, SurfaceFile>,
) -> (Segmentation, Vec<Diagnostic>) {
    let mut parametric = FormColumn::new(Form::Parametric, &lists, parametric);
    let mut implicit = FormColumn::new(Form::Implicit, &lists, implicit);
    let primitives = lists
        .content
        .into_iter()
        .enumerate()
        .map(|(at, list)| join(list, at, &mut parametric, &mut implicit))
        .collect();
    let mut diagnostics = parametric.findings.finish();
    diagnostics.extend(implicit.findings.finish());
    (Segmentation { primitives }, diagnostics)
}

const UNMATCHED: Kind = Kind {
    subject: Subject::Numbering,
    severity: Severity::Error,
    message: "It is unclear which surface belongs to which primitive, so the file is not used",
    expected: "the primitives' numbers, or as many surfaces as primitives",
    hint: "Give each surface the number of its primitive",
};
const BY_POSITION: Kind = Kind {
    subject: Subject::Numbering,
    severity: Severity::Note,
    message: "Surfaces are numbered differently from the primitives and are matched by position",
    expected: "",
    hint: "",
};
const REPEATED: Kind = Kind {
    subject: Subject::Numbering,
    severity: Severity::Warning,
    message: "A second surface for the same primitive is not used",
    expected: "each number once",
    hint: "",
};
const MISSING: Kind = Kind {
    subject: Subject::Vector,
    severity: Severity::Note,
    message: "The file has no surface for a primitive",
    expected: "",
    hint: "Its figures are left out",
};
const TYPES_DIFFER: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Warning,
    message: "The two surface files give a primitive different types",
    expected: "",
    hint: "The parametric file decides",
};

const MISFIT: Kind = Kind {
    subject: Subject::Family,
    severity: Severity::Warning,
    message: "A vector is not quite a surface of its type",
    expected: "",
    hint: "The nearest such surface is used for distances",
};
const NO_MEMBER: Kind = Kind {
    subject: Subject::Family,
    severity: Severity::Error,
    message: "A vector is no surface of its type",
    expected: "",
    hint: "Its distances are left out",
};

/// One surface file, its entries brought into the order of the primitives.
struct FormColumn<'a> {
    form: Form,
    findings: Findings<'a>,
    /// Whether there is a file with something in it.
    present: bool,
    entries: Vec<Option<SurfaceEntry>>,
}

impl<'a> FormColumn<'a> {
    fn new(
        form: Form,
        lists: &Named<'_, Vec<PointList>>,
        surfaces: Named<'a, SurfaceFile>,
    ) -> Self {
        let mut findings = Findings::new(surfaces.file, &[]);
        let (present, entries) = match surfaces.content {
            SurfaceFile::Absent => (false, Vec::new()),
            SurfaceFile::Entries(entries) => (
                true,
                match align(&lists.content, entries, &mut findings) {
                    Ok(entries) => entries,
                    Err(found) => {
                        let primitives = lists.content.len();
                        findings.add_whole(
                            &UNMATCHED,
                            format!("{found}; primitives in {}: {primitives}", lists.file),
                        );
                        Vec::new()
                    }
                },
            ),
        };
        for (list, entry) in lists.content.iter().zip(&entries) {
            if entry.is_none() {
                findings.about(Some(list.number));
                findings.add_whole(&MISSING, format!("none for Primitive{}", list.number));
            }
        }
        Self {
            form,
            findings,
            present,
            entries,
        }
    }

    /// The surface an entry stands for; a finding where its vector is no member of its family.
    fn surface(&mut self, number: u32, entry: Option<&SurfaceEntry>) -> Option<Surface> {
        let entry = entry?;
        self.findings.about(Some(number));
        let (kind, values) = (entry.kind?, entry.coefficients.values()?);
        match Surface::from_form(self.form, kind, values) {
            Ok(Conversion { surface, misfit }) => {
                if misfit > Conversion::TOLERANCE {
                    self.findings.add_at(&MISFIT, entry.position, || {
                        let found = format!(
                            "Primitive{}, {:.3} % of its size away from the nearest {kind}",
                            entry.number,
                            misfit * 100.0
                        );
                        (
                            found,
                            format!("at most {} %", Conversion::TOLERANCE * 100.0),
                        )
                    });
                }
                Some(surface)
            }
            Err(error) => {
                self.findings.add_at(&NO_MEMBER, entry.position, || {
                    (format!("Primitive{}: {error}", entry.number), String::new())
                });
                None
            }
        }
    }

    fn take(&mut self, at: usize) -> Option<SurfaceEntry> {
        self.entries.get_mut(at).and_then(Option::take)
    }
}

/// For each list its entry; what stands against it where there is no telling.
fn align(
    lists: &[PointList],
    entries: Vec<SurfaceEntry>,
    findings: &mut Findings<'_>,
) -> Result<Vec<Option<SurfaceEntry>>, String> {
    // Positions by number, then by position: the k-th list of a number gets its k-th surface.
    let mut by_number: Vec<(u32, usize)> = lists
        .iter()
        .enumerate()
        .map(|(at, list)| (list.number, at))
        .collect();
    sort_by(&mut by_number, |one, other| one.cmp(other));
    let first_of = |number: u32| by_number.partition_point(|&(other, _)| other < number);
    let is_listed = |entry: &SurfaceEntry| {
        by_number
            .get(first_of(entry.number))
            .is_some_and(|&(number, _)| number == entry.number)
    };

    let Some(stranger) = entries.iter().find(|entry| !is_listed(entry)) else {
        let mut aligned: Vec<Option<SurfaceEntry>> = vec![None; lists.len()];
        let mut used = vec![0usize; by_number.len()];
        for entry in entries {
            let first = first_of(entry.number);
            let Some(taken) = used.get_mut(first) else {
                continue;
            };
            let slot = by_number
                .get(first + *taken)
                .filter(|&&(number, _)| number == entry.number)
                .and_then(|&(_, at)| aligned.get_mut(at));
            *taken += 1;
            match slot {
                Some(slot) => *slot = Some(entry),
                None => {
                    findings.about(Some(entry.number));
                    findings.add_at(&REPEATED, entry.position, || {
                        (
                            format!("Primitive{} again", entry.number),
                            REPEATED.expected.to_owned(),
                        )
                    });
                }
            }
        }
        findings.about(None);
        return Ok(aligned);
    };
    if entries.len() == lists.len() {
        let found = format!("Primitive{}, which lists no points", stranger.number);
        findings.add_at(&BY_POSITION, stranger.position, || (found, String::new()));
        return Ok(entries.into_iter().map(Some).collect());
    }
    Err(format!(
        "{} surfaces, among them Primitive{}, which lists no points",
        entries.len(),
        stranger.number
    ))
}

fn join(
    list: PointList,
    at: usize,
    parametric_file: &mut FormColumn<'_>,
    implicit_file: &mut FormColumn<'_>,
) -> Primitive {
    let (parametric, implicit) = (parametric_file.take(at), implicit_file.take(at));
    let kind_of = |entry: &Option<SurfaceEntry>| entry.as_ref().and_then(|entry| entry.kind);
    let (first, second) = (kind_of(&parametric), kind_of(&implicit));
    if let (Some(first), Some(second), Some(entry)) = (first, second, &implicit)
        && first != second
    {
        implicit_file.findings.about(Some(list.number));
        implicit_file
            .findings
            .add_at(&TYPES_DIFFER, entry.position, || {
                (
                    second.to_string(),
                    format!("{first}, as in the parametric file"),
                )
            });
    }
    let (has_parametric, has_implicit) = (parametric_file.present, implicit_file.present);
    let surface = if has_parametric {
        parametric_file.surface(list.number, parametric.as_ref())
    } else {
        implicit_file.surface(list.number, implicit.as_ref())
    };
    let coefficients = |entry: Option<SurfaceEntry>| {
        entry.map_or(Coefficients::Missing, |entry| entry.coefficients)
    };
    let (mut parametric, mut implicit) = (coefficients(parametric), coefficients(implicit));
    let converted = |from: &Coefficients, convert: fn(&Surface) -> Vec<f64>| match (from, &surface)
    {
        (Coefficients::Missing, _) => Coefficients::Missing,
        (_, Some(surface)) => Coefficients::Given(convert(surface)),
        (_, None) => Coefficients::Malformed,
    };
    if !has_parametric {
        parametric = converted(&implicit, Surface::to_parametric);
    } else if !has_implicit {
        implicit = converted(&parametric, Surface::to_implicit);
    }
    Primitive {
        number: list.number,
        points: list.points,
        kind: first.or(second),
        surface,
        parametric,
        implicit,
    }
}
