//! Reading `PCi_primitives.txt`: one `PrimitiveK:=[i1 i2 …];` per primitive.

use super::encoding;
use super::entry::{NOT_CLOSED, at_keyword, next_header};
use super::findings::{Findings, Kind, is_blank, open};
use super::limits::MAX_INDICES;
use super::number;
use super::scan::{self, Cursor, is_remark, is_separator, is_whitespace};
use crate::cloud::{Numbering, PointNumber};
use crate::diagnostics::{Diagnostic, Position, Severity, Subject};

/// One entry of a primitives file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointList {
    /// The K of `PrimitiveK`.
    pub number: u32,
    /// Indices into the cloud, counted from 0, ascending, each once.
    pub points: Vec<u32>,
    /// Where the entry begins.
    pub position: Position,
}

/// Reads a primitives file against the numbering of its cloud. Linear in its length (but for
/// sorting lists that are not ascending), one pass.
///
/// An index that is no point of the cloud, or listed twice by one primitive, is a finding and is
/// left out. That several primitives list a point is legal.
pub fn read_primitives(
    file: &str,
    bytes: &[u8],
    numbering: &Numbering,
) -> (Vec<PointList>, Vec<Diagnostic>) {
    read_counted(file, bytes, numbering, 1)
}

/// As [`read_primitives`], of a file whose indices count from 0 or 1.
pub(super) fn read_counted(
    file: &str,
    bytes: &[u8],
    numbering: &Numbering,
    first: u8,
) -> (Vec<PointList>, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    let (mut findings, mut cursor) = match open(file, bytes) {
        Ok(opened) => opened,
        Err(diagnostics) => return (Vec::new(), diagnostics),
    };
    let mut lists = Vec::new();
    if is_blank(cursor.clone()) {
        findings.add_whole(&EMPTY, String::new());
        return (lists, findings.finish());
    }
    let mut reader = ListReader {
        numbering,
        before: u64::from(first == 0),
        last_listed_by: vec![0; numbering.rows()],
        lists: 0,
        indices: 0,
    };
    while let Some(header) = next_header(&mut cursor, &mut findings, lists.len()) {
        let position = findings.position(header.at);
        let mut points = reader.read(&mut cursor, &mut findings);
        points.shrink_to_fit();
        if points.is_empty() {
            findings.add(&NO_INDEX, header.at);
        }
        lists.push(PointList {
            number: header.number,
            points,
            position,
        });
        if reader.indices >= MAX_INDICES {
            findings.add(&TOO_MANY, cursor.at);
            break;
        }
    }
    if lists.is_empty() {
        findings.add_whole(&NO_ENTRY, String::new());
    }
    (lists, findings.finish())
}

const EMPTY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Warning,
    message: "The primitives file is empty",
    expected: "`PrimitiveK:=[i1 i2 …];`",
    hint: "It counts as a result without primitives",
};
const NO_ENTRY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file holds no primitive that could be read",
    expected: "`PrimitiveK:=[i1 i2 …];`",
    hint: "",
};
const NO_INDEX: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Warning,
    message: "A primitive has no points",
    expected: "at least one index",
    hint: "",
};
const BAD_INDEX: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Error,
    message: "This is not a point index and was left out",
    expected: "a whole number from 1 to the number of points",
    hint: "Separate indices by blanks",
};
const OUTSIDE: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Error,
    message: "A primitive lists a point that the cloud does not have",
    expected: "",
    hint: "Check that the file belongs to this cloud, and from what its indices count",
};
const BROKEN_POINT: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Warning,
    message: "A primitive lists a point that could not be read from the cloud",
    expected: "",
    hint: "See the findings about the cloud file",
};
const TWICE: Kind = Kind {
    subject: Subject::Duplicate,
    severity: Severity::Warning,
    message: "A primitive lists a point more than once",
    expected: "each index once",
    hint: "It counts once",
};
const CUT_OFF: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file ends within a list",
    expected: "`];`",
    hint: "The last index may be cut short and is left out; fetch the file again",
};
const TOO_MANY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file lists too many points; the rest was not read",
    expected: "at most 50,000,000 indices",
    hint: "",
};

