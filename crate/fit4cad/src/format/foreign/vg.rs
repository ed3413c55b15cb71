//! Vertex groups (`.vg`) of Easy3D, PolyFit, Mapple and CGAL: points, and for each primitive its type
//! and the points of it, counted from 0.

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::CloudFile;
use crate::format::findings::Findings;
use crate::format::labels::Segment;
use crate::format::limits::{MAX_INDICES, MAX_PRIMITIVES};
use crate::format::number;
use crate::surface::SurfaceType;

/// Types by their numbers in these files; what has none is a surface of another kind.
pub const TYPES: [SurfaceType; 5] = [
    SurfaceType::Plane,
    SurfaceType::Cylinder,
    SurfaceType::Sphere,
    SurfaceType::Cone,
    SurfaceType::Torus,
];

pub(super) fn is_vg(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(b"num_points")
}

struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    fn skip(&mut self) {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == b':';
        self.at += rest.iter().take_while(|byte| blank(byte)).count();
    }

    fn next(&mut self) -> Option<&'a [u8]> {
        self.skip();
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let length = rest
            .iter()
            .position(|byte| byte.is_ascii_whitespace() || *byte == b':')
            .unwrap_or(rest.len());
        self.at += length;
        rest.get(..length)
    }

    fn number(&mut self) -> Option<f64> {
        let word = self.next()?;
        let (value, end) = number::read(word, 0)?;
        (end == word.len()).then_some(value)
    }

    fn count(&mut self) -> Option<usize> {
        let value = self.number()?;
        (value >= 0.0 && value.fract() == 0.0).then_some(value as usize)
    }

    /// To the end of the line.
    fn rest_of_line(&mut self) {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        self.at += rest
            .iter()
            .take_while(|byte| !matches!(byte, b'\n' | b'\r'))
            .count();
    }
}

/// Reads points and groups.
pub(super) fn read(findings: Findings<'_>, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    let mut words = Words { bytes, at: 0 };
    let mut gather = Gather::new(findings, bytes.len() / 24, false);
    let groups = body(&mut words, &mut gather);
    let rows = gather.rows();
    if groups.is_none() {
        gather
            .findings()
            .add_whole(&CUT_OFF, format!("{rows} points"));
    }
    let (mut file, findings) = gather.finish();
    let mut segments = groups.unwrap_or_default();
    let numbering = file.cloud.numbering();
    for segment in &mut segments {
        // Indices are of rows.
        let rows = std::mem::take(&mut segment.points).into_iter();
        let resolved = rows.filter_map(|row| match numbering.resolve(u64::from(row) + 1) {
            crate::cloud::PointNumber::Index(index) => Some(index),
            _ => None,
        });
        segment.points = resolved.collect();
        segment.points.sort_unstable();
        segment.points.dedup();
    }
    file.segments = Some(segments);
    (file, findings)
}

fn body(words: &mut Words<'_>, gather: &mut Gather<'_>) -> Option<Vec<Segment>> {
    let mut groups: Vec<Segment> = Vec::new();
    let mut kind = None;
    let mut listed = 0;
    while let Some(key) = words.next() {
        match key {
            b"num_points" => {
                for _ in 0..words.count()? {
                    if !gather.has_room() {
                        return Some(groups);
                    }
                    let row = [words.number()?, words.number()?, words.number()?];
                    gather.push(row, None);
                }
            }
            b"num_colors" | b"num_normals" => {
                for _ in 0..words.count()?.checked_mul(3)? {
                    words.next()?;
                }
            }
            b"group_type" => kind = words.count().and_then(|at| TYPES.get(at)).copied(),
            // Easy3D writes the one, its documentation says the other.
            b"group_num_point" | b"group_num_points" => {
                let mut points = Vec::new();
                for _ in 0..words.count()? {
                    listed += 1;
                    if listed > MAX_INDICES {
                        return Some(groups);
                    }
                    points.push(u32::try_from(words.count()?).ok()?);
                }
                if groups.len() >= MAX_PRIMITIVES {
                    return Some(groups);
                }
                groups.push(Segment {
                    number: groups.len() as u32 + 1,
                    kind: kind.take(),
                    points,
                });
            }
            b"num_groups"
            | b"num_group_parameters"
            | b"group_parameters"
            | b"group_label"
            | b"group_color"
            | b"num_children" => words.rest_of_line(),
            // Numbers of something unknown.
            _ if number::read(key, 0).is_some() => {}
            _ => {
                let found = String::from_utf8_lossy(key).chars().take(40).collect();
                gather.findings().add_whole(&BAD_HEADER, found);
                words.rest_of_line();
            }
        }
    }
    Some(groups)
}
