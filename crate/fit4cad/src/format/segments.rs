//! Which points belong together, in whatever form a file says so: the benchmark's lists, a label for
//! each point, a cloud of the same points with labels or groups.

use super::cloud::{CloudFile, read_cloud_with};
use super::encoding;
use super::findings::{Findings, Kind};
use super::foreign::{Content, Purpose, read_foreign};
use super::labels::{NO_LABEL, Segment, by_label, is_label_value};
use super::number;
use super::one_a_row::{Values, number_of};
use super::primitives::{PointList, read_primitives};
use super::scan::{is_remark, is_separator};
use crate::cloud::neighbours::KdTree;
use crate::cloud::{Cloud, Numbering, PointNumber};
use crate::diagnostics::{Diagnostic, Position, Severity, Subject};

impl From<Segment> for PointList {
    fn from(segment: Segment) -> Self {
        Self {
            number: segment.number,
            points: segment.points,
            position: Position { line: 1, column: 1 },
        }
    }
}

const LABEL_COUNT: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "There is not one label for each row of the cloud, so the file is not used",
    expected: "",
    hint: "Check that the file belongs to this cloud",
};
const BAD_LABEL: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Warning,
    message: "A label could not be read",
    expected: "a whole number, -1 for none",
    hint: "The point belongs to no segment",
};
const NO_SEGMENTS: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file holds points and no segments of them",
    expected: "a column of labels, one whole number a point",
    hint: "If it is a cloud of its own, set its role",
};
const OTHER_CLOUD: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file's points are not those of the cloud, so it is not used",
    expected: "",
    hint: "Check that the file belongs to this cloud",
};
const SOME_ELSEWHERE: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Warning,
    message: "Some of the file's points are not in the cloud",
    expected: "",
    hint: "They are left out",
};

/// What a file says about which points belong together; nothing where it cannot be used, and the
/// findings say why.
pub(super) type Segments = (Option<Vec<Segment>>, Vec<Diagnostic>);

/// Reads the segments of a cloud from a file, told by its content; `None` where it is in the benchmark's
/// own form, if any.
pub(super) fn read_segments(
    file: &str,
    bytes: &[u8],
    cloud: &Cloud,
    purpose: Purpose,
) -> Option<Segments> {
    match read_foreign(file, bytes, purpose) {
        Some((Content::Cloud(other), findings)) => Some(onto(file, &other, findings, cloud)),
        Some((Content::Labels(labels, kinds), findings)) => {
            let mut own = Findings::new(file, &[]);
            let mut found = on_rows(&labels, cloud.numbering(), &mut own);
            for segment in found.iter_mut().flatten() {
                segment.kind = kinds.get(&segment.number).copied();
            }
            Some((found, [findings, own.finish()].concat()))
        }
        Some((Content::Text(text), _)) => {
            Some(read_text(file, &text, cloud).unwrap_or_else(|| {
                let (lists, findings) = read_primitives(file, &text, cloud.numbering());
                let segments = lists.into_iter().map(|list| Segment {
                    number: list.number,
                    kind: None,
                    points: list.points,
                });
                (Some(segments.collect()), findings)
            }))
        }
        None => read_text(file, bytes, cloud),
    }
}

/// Whether a text is of labels, or of points with them, rather than of the benchmark's own form.
pub(super) fn is_of_labels(bytes: &[u8]) -> bool {
    let bytes = &*encoding::utf8(bytes);
    matches!(numbers_in_first_row(bytes), Some(1 | 4..))
}

fn read_text(file: &str, bytes: &[u8], cloud: &Cloud) -> Option<Segments> {
    let bytes = &*encoding::utf8(bytes);
    match numbers_in_first_row(bytes) {
        Some(1) => Some(read_labels(file, bytes, cloud.numbering())),
        Some(4..) => {
            let (other, findings) = read_cloud_with(file, bytes, true);
            Some(onto(file, &other, findings, cloud))
        }
        _ => None,
    }
}

/// How many numbers the first line that has some is made of; `None` where it has something else, but
/// for the names of columns before it.
fn numbers_in_first_row(bytes: &[u8]) -> Option<usize> {
    let lines = bytes.split(|&byte| matches!(byte, b'\n' | b'\r'));
    let lines = lines.map(<[u8]>::trim_ascii);
    let mut rows = lines.filter(|line| line.first().is_some_and(|&byte| !is_remark(byte)));
    let count = |line: &[u8]| {
        let words = line.split(|&byte| is_separator(byte));
        let mut words = words.filter(|word| !word.is_empty()).take(8);
        words.try_fold(0, |count, word| {
            let (_, end) = number::read(word, 0)?;
            (end == word.len()).then_some(count + 1)
        })
    };
    let first = rows.next()?;
    let names_something = first
        .get(..9)
        .unwrap_or(first)
        .eq_ignore_ascii_case(b"primitive");
    match count(first) {
        None if !names_something && !first.contains(&b'=') => count(rows.next()?),
        found => found,
    }
}

