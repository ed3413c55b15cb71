//! Reading rows of numbers: `x y z` and whatever follows, separated by blanks, tabs, commas or
//! semicolons, with or without a line of names, a number of points or remarks before them.
//!
//! The form is told from lines all over the file (`dialect`), what the columns hold from
//! their names or values ([`columns`](super::columns)); then each line is read once.

mod dialect;
mod fields;

use fields::{Dialect, Fields, is_no_number, is_number_like, number_of};

use super::CloudFile;
use super::columns::Columns;
use super::kinds::{
    BAD_LABEL, BROKEN_ROW, COLUMNS, JUNK, MISCOUNTED, NO_POINTS, OTHER_FILE, TOO_FAR, TOO_MANY,
};
use crate::cloud::{Cloud, LARGEST, Numbering, Point};
use crate::diagnostics::Diagnostic;
use crate::format::findings::Findings;
use crate::format::labels::is_label_value;
use crate::format::labels::{NO_LABEL, by_label};
use crate::format::limits::MAX_POINTS;
use crate::format::scan::{self, Cursor, is_line_end, is_remark, is_whitespace};

/// Lines by which form and columns are told. Looking for the nearest neighbour of each among them
/// takes a millionth of a second a pair.
const SAMPLES: usize = 1024;

/// Longest line of names, in bytes; a longer one is none.
const LONGEST_NAMES: usize = 4096;

/// Reads a table of points. `labelled` where the kind of file says that its last column is of labels.
pub(super) fn read(
    findings: Findings<'_>,
    cursor: Cursor<'_>,
    labelled: bool,
) -> (CloudFile, Vec<Diagnostic>) {
    let mut reader = Reader {
        findings,
        bytes: cursor.bytes(),
        points: Vec::new(),
        labels: Vec::new(),
        broken: Vec::new(),
    };
    let start = Start::of(reader.bytes, cursor.at);
    let samples = sampled(reader.bytes, start.at);
    let dialect = dialect::tell(&samples);
    let columns = reader.columns(&start, &samples, dialect, labelled);
    reader.rows(start.at, dialect, &columns);
    reader.finish(&start, &columns)
}

/// Where the rows of a table begin, and what stands before them.
#[derive(Debug, Default)]
struct Start<'a> {
    /// Offset of the first line that is a row.
    at: usize,
    /// How many points the table says it has.
    count: Option<u64>,
    /// The last line that may be of names, and whether it was a remark.
    names: Option<(&'a [u8], bool)>,
}

impl<'a> Start<'a> {
    fn of(bytes: &'a [u8], from: usize) -> Self {
        let mut start = Self::default();
        for (at, line) in (Lines { bytes, at: from }) {
            start.at = at;
            match kind_of(line) {
                Line::Blank => {}
                Line::Remark(text) if (1..=LONGEST_NAMES).contains(&text.len()) => {
                    start.names = Some((text, true))
                }
                Line::Remark(_) => {}
                Line::Count(count) if start.count.is_none() => start.count = Some(count),
                Line::Words if line.len() <= LONGEST_NAMES => start.names = Some((line, false)),
                Line::Words => {}
                Line::Count(_) | Line::Numbers => return start,
            }
        }
        start.at = bytes.len();
        start
    }

    /// The names of so many columns, if there are any.
    fn named(&self, count: usize, dialect: Dialect) -> Option<Columns> {
        let (line, remark) = self.names?;
        let loose = || {
            let words = line.split(|&byte| is_whitespace(byte) || matches!(byte, b',' | b';'));
            words.filter(|word| !word.is_empty()).map(text_of).collect()
        };
        let strict: Vec<String> = Fields::of(line, dialect).map(text_of).collect();
        let names: Vec<String> = if strict.len() == count {
            strict
        } else {
            loose()
        };
        let columns = Columns::named(&names).filter(|_| names.len() == count)?;
        // A remark may be about anything.
        let tells = ["x", "y", "z"].iter().all(|axis| {
            names
                .iter()
                .any(|name| super::columns::meaning_of(name) == super::columns::meaning_of(axis))
        });
        (tells || !remark).then_some(columns)
    }
}

fn text_of(word: &[u8]) -> String {
    String::from_utf8_lossy(word).trim_matches('"').to_owned()
}

/// What a line is by its first signs.
enum Line<'a> {
    Blank,
    /// What stands behind the mark of a remark.
    Remark(&'a [u8]),
    /// One whole number alone.
    Count(u64),
    /// Begins with a word that is no number.
    Words,
    /// Anything else.
    Numbers,
}

