//! Vertices of meshes: OBJ and STL.

use super::gather::Gather;
use super::kinds::CUT_OFF;
use crate::diagnostics::Diagnostic;
use crate::format::cloud::CloudFile;
use crate::format::findings::Findings;
use crate::format::number;

/// Whether a text is Wavefront's OBJ: its first line that is no remark begins as one of OBJ's does,
/// and a vertex follows.
pub(super) fn is_obj(bytes: &[u8]) -> bool {
    let window = bytes.get(..1 << 16).unwrap_or(bytes);
    let mut lines = window
        .split(|&byte| matches!(byte, b'\n' | b'\r'))
        .map(<[u8]>::trim_ascii)
        .filter(|line| !line.is_empty() && !line.starts_with(b"#"));
    const STATEMENTS: [&[u8]; 12] = [
        b"v", b"vn", b"vt", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl",
    ];
    let word = |line: &[u8]| STATEMENTS.contains(&first_word(line));
    let first: Vec<&[u8]> = lines.by_ref().take(50).collect();
    first.first().is_some_and(|line| word(line))
        && first
            .iter()
            .chain(&lines.take(400).collect::<Vec<_>>())
            .any(|line| first_word(line) == b"v")
}

fn first_word(line: &[u8]) -> &[u8] {
    line.split(u8::is_ascii_whitespace)
        .next()
        .unwrap_or_default()
}

fn numbers(words: &[u8]) -> [f64; 3] {
    let mut row = [f64::NAN; 3];
    let words = words
        .split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty());
    for (slot, word) in row.iter_mut().zip(words) {
        if let Some((value, end)) = number::read(word, 0)
            && end == word.len()
        {
            *slot = value;
        }
    }
    row
}

/// The vertices of an OBJ file, numbered as its faces number them.
pub(super) fn read_obj(findings: Findings<'_>, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    // A vertex takes eight bytes at least: `v 0 0 0` and the end of its line.
    let mut gather = Gather::new(findings, bytes.len() / 24, false);
    for line in bytes.split(|&byte| matches!(byte, b'\n' | b'\r')) {
        let line = line.trim_ascii_start();
        if let Some(rest) = line.strip_prefix(b"v")
            && rest.first().is_some_and(u8::is_ascii_whitespace)
        {
            if !gather.has_room() {
                break;
            }
            gather.push(numbers(rest), None);
        }
    }
    gather.finish()
}

/// Bytes of a triangle in binary STL, and of what comes before the first.
const TRIANGLE: usize = 50;
const STL_HEAD: usize = 84;

/// How many triangles a binary STL says it has, where its length says so too, or nearly.
fn triangles(bytes: &[u8]) -> Option<usize> {
    triangles_in(bytes, bytes.len() as u64)
}

fn triangles_in(head: &[u8], size: u64) -> Option<usize> {
    let count: [u8; 4] = head.get(80..84)?.try_into().ok()?;
    let count = u32::from_le_bytes(count);
    let length = u64::from(count) * TRIANGLE as u64 + STL_HEAD as u64;
    (count > 0 && length == size).then_some(usize::try_from(count).ok()?)
}

/// Whether a file of so many bytes is binary STL, by how it begins.
pub(super) fn is_binary_stl(head: &[u8], size: u64) -> bool {
    triangles_in(head, size).is_some()
}

/// Whether bytes are STL, text or binary.
pub(super) fn is_stl(bytes: &[u8], named: bool) -> bool {
    let text = || {
        let window = bytes.get(..1 << 12).unwrap_or(bytes);
        let lower = window.to_ascii_lowercase();
        lower.trim_ascii_start().starts_with(b"solid")
            && lower.windows(5).any(|five| five == b"facet")
    };
    triangles(bytes).is_some() || text() || (named && bytes.len() >= STL_HEAD)
}

/// The distinct vertices of an STL file, in the order in which they first come.
pub(super) fn read_stl(mut findings: Findings<'_>, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let lower_head: Vec<u8> = bytes.get(..1 << 12).unwrap_or(bytes).to_ascii_lowercase();
    let is_text = triangles(bytes).is_none()
        && lower_head.trim_ascii_start().starts_with(b"solid")
        && lower_head.windows(5).any(|five| five == b"facet");
    if is_text {
        for line in bytes.split(|&byte| matches!(byte, b'\n' | b'\r')) {
            let line = line.trim_ascii_start();
            if let Some((word, rest)) = line.split_at_checked(6)
                && word.eq_ignore_ascii_case(b"vertex")
            {
                corners.push(numbers(rest));
            }
        }
    } else {
        let there = bytes.len().saturating_sub(STL_HEAD) / TRIANGLE;
        let said = bytes.get(80..84).and_then(|four| four.try_into().ok());
        let said = said.map_or(0, u32::from_le_bytes) as usize;
        if said > there {
            findings.add_whole(&CUT_OFF, format!("{there} triangles of {said}"));
        }
        for triangle in bytes
            .get(STL_HEAD..)
            .unwrap_or_default()
            .chunks_exact(TRIANGLE)
            .take(said)
        {
            let (floats, _) = triangle.as_chunks::<4>();
            let floats: Vec<f64> = floats
                .iter()
                .map(|&four| f64::from(f32::from_le_bytes(four)))
                .collect();
            let (_, vertices) = floats.split_at(3);
            corners.extend(vertices.as_chunks::<3>().0);
        }
    }
    let kept = first_of_each(&corners);
    let mut gather = Gather::new(findings, kept.len(), false);
    for &place in &kept {
        if !gather.has_room() {
            break;
        }
        gather.push(
            corners
                .get(place as usize)
                .copied()
                .unwrap_or([f64::NAN; 3]),
            None,
        );
    }
    gather.finish()
}

/// Places of the first of equal corners, in their order. O(n log n).
fn first_of_each(corners: &[[f64; 3]]) -> Vec<u32> {
    let key = |place: u32| {
        let corner = corners.get(place as usize).copied().unwrap_or_default();
        // A zero is one whatever its sign.
        corner.map(|value| (value + 0.0).to_bits())
    };
    let mut places: Vec<u32> = (0u32..).take(corners.len()).collect();
    places.sort_by_key(|&place| (key(place), place));
    places.dedup_by_key(|place| key(*place));
    places.sort_unstable();
    places
}
