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
    BAD_LABEL, BROKEN_ROW, COLUMNS, JUNK, MISCOUNTED, NO_POINTS, ONE_A_ROW, OTHER_FILE, TOO_FAR,
    TOO_MANY,
};
use crate::cloud::{Cloud, LARGEST, Numbering, Point};
use crate::diagnostics::Diagnostic;
use crate::format::findings::{Findings, Kept};
use crate::format::labels::is_label_value;
use crate::format::labels::{NO_LABEL, by_label};
use crate::format::limits::MAX_POINTS;
use crate::format::one_a_row::is_one_a_row;
use crate::format::scan::{self, is_line_end, is_remark, is_whitespace};
use crate::format::window::Window;

/// Lines by which form and columns are told. Looking for the nearest neighbour of each among them
/// takes a millionth of a second a pair.
const SAMPLES: usize = 1024;

/// Longest line of names, in bytes; a longer one is none.
const LONGEST_NAMES: usize = 4096;

/// Reads a table of points from an offset on. `labelled` where the kind of file says that its last column is of
/// labels.
///
/// # Errors
/// Why the text cannot be had to its end.
pub(in crate::format) fn read(
    file: &str,
    window: &mut Window<'_>,
    from: usize,
    labelled: bool,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    if window.look_at(window.from(), is_one_a_row)? == Some(true) {
        let mut findings = Findings::new(file, &[]);
        findings.add_whole(&ONE_A_ROW, String::new());
        return Ok((CloudFile::default(), findings.finish()));
    }
    let mut start = Start::default();
    let first = start.read(window, from)?;
    let begin = window.from() + first as u64;
    let samples = sampled(window, begin)?;
    let samples: Vec<&[u8]> = samples.iter().map(Vec::as_slice).collect();
    let dialect = dialect::tell(&samples);
    let mut findings = Findings::new(file, &[]);
    let columns = columns_of(&start, &samples, dialect, labelled);
    let besides = columns.besides();
    if !besides.is_empty() {
        findings = Findings::resume(file, window.bytes(), window.lines(), findings.pause());
        findings.add_found(&COLUMNS, first, || besides);
    }
    let mut rows = Rows {
        kept: findings.pause(),
        begin,
        dialect,
        columns,
        points: Vec::new(),
        labels: Vec::new(),
        broken: Vec::new(),
    };
    let mut at = first;
    loop {
        let end = window.line_end(at)?;
        if rows.take(file, window, at, end) || window.is_last() {
            break;
        }
        at = window.let_go(end);
        window.read_on()?;
    }
    Ok(rows.finish(file, &start))
}

/// What stands before the rows of a table.
#[derive(Debug, Default)]
struct Start {
    /// How many points the table says it has.
    count: Option<u64>,
    /// The last line that may be of names, and whether it was a remark.
    names: Option<(Vec<u8>, bool)>,
}

impl Start {
    /// Reads up to the first line that is a row, and tells its offset into the window; the end where there is none.
    fn read(&mut self, window: &mut Window<'_>, from: usize) -> Result<usize, String> {
        let mut at = from;
        loop {
            let end = window.line_end(at)?;
            let bytes = window.bytes().get(..end).unwrap_or_default();
            for (row, line) in (Lines { bytes, at }) {
                if self.is_row(line) {
                    return Ok(row);
                }
            }
            if window.is_last() {
                return Ok(end);
            }
            at = window.let_go(end);
            window.read_on()?;
        }
    }

    /// Whether a line is a row; what it says where it is none.
    fn is_row(&mut self, line: &[u8]) -> bool {
        match kind_of(line) {
            Line::Blank => {}
            Line::Remark(text) if (1..=LONGEST_NAMES).contains(&text.len()) => {
                self.names = Some((text.to_vec(), true));
            }
            Line::Remark(_) => {}
            Line::Count(count) if self.count.is_none() => self.count = Some(count),
            Line::Words if line.len() <= LONGEST_NAMES => {
                self.names = Some((line.to_vec(), false));
            }
            Line::Words => {}
            Line::Count(_) | Line::Numbers => return true,
        }
        false
    }

