//! One row of a cloud file: `[x, y, z]`.

use crate::cloud::Point;
use crate::format::number;
use crate::format::scan::is_whitespace;

/// The numbers of a row as they come.
#[derive(Default)]
pub(super) struct OddRow {
    values: [f64; 3],
    pub(super) count: usize,
    /// Commas since the last number.
    commas: usize,
    /// Where something that is no number stands.
    pub(super) wrong: Option<usize>,
    /// Where a comma is missing.
    pub(super) no_comma: Option<usize>,
}

impl OddRow {
    pub(super) fn number(&mut self, value: f64, at: usize) {
        if self.count > 0 && self.commas == 0 {
            self.no_comma.get_or_insert(at);
        }
        if let Some(slot) = self.values.get_mut(self.count) {
            *slot = value;
        }
        self.count += 1;
        self.commas = 0;
    }

    pub(super) fn comma(&mut self, at: usize) {
        self.commas += 1;
        if self.commas > 1 || self.count == 0 {
            self.wrong.get_or_insert(at);
        }
    }

    pub(super) fn point(&self) -> Option<Point> {
        (self.count == 3 && self.wrong.is_none()).then(|| Point::from(self.values))
    }
}

/// A row exactly as the paper writes it, white space aside, from its bracket to past its end.
#[inline]
pub(super) fn paper_row(bytes: &[u8], start: usize) -> Option<(Point, usize)> {
    let (x, at) = number::read(bytes, past(bytes, start, b'[')?)?;
    let (y, at) = number::read(bytes, past(bytes, at, b',')?)?;
    let (z, at) = number::read(bytes, past(bytes, at, b',')?)?;
    let end = past_blanks(bytes, at);
    (bytes.get(end) == Some(&b']')).then(|| (Point::new(x, y, z), end + 1))
}

/// Past a mark and the blanks on both sides of it.
#[inline]
fn past(bytes: &[u8], at: usize, mark: u8) -> Option<usize> {
    let at = past_blanks(bytes, at);
    (bytes.get(at) == Some(&mark)).then(|| past_blanks(bytes, at + 1))
}

#[inline]
fn past_blanks(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(|&byte| is_whitespace(byte)) {
        at += 1;
    }
    at
}
