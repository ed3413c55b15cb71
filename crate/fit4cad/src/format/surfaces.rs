//! Reading `PCi_parametric.txt` and `PCi_implicit.txt`: one `PrimitiveK:=[Type, [v1 v2 …]];` per
//! surface.

use super::encoding;
use super::entry::{NOT_CLOSED, at_keyword, next_header};
use super::findings::{Findings, Kind, is_blank, open};
use super::number;
use super::scan::{self, Cursor, is_remark, is_separator, is_whitespace};
use crate::diagnostics::{Diagnostic, Position, Severity, Subject};
use crate::model::Coefficients;
use crate::surface::{Form, SurfaceType};

/// One entry of a surface file.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceEntry {
    /// The K of `PrimitiveK`.
    pub number: u32,
    /// The type, if it is one of the five.
    pub kind: Option<SurfaceType>,
    /// Its vector: given or malformed, never missing.
    pub coefficients: Coefficients,
    /// Where the entry begins.
    pub position: Position,
}

/// What a surface file holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum SurfaceFile {
    /// There is no file, or nothing in it: conversion from the other form takes its place.
    #[default]
    Absent,
    /// Its entries, in their order.
    Entries(Vec<SurfaceEntry>),
}

/// Reads a surface file. Linear in its length, one pass.
///
/// An entry whose vector has the wrong length, is all zeros or holds something that is no finite
/// number is malformed; one of a type outside the five has no usable vector either.
pub fn read_surfaces(file: &str, bytes: &[u8], form: Form) -> (SurfaceFile, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    let (mut findings, mut cursor) = match open(file, bytes) {
        Ok(opened) => opened,
        Err(diagnostics) => return (SurfaceFile::Entries(Vec::new()), diagnostics),
    };
    if is_blank(cursor.clone()) {
        findings.add_whole(&EMPTY, String::new());
        return (SurfaceFile::Absent, findings.finish());
    }
    let mut entries = Vec::new();
    while let Some(header) = next_header(&mut cursor, &mut findings, entries.len()) {
        let position = findings.position(header.at);
        let raw = RawEntry::read(&mut cursor, &mut findings);
        let (kind, coefficients) = raw.judge(header.at, form, cursor.bytes(), &mut findings);
        entries.push(SurfaceEntry {
            number: header.number,
            kind,
            coefficients,
            position,
        });
    }
    if entries.is_empty() {
        findings.add_whole(&NO_ENTRY, String::new());
    }
    (SurfaceFile::Entries(entries), findings.finish())
}

const EMPTY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Warning,
    message: "The surface file is empty",
    expected: "`PrimitiveK:=[Type, [v1 v2 …]];`",
    hint: "The other surface file is used in its place, if there is one",
};
const NO_ENTRY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file holds no surface that could be read",
    expected: "`PrimitiveK:=[Type, [v1 v2 …]];`",
    hint: "",
};
const TYPE_TWICE: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "The type is written twice",
    expected: "`PrimitiveK:=[Type, [v1 v2 …]];`",
    hint: "It is read once",
};
const NO_TYPE: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Error,
    message: "A surface has no type and is left out",
    expected: "Plane, Cylinder, Cone, Sphere or Torus",
    hint: "",
};
const OTHER_TYPE: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Warning,
    message: "A surface is of a type outside the benchmark and is left out",
    expected: "Plane, Cylinder, Cone, Sphere or Torus",
    hint: "The points of the primitive still count",
};
const WRONG_LENGTH: Kind = Kind {
    subject: Subject::Vector,
    severity: Severity::Error,
    message: "A vector has the wrong length; the entry is left out",
    expected: "",
    hint: "",
};
const NOT_A_NUMBER: Kind = Kind {
    subject: Subject::Vector,
    severity: Severity::Error,
    message: "A vector holds something that is no finite number; the entry is left out",
    expected: "a finite decimal number",
    hint: "",
};
const ALL_ZERO: Kind = Kind {
    subject: Subject::Vector,
    severity: Severity::Error,
    message: "Every number of a vector is zero; the entry is left out",
    expected: "the coefficients of a surface",
    hint: "",
};
const CUT_OFF: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file ends within an entry, which is left out",
    expected: "`]];`",
    hint: "Fetch the file again",
};

