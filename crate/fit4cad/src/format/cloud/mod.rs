//! Reading a cloud: the benchmark's `PCi.txt` (`Points:=[`, one `[x, y, z], ` per line, ` ];`), or a
//! table of any kind (`table`).
//!
//! Rows in the paper's form take [`paper_row`], which looks at each byte once and allocates
//! nothing; any other row is read again, slowly, by [`OddRow`]. On one core of an AMD EPYC that is
//! 750 MB/s natively; coordinates of 17 digits, which the standard library rounds, take 270 MB/s
//! (`examples/reading_speed.rs`).

mod columns;
pub(super) mod kinds;
mod row;
mod table;

pub(super) use columns::Columns;

use kinds::{
    AFTER_END, BROKEN_ROW, COUNT, CUT_OFF, EMPTY, JUNK, NO_BRACKETS, NO_COMMAS, NO_HEADER,
    NO_POINTS, NO_ROW_END, NOT_CLOSED, OTHER_FILE, TOO_FAR, TOO_MANY,
};
use row::{OddRow, paper_row};

use super::encoding;
use super::findings::{Findings, is_blank, open};
use super::labels::Segment;
use super::limits::MAX_POINTS;
use super::number;
use super::scan::{self, Cursor, is_remark, is_separator, is_whitespace};
use crate::cloud::{Cloud, LARGEST, Numbering, Point};
use crate::diagnostics::Diagnostic;

/// What a file of points holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CloudFile {
    /// The points.
    pub cloud: Cloud,
    /// Which of them belong together, where the file says so.
    pub segments: Option<Vec<Segment>>,
}

/// Reads a cloud file of text. Linear in its length, one pass.
///
/// The paper's form is read as far as its meaning is plain (MATLAB's `Points=[1 2 3; …]`, a missing
/// header or end, remarks) with a finding. Anything else is a table: a point a line, its numbers
/// separated by blanks, tabs, commas or semicolons, with decimal commas where they can be nothing
/// else; a line of names, a number of points and remarks may come first, other columns after the
/// coordinates. A row that is not three finite numbers keeps its number and has no point
/// ([`Cloud::numbering`]); what comes before the first row has no number.
pub fn read_cloud(file: &str, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    // Point2CAD's ending says what the last column is.
    let ending = file.rsplit_once('.').map(|(_, ending)| ending);
    let labelled = ending.is_some_and(|ending| ending.eq_ignore_ascii_case("xyzc"));
    read_cloud_with(file, bytes, labelled)
}

/// As [`read_cloud`], of a file that is known to have labels, or not.
pub(super) fn read_cloud_with(
    file: &str,
    bytes: &[u8],
    labelled: bool,
) -> (CloudFile, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    match open(file, bytes) {
        Ok((findings, cursor)) => read_text(labelled, findings, cursor),
        Err(diagnostics) => (CloudFile::default(), diagnostics),
    }
}

fn read_text(
    labelled: bool,
    findings: Findings<'_>,
    cursor: Cursor<'_>,
) -> (CloudFile, Vec<Diagnostic>) {
    if is_blank(cursor.clone()) || is_in_the_papers_form(cursor.clone()) {
        return read_papers_form(findings, cursor);
    }
    table::read(findings, cursor, labelled)
}

/// Reads a cloud in the paper's form alone.
pub(super) fn read_own(file: &str, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    match open(file, bytes) {
        Ok((findings, cursor)) => read_papers_form(findings, cursor),
        Err(diagnostics) => (CloudFile::default(), diagnostics),
    }
}

/// Whether a text is in the paper's form, or is none that could be read in any.
pub(super) fn is_own(file: &str, bytes: &[u8]) -> bool {
    let bytes = &*encoding::utf8(bytes);
    open(file, bytes).map_or(true, |(_, cursor)| {
        is_blank(cursor.clone()) || is_in_the_papers_form(cursor)
    })
}

fn read_papers_form(
    mut findings: Findings<'_>,
    cursor: Cursor<'_>,
) -> (CloudFile, Vec<Diagnostic>) {
    if is_blank(cursor.clone()) {
        findings.add_whole(&EMPTY, String::new());
        return (CloudFile::default(), findings.finish());
    }
    let (cloud, diagnostics) = Reader::new(findings, cursor).read();
    let file = CloudFile {
        cloud,
        segments: None,
    };
    (file, diagnostics)
}

