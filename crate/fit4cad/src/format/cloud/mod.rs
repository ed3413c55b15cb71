//! Reading `PCi.txt`: `Points:=[`, one `[x, y, z], ` per line, ` ];`.
//!
//! Rows in the paper's form take [`paper_row`], which looks at each byte once and allocates
//! nothing; any other row is read again, slowly, by [`OddRow`]. On one core of an AMD EPYC that is
//! 750 MB/s natively; bare columns and coordinates of 17 digits, which the standard library rounds,
//! take 270 MB/s (`examples/reading_speed.rs`).

mod kinds;
mod row;

use kinds::{
    AFTER_END, BROKEN_ROW, CUT_OFF, EMPTY, JUNK, NO_BRACKETS, NO_COMMAS, NO_HEADER, NO_POINTS,
    NO_ROW_END, NOT_CLOSED, OTHER_FILE, TOO_MANY,
};
use row::{OddRow, paper_row};

use super::findings::{Findings, is_blank, open};
use super::limits::MAX_POINTS;
use super::number;
use super::numbering::Numbering;
use super::scan::{self, Cursor, is_remark, is_separator, is_whitespace};
use crate::cloud::{Cloud, Point};
use crate::diagnostics::Diagnostic;

/// A cloud as read, and what its file's point numbers mean.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CloudText {
    /// The points that could be read.
    pub cloud: Cloud,
    /// From point numbers, as the primitives file uses them, to indices into the cloud.
    pub numbering: Numbering,
}

/// Reads a cloud file. Linear in its length, one pass.
///
/// Anything but the paper's form is read as far as its meaning is plain (rows without commas or
/// brackets, MATLAB's `Points=[1 2 3; …]`, a missing header or end, remarks) with a finding. A row
/// that is not three finite numbers keeps its number and has no point ([`Numbering`]).
pub fn read_cloud(file: &str, bytes: &[u8]) -> (CloudText, Vec<Diagnostic>) {
    match open(file, bytes) {
        Ok((findings, cursor)) => Reader::new(findings, cursor).read(),
        Err(diagnostics) => (CloudText::default(), diagnostics),
    }
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

    fn read(mut self) -> (CloudText, Vec<Diagnostic>) {
        if is_blank(self.cursor.clone()) {
            self.findings.add_whole(&EMPTY, String::new());
        } else {
            self.read_rows();
            if self.points.is_empty() {
                self.findings.add_whole(&NO_POINTS, String::new());
            }
        }
        // The first rows may be shorter than the others, and the guess by them too large.
        self.points.shrink_to_fit();
        let text = CloudText {
            numbering: Numbering::with_broken(self.rows(), self.broken),
            cloud: Cloud::new(self.points),
        };
        (text, self.findings.finish())
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
                Some(_) => {
                    self.findings.add(&JUNK, at);
                    self.cursor.skip_line();
                }
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
            self.findings.add(&JUNK, at);
            self.cursor.skip_line();
        }
        true
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
            self.findings
                .add_found(&BROKEN_ROW, at, || match row.wrong {
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