    /// The names of so many columns, if there are any, and what they tell.
    fn named(&self, count: usize, dialect: Dialect) -> Option<(Vec<String>, Columns)> {
        let (line, remark) = self.names.as_ref()?;
        // Between marks there may be blanks and brackets in a name: `X [m]`.
        let tab = Some(b'\t').filter(|tab| line.contains(tab));
        let marked = dialect.mark.or(tab).map(|mark| -> Vec<String> {
            let names = line.split(|&byte| byte == mark).map(<[u8]>::trim_ascii);
            names.map(text_of).collect()
        });
        let strict = || Fields::of(line, dialect).map(text_of).collect::<Vec<_>>();
        let loose = || {
            let words = line.split(|&byte| is_whitespace(byte) || matches!(byte, b',' | b';'));
            words.filter(|word| !word.is_empty()).map(text_of).collect()
        };
        let fits = |names: &Vec<String>| names.len() == count;
        let names = marked
            .filter(fits)
            .or_else(|| Some(strict()).filter(fits))
            .or_else(|| Some(loose()).filter(fits))?;
        let columns = Columns::named(&names)?;
        // A remark may be about anything.
        let tells = ["x", "y", "z"].iter().all(|axis| {
            names
                .iter()
                .any(|name| super::columns::meaning_of(name) == super::columns::meaning_of(axis))
        });
        (tells || !remark).then_some((names, columns))
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

/// Rows evenly spread over the text from an offset on.
fn sampled(window: &Window<'_>, from: u64) -> Result<Vec<Vec<u8>>, String> {
    let length = window.size().saturating_sub(from);
    let many = SAMPLES as u64;
    let mut lines = Vec::new();
    let mut next = from;
    for k in 0..many {
        // Past the line that the place falls into, but for the first and for one that is past it already.
        let place = from + length / many * k + length % many * k / many;
        let within = place > next;
        let start = if within { place - 1 } else { next };
        let found = window.look_at(start, |bytes, all| {
            let at = match bytes.iter().position(|&byte| is_line_end(byte)) {
                _ if !within => 0,
                Some(end) => end + 1,
                None => bytes.len(),
            };
            let mut rows = Lines { bytes, at };
            // Few lines between rows are something else.
            let row = rows.by_ref().take(8).find_map(|(_, line)| {
                let line = without_remark(line);
                matches!(kind_of(line), Line::Numbers).then(|| line.to_vec())
            });
            // What the bytes end in may go on.
            let whole = rows.at < bytes.len() || all;
            whole.then_some((start + rows.at as u64, row))
        })?;
        let Some((after, row)) = found else { break };
        if start >= window.size() {
            break;
        }
        lines.extend(row);
        next = after;
    }
    Ok(lines)
}

/// A line up to the remark at its end.
fn without_remark(line: &[u8]) -> &[u8] {
    let end = line.iter().position(|&byte| is_remark(byte));
    line.get(..end.unwrap_or(line.len())).unwrap_or(line)
}

/// What the columns of a table hold, by their names or by its rows.
fn columns_of(start: &Start, samples: &[&[u8]], dialect: Dialect, labelled: bool) -> Columns {
    let mut counts: Vec<usize> = samples
        .iter()
        .map(|line| Fields::of(line, dialect).count())
        .collect();
    counts.sort_unstable();
    let usual = counts.get(counts.len() / 2).copied().unwrap_or(3);
    let rows = |used: [usize; 3]| -> Vec<Vec<f64>> {
        let rows = samples.iter().map(|line| {
            let fields = Fields::of(line, dialect);
            let numbers = fields.map(|field| number_of(field, dialect).unwrap_or(f64::NAN));
            numbers.collect()
        });
        let is_usable = |row: &Vec<f64>| {
            let finite = |&at: &usize| row.get(at).is_some_and(|value| value.is_finite());
            row.len() >= usual && used.iter().all(finite)
        };
        rows.filter(is_usable).collect()
    };
    let Some((names, mut columns)) = start.named(usual, dialect) else {
        return Columns::guessed(&rows([0, 1, 2]), labelled);
    };
    if columns.label.is_none() {
        columns.look_for_labels(&names, &rows(columns.coordinates));
    }
    columns
}

/// The rows that were read so far.
struct Rows {
    kept: Kept,
    /// Offset of the first row in the text.
    begin: u64,
    dialect: Dialect,
    columns: Columns,
    points: Vec<Point>,
    /// One a point, where there is a column of them.
    labels: Vec<i32>,
    broken: Vec<u32>,
}

impl Rows {
    fn count(&self) -> usize {
        self.points.len() + self.broken.len()
    }

    /// Takes the lines of the window between two offsets; whether no more are wanted.
    fn take(&mut self, file: &str, window: &Window<'_>, from: usize, to: usize) -> bool {
        let bytes = window.bytes().get(..to).unwrap_or_default();
        let kept = std::mem::take(&mut self.kept);
        let mut reader = Reader {
            findings: Findings::resume(file, bytes, window.lines(), kept),
            bytes,
            rest: window.size() - window.from(),
            read: window.from().saturating_sub(self.begin),
            from: usize::try_from(self.begin.saturating_sub(window.from())).unwrap_or(0),
            dialect: self.dialect,
            rows: self,
        };
        let is_enough = reader.lines(from);
        self.kept = reader.findings.pause();
        is_enough
    }

    fn finish(mut self, file: &str, start: &Start) -> (CloudFile, Vec<Diagnostic>) {
        let mut findings = Findings::resume(file, &[], 0, std::mem::take(&mut self.kept));
        let rows = self.count();
        if self.points.is_empty() {
            let line = start.names.as_ref().map_or(&[][..], |(line, _)| line);
            let keyword = line.get(..9);
            let other = keyword.is_some_and(|word| word.eq_ignore_ascii_case(b"primitive"));
            findings.add_whole(if other { &OTHER_FILE } else { &NO_POINTS }, String::new());
        } else if let Some(count) = start.count.filter(|&count| count != rows as u64) {
            findings.add_whole(&MISCOUNTED, format!("{count} said, {rows} found"));
        }
        // The first rows may be shorter than the others, and the guess by them too large.
        self.points.shrink_to_fit();
        self.labels.shrink_to_fit();
        let numbering = Numbering::with_broken(rows, self.broken);
        let file = CloudFile {
            cloud: Cloud::numbered(self.points, numbering),
            segments: self.columns.label.map(|_| by_label(&self.labels)),
        };
        (file, findings.finish_rows(rows))
    }
}

/// Reads the rows that are in memory.
struct Reader<'a, 'r> {
    findings: Findings<'a>,
    bytes: &'a [u8],
    /// Bytes of the text from these on.
    rest: u64,
    /// Bytes of rows before these, and where in these rows begin.
    read: u64,
    from: usize,
    dialect: Dialect,
    rows: &'r mut Rows,
}

impl Reader<'_, '_> {
    fn lines(&mut self, from: usize) -> bool {
        let bytes = self.bytes;
        for (at, whole) in (Lines { bytes, at: from }) {
            let line = without_remark(whole);
            if line.trim_ascii().is_empty() || line.trim_ascii_start().starts_with(b"//") {
                continue;
            }
            if self.rows.count() >= MAX_POINTS {
                self.findings.add(&TOO_MANY, at);
                return true;
            }
            let room = self.rows.points.capacity();
            if self.rows.points.len() >= super::ROWS_TO_JUDGE_BY.max(room) {
                self.reserve(at);
            }
            self.row(at, line);
        }
        false
    }

    /// Makes room for as many points as the text can be expected to hold by the rows so far.
    fn reserve(&mut self, at: usize) {
        let read = self.read + at.saturating_sub(self.from) as u64;
        let row = (read / self.rows.count().max(1) as u64).max(1);
        let rest = self.rest.saturating_sub(at as u64) / row;
        let rest = usize::try_from(rest + rest / 16 + 1).unwrap_or(MAX_POINTS);
        let rest = rest.min(MAX_POINTS);
        self.rows.points.reserve_exact(rest);
        if self.rows.columns.label.is_some() {
            let missing = self.rows.points.capacity() - self.rows.labels.len();
            self.rows.labels.reserve_exact(missing);
        }
    }

    fn row(&mut self, at: usize, line: &[u8]) {
        let dialect = self.dialect;
        let columns = &self.rows.columns;
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
                self.push(at, Point::new(x, y, z), label);
            }
            _ => self.break_row(at, line, wrong, count),
        }
    }

    fn push(&mut self, at: usize, point: Point, label: Option<f64>) {
        // NaN is in no range, and infinities are not read.
        if point.coords.amax() > LARGEST {
            self.findings
                .add_row(&TOO_FAR, at, || scan::excerpt(self.bytes, at));
            self.rows.broken.push(self.rows.count() as u32);
            return;
        }
        self.rows.points.push(point);
        if self.rows.columns.label.is_some() {
            let known = label.filter(|&value| is_label_value(value));
            if known.is_none() {
                self.findings
                    .add_row(&BAD_LABEL, at, || scan::excerpt(self.bytes, at));
            }
            self.rows
                .labels
                .push(known.map_or(NO_LABEL, |value| value as i32));
        }
    }

    /// A line that is no point: a row that keeps its number, or words that have none.
    fn break_row(&mut self, at: usize, line: &[u8], wrong: Option<usize>, count: usize) {
        let (bytes, dialect) = (self.bytes, self.dialect);
        let columns = self.rows.columns.len();
        let some_number = Fields::of(line, dialect).any(|field| is_number_like(field, dialect));
        if matches!(kind_of(line), Line::Words) && !some_number && count != columns {
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
        self.rows.broken.push(self.rows.count() as u32);
    }
}