/// Whether the first thing in a text, remarks and a number of points aside, is a bracket, or a word
/// by which one of the benchmark's files begins.
fn is_in_the_papers_form(mut cursor: Cursor<'_>) -> bool {
    loop {
        cursor.skip_whitespace();
        match cursor.peek() {
            Some(b'[') => return true,
            Some(byte) if is_remark(byte) => cursor.skip_line(),
            Some(b'0'..=b'9') if at_count(&cursor) => cursor.skip_line(),
            Some(byte) if byte.is_ascii_alphabetic() => {
                let word = cursor.word();
                let keyword = word.get(..9).unwrap_or(word);
                cursor.skip_while(|byte| is_whitespace(byte) || matches!(byte, b':' | b'='));
                return word.eq_ignore_ascii_case(b"points") && cursor.peek() == Some(b'[')
                    || keyword.eq_ignore_ascii_case(b"primitive");
            }
            _ => return false,
        }
    }
}

/// Whether a line begins here that holds one whole number and nothing else.
fn at_count(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.skip_while(|byte| byte.is_ascii_digit());
    ahead.skip_while(|byte| matches!(byte, b' ' | b'\t'));
    matches!(ahead.peek(), Some(b'\n' | b'\r'))
}

/// Rows read before the length of the rest is estimated from them.
const ROWS_TO_JUDGE_BY: usize = 1024;

struct Reader<'a> {
    findings: Findings<'a>,
    cursor: Cursor<'a>,
    points: Vec<Point>,
    broken: Vec<u32>,
    /// Whether the header's bracket, or what stands for it, has been passed.
    open: bool,
}

impl<'a> Reader<'a> {
    fn new(findings: Findings<'a>, cursor: Cursor<'a>) -> Self {
        Self {
            findings,
            cursor,
            points: Vec::new(),
            broken: Vec::new(),
            open: false,
        }
    }

    fn read(mut self) -> (Cloud, Vec<Diagnostic>) {
        self.read_rows();
        if self.points.is_empty() {
            self.findings.add_whole(&NO_POINTS, String::new());
        }
        // The first rows may be shorter than the others, and the guess by them too large.
        self.points.shrink_to_fit();
        let rows = self.rows();
        let numbering = Numbering::with_broken(rows, self.broken);
        (
            Cloud::numbered(self.points, numbering),
            self.findings.finish_rows(rows),
        )
    }

    fn read_rows(&mut self) {
        loop {
            self.cursor
                .skip_while(|byte| is_whitespace(byte) || matches!(byte, b',' | b';'));
            let at = self.cursor.at;
            match self.cursor.peek() {
                Some(b'[') => {
                    if let Some((point, end)) = paper_row(self.cursor.bytes(), at) {
                        self.cursor.at = end;
                        self.push(at, Some(point));
                    } else {
                        self.bracket();
                    }
                }
                Some(b']') => {
                    self.cursor.at += 1;
                    return self.end();
                }
                Some(b'0'..=b'9') if self.rows() == 0 && at_count(&self.cursor) => {
                    self.findings.add(&COUNT, at);
                    self.cursor.skip_line();
                }
                Some(b'0'..=b'9' | b'+' | b'-' | b'.') => {
                    self.findings.add(&NO_BRACKETS, at);
                    self.odd_row(false);
                }
                Some(byte) if is_remark(byte) => self.cursor.skip_line(),
                Some(byte) if byte.is_ascii_alphabetic() => {
                    if !self.word() {
                        return;
                    }
                }
                Some(_) => self.junk(at),
                None => return self.findings.add(&NOT_CLOSED, at),
            }
            if self.rows() >= MAX_POINTS {
                return self.findings.add(&TOO_MANY, self.cursor.at);
            }
        }
    }

    fn rows(&self) -> usize {
        self.points.len() + self.broken.len()
    }

    fn push(&mut self, at: usize, point: Option<Point>) {
        if !self.open {
            self.open = true;
            self.findings.add(&NO_HEADER, at);
        }
        match point {
            // NaN is in no range, and infinities are not read.
            Some(point) if point.coords.amax() > LARGEST => {
                let bytes = self.cursor.bytes();
                self.findings
                    .add_row(&TOO_FAR, at, || scan::excerpt(bytes, at));
                self.broken.push(self.rows() as u32);
            }
            Some(point) => self.points.push(point),
            None => self.broken.push(self.rows() as u32),
        }
        if self.points.len() == ROWS_TO_JUDGE_BY {
            self.reserve();
        }
    }