fn kind_of(line: &[u8]) -> Line<'_> {
    let line = line.trim_ascii();
    match line {
        [] => Line::Blank,
        [b'/', b'/', rest @ ..] => Line::Remark(rest.trim_ascii()),
        [byte, rest @ ..] if is_remark(*byte) => Line::Remark(rest.trim_ascii()),
        _ if line.iter().all(u8::is_ascii_digit) => {
            let text = std::str::from_utf8(line).unwrap_or_default();
            text.parse().map_or(Line::Numbers, Line::Count)
        }
        [first, ..] => {
            // A quote or bracket may stand before either.
            let word =
                line.split(|&byte| is_whitespace(byte) || matches!(byte, b',' | b';' | b'"'));
            let word = word.into_iter().find(|word| !word.is_empty());
            let first = word.and_then(|word| word.first()).unwrap_or(first);
            if (first.is_ascii_alphabetic() || !first.is_ascii()) && !word.is_some_and(is_no_number)
            {
                Line::Words
            } else {
                Line::Numbers
            }
        }
    }
}

/// Lines and their offsets, without what ends them.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let start = self.at;
        let rest = self.bytes.get(start..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|&byte| is_line_end(byte));
        let length = length.unwrap_or(rest.len());
        self.at = start + length + 1;
        if rest.get(length..length + 2) == Some(b"\r\n") {
            self.at += 1;
        }
        Some((start, rest.get(..length)?))
    }
}

/// Rows evenly spread over the file.
fn sampled(bytes: &[u8], from: usize) -> Vec<&[u8]> {
    let length = bytes.len().saturating_sub(from);
    let mut lines = Vec::new();
    let mut next = from;
    for k in 0..SAMPLES {
        // Past the line that the place falls into, but for the first and for one that is past it already.
        let mut at = from + length / SAMPLES * k + length % SAMPLES * k / SAMPLES;
        if at <= next {
            at = next;
        } else {
            let rest = bytes.get(at - 1..).unwrap_or_default();
            let end = rest.iter().position(|&byte| is_line_end(byte));
            at = end.map_or(bytes.len(), |end| at + end);
        }
        if at >= bytes.len() {
            break;
        }
        let mut rows = Lines { bytes, at };
        // Few lines between rows are something else.
        for (_, line) in rows.by_ref().take(8) {
            let line = without_remark(line);
            if matches!(kind_of(line), Line::Numbers) {
                lines.push(line);
                break;
            }
        }
        next = rows.at;
    }
    lines
}

/// A line up to the remark at its end.
fn without_remark(line: &[u8]) -> &[u8] {
    let end = line.iter().position(|&byte| is_remark(byte));
    line.get(..end.unwrap_or(line.len())).unwrap_or(line)
}

struct Reader<'a> {
    findings: Findings<'a>,
    bytes: &'a [u8],
    points: Vec<Point>,
    /// One a point, where there is a column of them.
    labels: Vec<i32>,
    broken: Vec<u32>,
}

