//! The benchmark's `PCi.txt`: `Points:=[`, one `[x, y, z], ` per line, ` ];`.
//!
//! Rows in the paper's form take [`paper_row`], which looks at each byte once and allocates
//! nothing; any other row is read again, slowly, by [`OddRow`]. On one core of an AMD EPYC that is
//! 750 MB/s natively; coordinates of 17 digits, which the standard library rounds, take 270 MB/s
//! (`examples/reading_speed.rs`).

use super::kinds::{
    AFTER_END, BROKEN_ROW, COUNT, CUT_OFF, EMPTY, JUNK, NO_BRACKETS, NO_COMMAS, NO_HEADER,
    NO_POINTS, NO_ROW_END, NOT_CLOSED, OTHER_FILE, TOO_FAR, TOO_MANY,
};
use super::row::{OddRow, paper_row};
use super::{CloudFile, ROWS_TO_JUDGE_BY, at_count};
use crate::cloud::{Cloud, LARGEST, Numbering, Point};
use crate::diagnostics::Diagnostic;
use crate::format::findings::{Findings, Kept, is_blank};
use crate::format::limits::MAX_POINTS;
use crate::format::number;
use crate::format::scan::{self, Cursor, is_remark, is_separator, is_whitespace};
use crate::format::window::{Window, begins_row};

/// Reads a cloud in the paper's form from an offset of the window on.
///
/// # Errors
/// Why the text cannot be had to its end.
pub(in crate::format) fn read_papers_form(
    file: &str,
    window: &mut Window<'_>,
    from: usize,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    let mut rows = Rows::default();
    let mut cursor = Cursor::new(window.bytes());
    cursor.at = from;
    if window.is_last() && is_blank(cursor) {
        let mut findings = Findings::new(file, &[]);
        findings.add_whole(&EMPTY, String::new());
        return Ok((CloudFile::default(), findings.finish()));
    }
    let mut at = from;
    loop {
        // Up to the row before the last that begins here: what is after it is looked at, too.
        let last = window.last(at, begins_row)?;
        let limit = match window.is_last() {
            true => usize::MAX,
            false => (at + 1..last)
                .rev()
                .find(|&at| begins_row(window, at))
                .unwrap_or(at),
        };
        let (outcome, end) = Reader::pass(&mut rows, file, window, at, limit, Reader::read_rows);
        match outcome {
            Outcome::Full => break,
            Outcome::More => {
                at = window.let_go(end);
                window.read_on()?;
            }
            Outcome::Closed => {
                while !window.is_last() {
                    window.read_on()?;
                }
                Reader::pass(&mut rows, file, window, end, limit, Reader::end);
                break;
            }
        }
    }
    Ok(rows.finish(file))
}

/// The rows that were read so far.
#[derive(Default)]
struct Rows {
    kept: Kept,
    points: Vec<Point>,
    broken: Vec<u32>,
    /// Whether the header's bracket, or what stands for it, has been passed.
    open: bool,
}

impl Rows {
    fn finish(mut self, file: &str) -> (CloudFile, Vec<Diagnostic>) {
        let mut findings = Findings::resume(file, &[], 0, self.kept);
        if self.points.is_empty() {
            findings.add_whole(&NO_POINTS, String::new());
        }
        // The first rows may be shorter than the others, and the guess by them too large.
        self.points.shrink_to_fit();
        let rows = self.points.len() + self.broken.len();
        let numbering = Numbering::with_broken(rows, self.broken);
        let file = CloudFile {
            cloud: Cloud::numbered(self.points, numbering),
            segments: None,
        };
        (file, findings.finish_rows(rows))
    }
}

/// Why the reading of rows ended.
enum Outcome {
    /// What is in memory has been read up to the limit.
    More,
    /// The list is closed.
    Closed,
    /// There is nothing more to read, or there are too many.
    Full,
}

/// Reads the rows that are in memory.
struct Reader<'a, 'r> {
    findings: Findings<'a>,
    cursor: Cursor<'a>,
    /// Where no further row is to be begun.
    limit: usize,
    /// Offset in the text of what is in memory, and the bytes of the text from there on.
    before: u64,
    rest: u64,
    rows: &'r mut Rows,
}

impl<'a, 'r> Reader<'a, 'r> {
    /// Has a reader of the window do something from an offset on, and tells where it ended.
    fn pass<T>(
        rows: &'r mut Rows,
        file: &'a str,
        window: &'a Window<'_>,
        at: usize,
        limit: usize,
        work: impl FnOnce(&mut Self) -> T,
    ) -> (T, usize) {
        let mut cursor = Cursor::new(window.bytes());
        cursor.at = at;
        let kept = std::mem::take(&mut rows.kept);
        let mut reader = Self {
            findings: Findings::resume(file, window.bytes(), window.lines(), kept),
            cursor,
            limit,
            before: window.from(),
            rest: window.size() - window.from(),
            rows,
        };
        let done = work(&mut reader);
        let end = reader.cursor.at;
        reader.rows.kept = reader.findings.pause();
        (done, end)
    }

    fn read_rows(&mut self) -> Outcome {
        loop {
            self.cursor
                .skip_while(|byte| is_whitespace(byte) || matches!(byte, b',' | b';'));
            let at = self.cursor.at;
            if at >= self.limit {
                return Outcome::More;
            }
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
                    return Outcome::Closed;
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
                        return Outcome::Full;
                    }
                }
                Some(_) => self.junk(at),
                None => {
                    self.findings.add(&NOT_CLOSED, at);
                    return Outcome::Full;
                }
            }
            if self.rows() >= MAX_POINTS {
                self.findings.add(&TOO_MANY, self.cursor.at);
                return Outcome::Full;
            }
        }
    }

    fn rows(&self) -> usize {
        self.rows.points.len() + self.rows.broken.len()
    }

    fn push(&mut self, at: usize, point: Option<Point>) {
        if !self.rows.open {
            self.rows.open = true;
            self.findings.add(&NO_HEADER, at);
        }
        match point {
            // NaN is in no range, and infinities are not read.
            Some(point) if point.coords.amax() > LARGEST => {
                let bytes = self.cursor.bytes();
                self.findings
                    .add_row(&TOO_FAR, at, || scan::excerpt(bytes, at));
                self.rows.broken.push(self.rows() as u32);
            }
            Some(point) => self.rows.points.push(point),
            None => self.rows.broken.push(self.rows() as u32),
        }
        let room = self.rows.points.capacity();
        if self.rows.points.len() >= ROWS_TO_JUDGE_BY.max(room) {
            self.reserve();
        }
    }

    /// Makes room for as many points as the file can be expected to hold, so that memory stays
    /// near what the result needs.
    fn reserve(&mut self) {
        let at = self.cursor.at as u64;
        let row = ((self.before + at) / self.rows().max(1) as u64).max(1);
        let rest = self.rest.saturating_sub(at) / row;
        let rest = usize::try_from(rest + rest / 16 + 1).unwrap_or(MAX_POINTS);
        self.rows.points.reserve_exact(rest.min(MAX_POINTS));
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
        if !self.rows.open && word.eq_ignore_ascii_case(b"points") {
            self.rows.open = true;
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
            if !self.rows.open {
                self.rows.open = true;
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