/// No vector is longer than a torus's implicit one; numbers beyond are only counted.
const MAX_VALUES: usize = 35;

/// The words and numbers of an entry as they come, brackets and commas aside.
#[derive(Default)]
struct RawEntry<'a> {
    /// The first word and its offset.
    name: Option<(&'a [u8], usize)>,
    values: Vec<f64>,
    count: usize,
    /// Where something that is neither type nor finite number stands.
    wrong: Option<usize>,
    cut_off: Option<usize>,
}

impl<'a> RawEntry<'a> {
    /// Reads from behind the first bracket to behind the one that closes the vector. Brackets
    /// beyond are left to whoever looks for the next entry.
    fn read(cursor: &mut Cursor<'a>, findings: &mut Findings<'_>) -> Self {
        let mut raw = Self::default();
        loop {
            let at = cursor.at;
            match cursor.peek() {
                Some(b']') => {
                    cursor.at += 1;
                    return raw;
                }
                Some(b'[' | b',' | b'\'' | b'"') => cursor.at += 1,
                Some(byte) if is_whitespace(byte) => cursor.at += 1,
                Some(byte) if is_remark(byte) => cursor.skip_line(),
                Some(b';') => {
                    findings.add(&NOT_CLOSED, at);
                    return raw;
                }
                Some(_) if at_keyword(cursor) => {
                    findings.add(&NOT_CLOSED, at);
                    return raw;
                }
                Some(b'.') if cursor.at_continuation() => cursor.skip_while(|byte| byte == b'.'),
                Some(byte) if byte.is_ascii_alphabetic() && raw.count == 0 => {
                    raw.word(cursor.word(), at, findings);
                }
                Some(_) => raw.number(cursor),
                None => {
                    raw.cut_off = Some(at);
                    return raw;
                }
            }
        }
    }

    fn word(&mut self, word: &'a [u8], at: usize, findings: &mut Findings<'_>) {
        match self.name {
            None => self.name = Some((word, at)),
            Some((name, _)) if name.eq_ignore_ascii_case(word) => findings.add(&TYPE_TWICE, at),
            Some(_) => {
                self.wrong.get_or_insert(at);
            }
        }
    }

    fn number(&mut self, cursor: &mut Cursor<'_>) {
        let at = cursor.at;
        self.count += 1;
        match number::read(cursor.bytes(), at) {
            Some((value, end))
                if cursor
                    .bytes()
                    .get(end)
                    .is_none_or(|&next| is_separator(next)) =>
            {
                if self.values.len() < MAX_VALUES {
                    self.values.push(value);
                }
                cursor.at = end;
            }
            _ => {
                self.wrong.get_or_insert(at);
                cursor.skip_token();
            }
        }
    }

    /// The type and vector, with a finding where there is something wrong.
    fn judge(
        self,
        header: usize,
        form: Form,
        bytes: &[u8],
        findings: &mut Findings<'_>,
    ) -> (Option<SurfaceType>, Coefficients) {
        let Some((name, name_at)) = self.name else {
            findings.add(&NO_TYPE, header);
            return (None, Coefficients::Malformed);
        };
        let Some(kind) = SurfaceType::from_name(name) else {
            findings.add_found(&OTHER_TYPE, name_at, || scan::token(bytes, name_at));
            return (None, Coefficients::Malformed);
        };
        let expected = form.len(kind);
        if let Some(at) = self.cut_off {
            findings.add(&CUT_OFF, at);
        } else if let Some(at) = self.wrong {
            findings.add_found(&NOT_A_NUMBER, at, || scan::token(bytes, at));
        } else if self.count != expected {
            let count = self.count;
            findings.add_with(&WRONG_LENGTH, name_at, || {
                (
                    format!("{count} numbers"),
                    format!("{expected} for a {kind}"),
                )
            });
        } else if self.values.iter().all(|&value| value == 0.0) {
            findings.add_found(&ALL_ZERO, name_at, String::new);
        } else {
            return (Some(kind), Coefficients::Given(self.values));
        }
        (Some(kind), Coefficients::Malformed)
    }
}
