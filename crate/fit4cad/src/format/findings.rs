//! Collecting what is wrong with one file.

use super::limits::MAX_SIMILAR_DIAGNOSTICS;
use super::scan::{Cursor, Lines, excerpt, is_remark, is_whitespace, shortened};
use crate::diagnostics::{Diagnostic, Position, Severity, Subject};

/// Most characters of what was found. Headers of foreign files can be as long as the file.
const LONGEST_FOUND: usize = 240;

/// A kind of finding: what is the same each time it occurs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kind {
    pub(super) subject: Subject,
    pub(super) severity: Severity,
    pub(super) message: &'static str,
    pub(super) expected: &'static str,
    pub(super) hint: &'static str,
}

/// Shown and counted occurrences of one kind.
#[derive(Debug)]
struct Tally {
    message: &'static str,
    count: usize,
    last_shown: usize,
    /// Whether only the first is shown, and how many there are of how many rows.
    of_rows: bool,
}

/// The findings about one file, in the order they were made. Of each kind only the first
/// [`MAX_SIMILAR_DIAGNOSTICS`] are kept; the others are counted.
#[derive(Debug)]
pub(super) struct Findings<'a> {
    file: &'a str,
    bytes: &'a [u8],
    lines: Lines<'a>,
    /// Number of the primitive whose entry is being read.
    primitive: Option<u32>,
    kept: Kept,
}

/// What was found so far, between two pieces of a file.
#[derive(Debug, Default)]
pub(super) struct Kept {
    diagnostics: Vec<Diagnostic>,
    tallies: Vec<Tally>,
}

impl<'a> Findings<'a> {
    pub(super) fn new(file: &'a str, bytes: &'a [u8]) -> Self {
        Self::resume(file, bytes, 0, Kept::default())
    }

    /// Goes on with a piece of the file before which there are so many lines.
    pub(super) fn resume(file: &'a str, bytes: &'a [u8], lines: u32, kept: Kept) -> Self {
        Self {
            file,
            bytes,
            lines: Lines::after(lines, bytes),
            primitive: None,
            kept,
        }
    }

    /// What was found so far.
    pub(super) fn pause(self) -> Kept {
        self.kept
    }

    /// From here on findings are about that primitive, or about none.
    pub(super) fn about(&mut self, primitive: Option<u32>) {
        self.primitive = primitive;
    }

    pub(super) fn position(&mut self, offset: usize) -> Position {
        self.lines.position(offset)
    }

    /// Adds a finding at an offset; what was found is what stands there.
    pub(super) fn add(&mut self, kind: &Kind, offset: usize) {
        let bytes = self.bytes;
        self.add_found(kind, offset, || excerpt(bytes, offset));
    }

    /// Adds a finding at an offset. `found` is called only if the finding is kept.
    pub(super) fn add_found(&mut self, kind: &Kind, offset: usize, found: impl FnOnce() -> String) {
        self.add_with(kind, offset, || (found(), kind.expected.to_owned()));
    }

    /// Adds a finding about a row or line, of which there may be as many as rows: the first is shown,
    /// the others are counted ([`Findings::finish_rows`]).
    pub(super) fn add_row(&mut self, kind: &Kind, offset: usize, found: impl FnOnce() -> String) {
        let last_shown = self.kept.diagnostics.len();
        if let Some(tally) = self
            .kept
            .tallies
            .iter_mut()
            .find(|tally| tally.message == kind.message)
        {
            tally.count += 1;
            return;
        }
        self.kept.tallies.push(Tally {
            message: kind.message,
            count: 1,
            last_shown,
            of_rows: true,
        });
        let position = Some(self.lines.position(offset));
        self.push(kind, position, found(), kind.expected.to_owned());
    }

    /// Adds a finding whose expectation differs from case to case.
    pub(super) fn add_with(
        &mut self,
        kind: &Kind,
        offset: usize,
        found_and_expected: impl FnOnce() -> (String, String),
    ) {
        if self.count(kind) {
            let position = Some(self.lines.position(offset));
            let (found, expected) = found_and_expected();
            self.push(kind, position, found, expected);
        }
    }