/// Reads the lists of one file.
struct ListReader<'n> {
    numbering: &'n Numbering,
    /// What to add to an index for the number of its row.
    before: u64,
    /// For each index of the cloud the list (from 1) that named it last, to find repetitions as
    /// they are read.
    last_listed_by: Vec<u32>,
    lists: u32,
    indices: usize,
}

impl ListReader<'_> {
    /// Reads from behind the bracket to behind the closing one.
    fn read(&mut self, cursor: &mut Cursor<'_>, findings: &mut Findings<'_>) -> Vec<u32> {
        self.lists += 1;
        let mut points = Vec::new();
        let mut ascending = true;
        loop {
            let at = cursor.at;
            match cursor.peek() {
                Some(b' ' | b',') => cursor.at += 1,
                Some(b'0'..=b'9') => {
                    let number = self.index(cursor, findings);
                    if cursor.peek().is_none() {
                        findings.add(&CUT_OFF, at);
                        break;
                    }
                    if let Some(index) = number {
                        ascending &= points.last().is_none_or(|&last| last < index);
                        points.push(index);
                    }
                    if self.indices >= MAX_INDICES {
                        break;
                    }
                }
                Some(b']') => {
                    cursor.at += 1;
                    break;
                }
                Some(byte) if is_whitespace(byte) => cursor.at += 1,
                Some(byte) if is_remark(byte) => cursor.skip_line(),
                Some(b';') if !column_goes_on(cursor) => {
                    findings.add(&NOT_CLOSED, at);
                    break;
                }
                Some(b';') => cursor.at += 1,
                Some(b'.') if cursor.at_continuation() => cursor.skip_while(|byte| byte == b'.'),
                Some(_) if at_keyword(cursor) => {
                    findings.add(&NOT_CLOSED, at);
                    break;
                }
                Some(_) => {
                    let bytes = cursor.bytes();
                    findings.add_found(&BAD_INDEX, at, || scan::token(bytes, at));
                    cursor.skip_token();
                }
                None => {
                    findings.add(&NOT_CLOSED, at);
                    break;
                }
            }
        }
        if !ascending {
            points.sort_unstable();
        }
        points
    }

    /// Reads the number that begins here; its index if the cloud has the point and this list has
    /// not named it yet.
    #[inline]
    fn index(&mut self, cursor: &mut Cursor<'_>, findings: &mut Findings<'_>) -> Option<u32> {
        let at = cursor.at;
        let bytes = cursor.bytes();
        let mut number = 0u64;
        while let Some(digit @ b'0'..=b'9') = cursor.peek() {
            number = number
                .saturating_mul(10)
                .saturating_add(u64::from(digit - b'0'));
            cursor.at += 1;
        }
        // At the end of the file it may be any number, cut short.
        let next = cursor.peek()?;
        if !is_separator(next) {
            // Programs that print doubles write large indices as 1e+05 or 7.0.
            match number::read(bytes, at) {
                Some((value, end))
                    if value.fract() == 0.0
                        && value < 1e15
                        && bytes.get(end).is_none_or(|&next| is_separator(next)) =>
                {
                    number = value as u64;
                    cursor.at = end;
                }
                _ => {
                    findings.add_found(&BAD_INDEX, at, || scan::token(bytes, at));
                    cursor.skip_token();
                    return None;
                }
            }
        }
        self.indices += 1;
        match self.numbering.resolve(number.saturating_add(self.before)) {
            PointNumber::Index(index) => {
                let last = self.last_listed_by.get_mut(index as usize)?;
                if *last == self.lists {
                    findings.add_found(&TWICE, at, || number.to_string());
                    return None;
                }
                *last = self.lists;
                Some(index)
            }
            PointNumber::Broken => {
                findings.add_found(&BROKEN_POINT, at, || number.to_string());
                None
            }
            PointNumber::Outside => {
                let (rows, before) = (self.numbering.rows() as u64, self.before);
                findings.add_with(&OUTSIDE, at, || {
                    let range = format!("{} to {}", 1 - before, rows.saturating_sub(before));
                    (scan::token(bytes, at), range)
                });
                None
            }
        }
    }
}

/// Whether a semicolon separates the rows of a MATLAB column rather than ending the entry.
fn column_goes_on(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.at += 1;
    ahead.skip_whitespace();
    ahead.peek().is_some_and(|next| next.is_ascii_digit())
}