    /// Makes room for as many points as the file can be expected to hold, so that memory stays
    /// near what the result needs.
    fn reserve(&mut self) {
        let rest = self.cursor.bytes().len().saturating_sub(self.cursor.at);
        let row = (self.cursor.at / self.rows()).max(1);
        self.points
            .reserve_exact((rest / row + rest / row / 16).min(MAX_POINTS));
    }

    /// A word where a row was expected: the header, or junk. `false` if there is no use going on.
    fn word(&mut self) -> bool {
        let at = self.cursor.at;
        let word = self.cursor.word();
        if word.len() >= 9 && word[..9].eq_ignore_ascii_case(b"primitive") {
            self.findings.add(
                if self.rows() == 0 {
                    &OTHER_FILE
                } else {
                    &NOT_CLOSED
                },
                at,
            );
            return false;
        }
        if !self.open && word.eq_ignore_ascii_case(b"points") {
            self.open = true;
            self.cursor.skip_whitespace();
            let assigned = self.cursor.eat(b':') | self.cursor.eat(b'=');
            self.cursor.skip_whitespace();
            let bracket = self.cursor.peek() == Some(b'[') && !self.at_row();
            self.cursor.at += usize::from(bracket);
            if !(assigned && bracket) {
                self.findings.add(&NO_HEADER, at);
            }
        } else if word.eq_ignore_ascii_case(b"nan") || word.eq_ignore_ascii_case(b"inf") {
            // A row of numbers that begins with one that is not finite.
            self.cursor.at = at;
            self.odd_row(false);
        } else {
            self.junk(at);
        }
        true
    }

    fn junk(&mut self, at: usize) {
        let bytes = self.cursor.bytes();
        self.findings
            .add_row(&JUNK, at, || scan::excerpt(bytes, at));
        self.cursor.skip_line();
    }

    /// Whether a whole row begins here, rather than the list.
    fn at_row(&self) -> bool {
        paper_row(self.cursor.bytes(), self.cursor.at).is_some()
    }

    /// A bracket that does not begin a row in the paper's form.
    fn bracket(&mut self) {
        let at = self.cursor.at;
        self.cursor.at += 1;
        self.cursor.skip_whitespace();
        if self.cursor.peek() == Some(b'[') {
            if !self.open {
                self.open = true;
                self.findings.add(&NO_HEADER, at);
            }
            return;
        }
        self.odd_row(true);
    }

    /// Reads a row in any form but the paper's, from its first number. It ends with its bracket
    /// or, where it has none, its line.
    fn odd_row(&mut self, bracketed: bool) {
        let start = self.cursor.at;
        let mut row = OddRow::default();
        let closed = loop {
            let at = self.cursor.at;
            match self.cursor.peek() {
                None => break false,
                Some(b']') => {
                    if bracketed {
                        self.cursor.at += 1;
                    }
                    break bracketed;
                }
                Some(b'\n' | b'\r') if !bracketed => break false,
                Some(b'[' | b';') => break false,
                Some(b',') => {
                    row.comma(at);
                    self.cursor.at += 1;
                }
                Some(byte) if is_whitespace(byte) => self.cursor.at += 1,
                Some(byte) if is_remark(byte) => self.cursor.skip_line(),
                Some(_) => match number::read(self.cursor.bytes(), at) {
                    Some((value, end))
                        if self
                            .cursor
                            .bytes()
                            .get(end)
                            .is_none_or(|&next| is_separator(next)) =>
                    {
                        row.number(value, at);
                        self.cursor.at = end;
                    }
                    _ => {
                        row.wrong.get_or_insert(at);
                        self.cursor.skip_token();
                    }
                },
            }
        };
        if bracketed && !closed {
            if self.cursor.peek().is_none() {
                self.findings.add(&CUT_OFF, start);
                return self.push(start, None);
            }
            if row.point().is_some() {
                self.findings.add(&NO_ROW_END, start);
            }
        }
        let point = row.point();
        if point.is_none() {
            let bytes = self.cursor.bytes();
            let at = row.wrong.unwrap_or(start);
            let count = row.count;
            self.findings.add_row(&BROKEN_ROW, at, || match row.wrong {
                Some(at) => scan::token(bytes, at),
                None => format!("{count} numbers"),
            });
        } else if let Some(at) = row.no_comma {
            self.findings.add(&NO_COMMAS, at);
        }
        self.push(start, point);
    }

    /// After the closing bracket there is a semicolon and nothing else.
    fn end(&mut self) {
        self.cursor
            .skip_while(|byte| is_whitespace(byte) || byte == b';');
        if !is_blank(self.cursor.clone()) {
            self.findings.add(&AFTER_END, self.cursor.at);
        }
    }
}