    /// Adds a finding at a place that is known already.
    pub(super) fn add_at(
        &mut self,
        kind: &Kind,
        position: Position,
        found_and_expected: impl FnOnce() -> (String, String),
    ) {
        if self.count(kind) {
            let (found, expected) = found_and_expected();
            self.push(kind, Some(position), found, expected);
        }
    }

    /// Adds a finding about the file as a whole.
    pub(super) fn add_whole(&mut self, kind: &Kind, found: String) {
        if self.count(kind) {
            self.push(kind, None, found, kind.expected.to_owned());
        }
    }

    fn push(&mut self, kind: &Kind, position: Option<Position>, found: String, expected: String) {
        self.kept.diagnostics.push(Diagnostic {
            severity: kind.severity,
            subject: kind.subject,
            primitive: self.primitive,
            file: self.file.to_owned(),
            position,
            message: kind.message.to_owned(),
            found: shortened(&found, LONGEST_FOUND),
            expected,
            hint: kind.hint.to_owned(),
        });
    }

    /// Counts an occurrence; whether it is still to be shown.
    fn count(&mut self, kind: &Kind) -> bool {
        let next = self.kept.diagnostics.len();
        match self
            .kept
            .tallies
            .iter_mut()
            .find(|tally| tally.message == kind.message)
        {
            Some(tally) => {
                tally.count += 1;
                let shown = tally.count <= MAX_SIMILAR_DIAGNOSTICS;
                if shown {
                    tally.last_shown = next;
                }
                shown
            }
            None => {
                self.kept.tallies.push(Tally {
                    message: kind.message,
                    count: 1,
                    last_shown: next,
                    of_rows: false,
                });
                true
            }
        }
    }

    /// The findings; where some of a kind were left out, the last one shown says how many.
    pub(super) fn finish(self) -> Vec<Diagnostic> {
        self.finish_rows(0)
    }

    /// As [`Findings::finish`]; a finding about rows says how many of all it is about.
    pub(super) fn finish_rows(mut self, rows: usize) -> Vec<Diagnostic> {
        for tally in &self.kept.tallies {
            if tally.of_rows {
                let first = self.kept.diagnostics.get_mut(tally.last_shown);
                if let (2.., Some(first)) = (tally.count, first) {
                    let of = if rows > 0 {
                        format!("{} of {rows} rows", tally.count)
                    } else {
                        format!("{} lines", tally.count)
                    };
                    first.message = format!("{} ({of}, this is the first)", first.message);
                }
                continue;
            }
            let more = tally.count.saturating_sub(MAX_SIMILAR_DIAGNOSTICS);
            if let (1.., Some(last)) = (more, self.kept.diagnostics.get_mut(tally.last_shown)) {
                last.message = format!("{}; {more} more like this in the file", last.message);
            }
        }
        self.kept.diagnostics
    }
}

const NOT_TEXT: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file is not text and was not read",
    expected: "one of the benchmark's text files",
    hint: "Unpack archives first; export other formats as text",
};

/// The text of a file without its byte order mark, or `None` with a finding where it is no text
/// that could be read.
pub(super) fn open<'a>(
    file: &'a str,
    bytes: &'a [u8],
) -> Result<(Findings<'a>, Cursor<'a>), Vec<Diagnostic>> {
    let mut findings = Findings::new(file, bytes);
    let mut cursor = Cursor::new(bytes);
    match bytes {
        [0xEF, 0xBB, 0xBF, ..] => cursor.at = 3,
        [b'P', b'K', 3, 4, ..] | [0x1F, 0x8B, ..] | [0x89, b'P', b'N', b'G', ..] => {
            findings.add_whole(&NOT_TEXT, "binary data".to_owned());
            return Err(findings.finish());
        }
        _ => {}
    }
    Ok((findings, cursor))
}

/// Whether a file holds nothing but white space and remarks. Linear in what it skips.
pub(super) fn is_blank(mut cursor: Cursor<'_>) -> bool {
    loop {
        cursor.skip_while(is_whitespace);
        match cursor.peek() {
            None => return true,
            Some(byte) if is_remark(byte) => cursor.skip_line(),
            Some(_) => return false,
        }
    }
}
