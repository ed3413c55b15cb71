//! Vertices of meshes: OBJ and STL.

use super::distinct::Distinct;
use super::gather::Gather;
use super::kinds::CUT_OFF;
use crate::diagnostics::Diagnostic;
use crate::format::cloud::CloudFile;
use crate::format::findings::Findings;
use crate::format::number;
use crate::format::window::Window;

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
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read_obj(
    findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    // Counted first, for room to be made that is large enough and no larger.
    let mut count = 0;
    window.again()?.each_line(0, |line| {
        count += usize::from(vertex(line).is_some());
        true
    })?;
    let mut gather = Gather::new(findings, count, false);
    window.each_line(0, |line| {
        let Some(numbers) = vertex(line) else {
            return true;
        };
        let has_room = gather.has_room();
        if has_room {
            gather.push(self::numbers(numbers), None);
        }
        has_room
    })?;
    Ok(gather.finish())
}

/// What follows `v` in a line of OBJ that is a vertex.
fn vertex(line: &[u8]) -> Option<&[u8]> {
    let rest = line.trim_ascii_start().strip_prefix(b"v")?;
    rest.first()
        .is_some_and(u8::is_ascii_whitespace)
        .then_some(rest)
}

/// Bytes of a triangle in binary STL, and of what comes before the first.
const TRIANGLE: usize = 50;
const STL_HEAD: usize = 84;

/// What a triangle takes in text, about.
const TRIANGLE_OF_TEXT: u64 = 250;

/// Vertices of so many triangles: of a closed surface half as many, and two more for each shell (Euler). Room for
/// a few more is left, as too little would be made twice as large.
fn vertices_of(triangles: u64) -> usize {
    usize::try_from(triangles / 2 + triangles / 16 + 16).unwrap_or(usize::MAX)
}

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
    triangles(bytes).is_some() || is_text_stl(bytes) || (named && bytes.len() >= STL_HEAD)
}

fn is_text_stl(bytes: &[u8]) -> bool {
    let window = bytes.get(..1 << 12).unwrap_or(bytes);
    let lower = window.to_ascii_lowercase();
    lower.trim_ascii_start().starts_with(b"solid") && lower.windows(5).any(|five| five == b"facet")
}

/// The distinct vertices of an STL file, in the order in which they first come.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read_stl(
    mut findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    window.reach(1 << 12)?;
    if !is_binary_stl(window.bytes(), window.size()) && is_text_stl(window.bytes()) {
        let room = vertices_of(window.size() / TRIANGLE_OF_TEXT);
        let mut vertices = Distinct::new(Gather::new(findings, room, false));
        window.each_line(0, |line| {
            let line = line.trim_ascii_start();
            match line.split_at_checked(6) {
                Some((word, rest)) if word.eq_ignore_ascii_case(b"vertex") => {
                    vertices.push(numbers(rest))
                }
                _ => true,
            }
        })?;
        return Ok(vertices.finish());
    }
    let there = window.size().saturating_sub(STL_HEAD as u64) / TRIANGLE as u64;
    let said = window
        .bytes()
        .get(80..84)
        .and_then(|four| four.try_into().ok());
    let said = u64::from(said.map_or(0, u32::from_le_bytes));
    if said > there {
        findings.add_whole(&CUT_OFF, format!("{there} triangles of {said}"));
    }
    let room = vertices_of(said.min(there));
    let mut vertices = Distinct::new(Gather::new(findings, room, false));
    let mut at = STL_HEAD;
    for _ in 0..said {
        let Some(triangle) = window.row(&mut at, TRIANGLE)? else {
            break;
        };
        // The first three are the normal.
        let (floats, _) = triangle.as_chunks::<4>();
        let (corners, _) = floats.get(3..).unwrap_or_default().as_chunks::<3>();
        let corner = |four: [u8; 4]| f64::from(f32::from_le_bytes(four));
        if !corners.iter().all(|it| vertices.push(it.map(corner))) {
            break;
        }
    }
    Ok(vertices.finish())
}
