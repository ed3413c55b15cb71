//! Points as they come out of files of fixed columns, row by row.

use crate::cloud::{Cloud, LARGEST, Numbering, Point};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::kinds::TOO_MANY;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::{Findings, Kind};
use crate::format::labels::is_label_value;
use crate::format::labels::{NO_LABEL, by_label};
use crate::format::limits::MAX_POINTS;

use super::kinds;

/// Takes rows and keeps what is wrong with them, one finding a fault.
pub(super) struct Gather<'a> {
    findings: Findings<'a>,
    points: Vec<Point>,
    labels: Option<Vec<i32>>,
    broken: Vec<u32>,
    /// How many of each fault, and the first row that has it.
    broken_rows: (usize, usize),
    unlabelled: (usize, usize),
}

impl<'a> Gather<'a> {
    /// For `rows` rows, of which no more are made room for than could be.
    pub(super) fn new(findings: Findings<'a>, rows: usize, labelled: bool) -> Self {
        let room = rows.min(MAX_POINTS);
        Self {
            findings,
            points: Vec::with_capacity(room),
            labels: labelled.then(|| Vec::with_capacity(room)),
            broken: Vec::new(),
            broken_rows: (0, 0),
            unlabelled: (0, 0),
        }
    }

    pub(super) fn findings(&mut self) -> &mut Findings<'a> {
        &mut self.findings
    }

    /// The points so far.
    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    /// Says what the columns are taken for, where there are more than coordinates.
    pub(super) fn tell_columns(&mut self, columns: &Columns) {
        let besides = columns.besides();
        if !besides.is_empty() {
            self.findings.add_whole(&kinds::COLUMNS, besides);
        }
    }

    pub(super) fn rows(&self) -> usize {
        self.points.len() + self.broken.len()
    }

    /// Whether there is room for one more; says so once where there is none.
    pub(super) fn has_room(&mut self) -> bool {
        if self.rows() < MAX_POINTS {
            return true;
        }
        self.findings.add_whole(&TOO_MANY, String::new());
        false
    }

    /// Takes a row; one that is not three numbers to compute with keeps its number and has no point.
    pub(super) fn push(&mut self, row: [f64; 3], label: Option<f64>) {
        let number = self.rows() + 1;
        // NaN is in no range.
        if !row.iter().all(|value| value.abs() <= LARGEST) {
            self.broken.push(self.rows() as u32);
            count(&mut self.broken_rows, number);
            return;
        }
        self.points.push(Point::from(row));
        if let Some(labels) = &mut self.labels {
            let known = label.filter(|&value| is_label_value(value));
            if known.is_none() {
                count(&mut self.unlabelled, number);
            }
            labels.push(known.map_or(NO_LABEL, |value| value as i32));
        }
    }

    pub(super) fn finish(mut self) -> (CloudFile, Vec<Diagnostic>) {
        let rows = self.rows();
        let mut tell = |kind: &Kind, (count, first): (usize, usize)| {
            if count > 0 {
                let found = format!("{count} of {rows}, first row {first}");
                self.findings.add_whole(kind, found);
            }
        };
        tell(&kinds::BROKEN_ROWS, self.broken_rows);
        tell(&kinds::BAD_LABELS, self.unlabelled);
        if self.points.is_empty() {
            self.findings.add_whole(&kinds::NO_POINTS, String::new());
        }
        self.points.shrink_to_fit();
        let file = CloudFile {
            cloud: Cloud::numbered(self.points, Numbering::with_broken(rows, self.broken)),
            segments: self.labels.map(|labels| by_label(&labels)),
        };
        (file, self.findings.finish())
    }
}

fn count((count, first): &mut (usize, usize), row: usize) {
    if *count == 0 {
        *first = row;
    }
    *count += 1;
}