impl Reader<'_> {
    fn columns(
        &mut self,
        start: &Start<'_>,
        samples: &[&[u8]],
        dialect: Dialect,
        labelled: bool,
    ) -> Columns {
        let mut counts: Vec<usize> = samples
            .iter()
            .map(|line| Fields::of(line, dialect).count())
            .collect();
        counts.sort_unstable();
        let usual = counts.get(counts.len() / 2).copied().unwrap_or(3);
        let columns = start.named(usual, dialect).unwrap_or_else(|| {
            let rows: Vec<Vec<f64>> = samples
                .iter()
                .map(|line| {
                    let fields = Fields::of(line, dialect);
                    let numbers = fields.map(|field| number_of(field, dialect).unwrap_or(f64::NAN));
                    numbers.collect()
                })
                .filter(|row: &Vec<f64>| {
                    row.len() >= usual && row.iter().take(3).all(|value| value.is_finite())
                })
                .collect();
            Columns::guessed(&rows, labelled)
        });
        let besides = columns.besides();
        if !besides.is_empty() {
            self.findings.add_found(&COLUMNS, start.at, || besides);
        }
        columns
    }

    fn count(&self) -> usize {
        self.points.len() + self.broken.len()
    }

    fn rows(&mut self, from: usize, dialect: Dialect, columns: &Columns) {
        let bytes = self.bytes;
        for (at, whole) in (Lines { bytes, at: from }) {
            let line = without_remark(whole);
            if line.trim_ascii().is_empty() || line.trim_ascii_start().starts_with(b"//") {
                continue;
            }
            if self.count() >= MAX_POINTS {
                return self.findings.add(&TOO_MANY, at);
            }
            self.row(at, line, dialect, columns);
            if self.points.len() == super::ROWS_TO_JUDGE_BY {
                self.reserve(from, at, columns);
            }
        }
    }

    fn reserve(&mut self, from: usize, at: usize, columns: &Columns) {
        let row = ((at - from) / self.count().max(1)).max(1);
        let rest = self.bytes.len().saturating_sub(at) / row;
        let rest = (rest + rest / 16).min(MAX_POINTS);
        self.points.reserve_exact(rest);
        if columns.label.is_some() {
            self.labels.reserve_exact(rest);
        }
    }

    fn row(&mut self, at: usize, line: &[u8], dialect: Dialect, columns: &Columns) {
        let [x, y, z] = columns.coordinates;
        let mut point = [None; 3];
        let (mut label, mut wrong, mut count) = (None, None, 0);
        let mut fields = Fields::of(line, dialect);
        // Where there is nothing but coordinates, a row of more is none.
        let last = if columns.len() == 3 {
            3
        } else {
            columns.last()
        };
        while count <= last
            && let Some((start, field)) = fields.next_at()
        {
            let axis = [x, y, z].iter().position(|&column| column == count);
            if let Some(slot) = axis.and_then(|axis| point.get_mut(axis)) {
                *slot = number_of(field, dialect);
                if slot.is_none() {
                    wrong.get_or_insert(start);
                }
            } else if Some(count) == columns.label {
                label = number_of(field, dialect);
            }
            count += 1;
        }
        match point {
            [Some(x), Some(y), Some(z)] if columns.len() > 3 || count == 3 => {
                self.push(at, Point::new(x, y, z), label, columns.label.is_some());
            }
            _ => self.break_row(at, line, wrong, count, dialect, columns),
        }
    }

    fn push(&mut self, at: usize, point: Point, label: Option<f64>, labelled: bool) {
        // NaN is in no range, and infinities are not read.
        if point.coords.amax() > LARGEST {
            self.findings
                .add_row(&TOO_FAR, at, || scan::excerpt(self.bytes, at));
            self.broken.push(self.count() as u32);
            return;
        }
        self.points.push(point);
        if labelled {
            let known = label.filter(|&value| is_label_value(value));
            if known.is_none() {
                self.findings
                    .add_row(&BAD_LABEL, at, || scan::excerpt(self.bytes, at));
            }
            self.labels
                .push(known.map_or(NO_LABEL, |value| value as i32));
        }
    }

    /// A line that is no point: a row that keeps its number, or words that have none.
    fn break_row(
        &mut self,
        at: usize,
        line: &[u8],
        wrong: Option<usize>,
        count: usize,
        dialect: Dialect,
        columns: &Columns,
    ) {
        let bytes = self.bytes;
        let some_number = Fields::of(line, dialect).any(|field| is_number_like(field, dialect));
        if matches!(kind_of(line), Line::Words) && !some_number && count != columns.len() {
            return self
                .findings
                .add_row(&JUNK, at, || scan::excerpt(bytes, at));
        }
        let place = at + wrong.unwrap_or(0);
        self.findings.add_row(&BROKEN_ROW, place, || match wrong {
            Some(_) => scan::token(bytes, place),
            None if count == 1 => "1 number".to_owned(),
            None => format!("{count} numbers"),
        });
        self.broken.push(self.count() as u32);
    }

    fn finish(mut self, start: &Start<'_>, columns: &Columns) -> (CloudFile, Vec<Diagnostic>) {
        let rows = self.count();
        if self.points.is_empty() {
            let keyword = start.names.map_or(&[][..], |(line, _)| line).get(..9);
            let other = keyword.is_some_and(|word| word.eq_ignore_ascii_case(b"primitive"));
            self.findings
                .add_whole(if other { &OTHER_FILE } else { &NO_POINTS }, String::new());
        } else if let Some(count) = start.count.filter(|&count| count != rows as u64) {
            self.findings
                .add_whole(&MISCOUNTED, format!("{count} said, {rows} found"));
        }
        // The first rows may be shorter than the others, and the guess by them too large.
        self.points.shrink_to_fit();
        self.labels.shrink_to_fit();
        let numbering = Numbering::with_broken(rows, self.broken);
        let file = CloudFile {
            cloud: Cloud::numbered(self.points, numbering),
            segments: columns.label.map(|_| by_label(&self.labels)),
        };
        (file, self.findings.finish_rows(rows))
    }
}
