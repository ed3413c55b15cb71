//! One cloud of many that hold the points of one primitive each.

use super::name::of_path;
use crate::cloud::{Cloud, Numbering, Point};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::CloudFile;
use crate::format::cloud::kinds::TOO_MANY;
use crate::format::findings::Findings;
use crate::format::labels::Segment;
use crate::format::limits::MAX_POINTS;

/// Clouds put behind each other: rows count on from one to the next, and each whose name tells a type is a
/// segment.
#[derive(Debug, Default)]
pub(in crate::format) struct Union {
    points: Vec<Point>,
    rows: usize,
    broken: Vec<u32>,
    segments: Vec<Segment>,
    pieces: u32,
}

impl Union {
    /// Adds the cloud of a file. One with which there were too many points is left out, and that is told.
    pub(in crate::format) fn add(&mut self, path: &str, cloud: &Cloud) -> Vec<Diagnostic> {
        let kind = of_path(path).and_then(|name| name.kind);
        self.pieces += u32::from(kind.is_some());
        let rows = self.rows + cloud.numbering().rows();
        if rows > MAX_POINTS {
            let mut findings = Findings::new(path, &[]);
            findings.add_whole(&TOO_MANY, format!("{rows} with the files before it"));
            return findings.finish();
        }
        let start = self.points.len() as u32;
        self.points.extend_from_slice(cloud.points());
        let end = self.points.len() as u32;
        let broken = cloud.numbering().broken().iter();
        self.broken.extend(broken.map(|row| self.rows as u32 + row));
        self.rows = rows;
        if kind.is_some() && end > start {
            self.segments.push(Segment {
                number: self.pieces,
                kind,
                points: (start..end).collect(),
            });
        }
        Vec::new()
    }

    /// The cloud of all.
    pub(in crate::format) fn finish(self) -> CloudFile {
        let numbering = Numbering::with_broken(self.rows, self.broken);
        CloudFile {
            cloud: Cloud::numbered(self.points, numbering),
            segments: Some(self.segments),
        }
    }
}