/// Reads a label a line.
fn read_labels(file: &str, bytes: &[u8], numbering: &Numbering) -> Segments {
    let mut findings = Findings::new(file, bytes);
    let mut labels = Vec::new();
    for (at, word) in Values::of(bytes) {
        let value = number_of(word);
        let label = value.filter(|&value| is_label_value(value));
        // The name of the column may stand before the first.
        if label.is_some() || !labels.is_empty() || value.is_some() {
            if label.is_none() {
                let found = || String::from_utf8_lossy(word).chars().take(40).collect();
                findings.add_row(&BAD_LABEL, at, found);
            }
            labels.push(label.map_or(NO_LABEL, |value| value as i32));
        }
    }
    // A number of labels before them, as other files of rows begin.
    let rows = numbering.rows();
    if labels.len() == rows + 1 && labels.first().is_some_and(|&first| first as usize == rows) {
        labels.remove(0);
    }
    let found = on_rows(&labels, numbering, &mut findings);
    (found, findings.finish_rows(labels.len()))
}

/// The segments of labels of which each row of a cloud has one.
fn on_rows(
    labels: &[i32],
    numbering: &Numbering,
    findings: &mut Findings<'_>,
) -> Option<Vec<Segment>> {
    let rows = numbering.rows();
    if labels.len() != rows {
        findings.add_whole(
            &LABEL_COUNT,
            format!("{} labels for {rows} rows", labels.len()),
        );
        return None;
    }
    if numbering.is_plain() {
        return Some(by_label(labels));
    }
    let kept = numbering.of_points(labels.iter().copied());
    Some(by_label(&kept.collect::<Vec<i32>>()))
}

/// The segments of another file's points as segments of the cloud: by the numbers of their rows where
/// those have the same coordinates, else by coordinates.
fn onto(
    file: &str,
    other: &CloudFile,
    mut diagnostics: Vec<Diagnostic>,
    cloud: &Cloud,
) -> Segments {
    let mut findings = Findings::new(file, &[]);
    let found = match &other.segments {
        _ if other.cloud.is_empty() => None,
        None => {
            findings.add_whole(&NO_SEGMENTS, format!("{} points", other.cloud.len()));
            None
        }
        Some(segments) => match places(&other.cloud, cloud) {
            Some((places, strangers)) => {
                if strangers > 0 {
                    let found = format!("{strangers} of {}", other.cloud.len());
                    findings.add_whole(&SOME_ELSEWHERE, found);
                }
                Some(moved(segments, &places))
            }
            None => {
                let found = format!("{} points, {} in the cloud", other.cloud.len(), cloud.len());
                findings.add_whole(&OTHER_CLOUD, found);
                None
            }
        },
    };
    diagnostics.extend(findings.finish());
    (found, diagnostics)
}

fn moved(segments: &[Segment], places: &[Option<u32>]) -> Vec<Segment> {
    let segments = segments.iter().map(|segment| {
        let points = segment.points.iter();
        let mut points: Vec<u32> = points
            .filter_map(|&index| places.get(index as usize).copied().flatten())
            .collect();
        points.sort_unstable();
        points.dedup();
        Segment {
            points,
            ..segment.clone()
        }
    });
    segments.collect()
}

/// How far apart, in magnitudes of the largest coordinate, the same point may be in two files: a few
/// times what single precision leaves of it.
pub(super) const SINGLE: f64 = 1e-6;

/// For each point of one cloud its index in another, and how many have none; `None` where that is so
/// of more than half.
fn places(from: &Cloud, to: &Cloud) -> Option<(Vec<Option<u32>>, usize)> {
    let largest = |cloud: &Cloud| {
        let bounds = cloud.bounds();
        bounds.min.coords.amax().max(bounds.max.coords.amax())
    };
    let tolerance = SINGLE * largest(from).max(largest(to));
    let near = |index: u32, place: u32| {
        let a = from.points().get(index as usize);
        let b = to.points().get(place as usize);
        a.zip(b).is_some_and(|(a, b)| (a - b).amax() <= tolerance)
    };
    let count = from.len() as u32;
    if from.numbering().rows() == to.numbering().rows() {
        let by_row =
            (0..count).map(
                |index| match to.numbering().resolve(from.numbering().number(index)) {
                    PointNumber::Index(place) => Some(place).filter(|&place| near(index, place)),
                    _ => None,
                },
            );
        let by_row: Vec<Option<u32>> = by_row.collect();
        let strangers = by_row.iter().filter(|place| place.is_none()).count();
        if 100 * strangers <= from.len() {
            return Some((by_row, strangers));
        }
    }
    let tree = KdTree::new(to.points());
    let mut buffer = Vec::new();
    let by_place = from.points().iter().map(|point| {
        // A corner of the cube of that tolerance is farther than its side.
        tree.nearest(point, 1, 2.0 * tolerance, |_| true, &mut buffer);
        buffer.first().map(|nearest| nearest.index)
    });
    let by_place: Vec<Option<u32>> = by_place.collect();
    let strangers = by_place.iter().filter(|place| place.is_none()).count();
    (2 * strangers <= from.len()).then_some((by_place, strangers))
}
