//! PCD of the Point Cloud Library, version 0.7 and before: text, binary, or compressed by LZF.

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF, NO_COORDINATES, PACKED_BADLY};
use super::lzf;
use super::scalar::{Kind, Scalar};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::Findings;
use crate::format::limits::MAX_FILE_BYTES;
use crate::format::number;
use crate::format::window::Window;

/// Longest head that is read, in bytes.
const LONGEST_HEAD: usize = 1 << 16;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Data {
    Text,
    Binary,
    Compressed,
}

/// Where the numbers of one column lie in binary data.
#[derive(Debug, Clone, Copy)]
struct Column {
    scalar: Scalar,
    /// Bytes before it in a row.
    offset: usize,
}

#[derive(Debug, Default)]
struct Head {
    fields: Vec<String>,
    sizes: Vec<usize>,
    kinds: Vec<Kind>,
    counts: Vec<usize>,
    width: u64,
    height: u64,
    points: Option<u64>,
}

/// Reads a PCD file; what is compressed lies column after column in one block, and is held whole.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read(
    mut findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    let nothing = |findings: Findings<'_>| Ok((CloudFile::default(), findings.finish()));
    window.reach(LONGEST_HEAD)?;
    let (head, data, start) = match Head::read(window.bytes()) {
        Ok(read) => read,
        Err(line) => {
            findings.add_whole(&BAD_HEADER, line);
            return nothing(findings);
        }
    };
    let Some((names, layout, row_size)) = head.layout() else {
        findings.add_whole(&BAD_HEADER, head.fields.join(" "));
        return nothing(findings);
    };
    let has = |axis: &str| names.iter().any(|name| name.eq_ignore_ascii_case(axis));
    let columns = Columns::named(&names).filter(|_| has("x") && has("y") && has("z"));
    let Some(columns) = columns else {
        findings.add_whole(&NO_COORDINATES, names.join(" "));
        return nothing(findings);
    };
    let said = head
        .points
        .unwrap_or(head.width.saturating_mul(head.height.max(1)));
    let body = match data {
        Data::Compressed => {
            window.reach(usize::MAX)?;
            let Some(body) = unpacked(window.bytes().get(start..).unwrap_or_default()) else {
                findings.add_whole(&PACKED_BADLY, String::new());
                return nothing(findings);
            };
            Some(body)
        }
        Data::Text | Data::Binary => None,
    };
    let least = if data == Data::Text { 2 } else { row_size };
    let rest = window.size().saturating_sub(start as u64);
    let there = body.as_ref().map_or(rest, |body| body.len() as u64) / least.max(1) as u64;
    let rows = usize::try_from(said.min(there)).unwrap_or(usize::MAX);
    let mut gather = Gather::new(findings, rows, columns.label.is_some());
    gather.tell_columns(&columns);
    match (data, body) {
        (Data::Text, _) => text(&mut gather, window, start, said, &columns)?,
        (_, Some(body)) => by_columns(&mut gather, &body, rows, &columns, &layout),
        (_, None) => {
            let mut at = start;
            while gather.rows() < rows && gather.has_room() {
                let Some(row) = window.row(&mut at, row_size)? else {
                    break;
                };
                let value = |column: usize| {
                    let Column { scalar, offset } = *layout.get(column)?;
                    scalar.read(row, offset)
                };
                push(&mut gather, &columns, value);
            }
        }
    }
    if (gather.rows() as u64) < said && gather.has_room() {
        let found = format!("{} points of {said}", gather.rows());
        gather.findings().add_whole(&CUT_OFF, found);
    }
    Ok(gather.finish())
}

fn push(gather: &mut Gather<'_>, columns: &Columns, value: impl Fn(usize) -> Option<f64>) {
    let row = columns
        .coordinates
        .map(|column| value(column).unwrap_or(f64::NAN));
    gather.push(row, columns.label.and_then(value));
}

fn text(
    gather: &mut Gather<'_>,
    window: &mut Window<'_>,
    start: usize,
    said: u64,
    columns: &Columns,
) -> Result<(), String> {
    window.each_line(start, |line| {
        let line = line.trim_ascii();
        if line.is_empty() {
            return true;
        }
        if gather.rows() as u64 >= said || !gather.has_room() {
            return false;
        }
        let mut row = [f64::NAN; 3];
        let mut label = None;
        let words = line
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        for (column, word) in words.enumerate() {
            let value = number::read(word, 0).filter(|&(_, end)| end == word.len());
            let value = value.map_or(f64::NAN, |(value, _)| value);
            if let Some(axis) = columns.coordinates.iter().position(|&axis| axis == column) {
                row[axis] = value;
            } else if Some(column) == columns.label {
                label = Some(value);
            }
        }
        gather.push(row, label);
        true
    })
}

/// Rows of data that lies column after column: those before a column take so many bytes a row.
fn by_columns(
    gather: &mut Gather<'_>,
    body: &[u8],
    rows: usize,
    columns: &Columns,
    layout: &[Column],
) {
    for row in 0..rows {
        if !gather.has_room() {
            return;
        }
        push(gather, columns, |column| {
            let Column { scalar, offset } = *layout.get(column)?;
            let at = offset.checked_mul(rows)?.checked_add(row * scalar.size)?;
            scalar.read(body, at)
        });
    }
}

/// What binary_compressed data holds: sizes packed and unpacked, then the packed bytes.
fn unpacked(bytes: &[u8]) -> Option<Vec<u8>> {
    let size = |at: usize| -> Option<usize> {
        let bytes: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
        usize::try_from(u32::from_le_bytes(bytes)).ok()
    };
    let (packed, whole) = (size(0)?, size(4)?);
    if whole as u64 > MAX_FILE_BYTES {
        return None;
    }
    lzf::unpack(bytes.get(8..8usize.checked_add(packed)?)?, whole)
}

impl Head {
    /// The head, how the data is stored and where it begins; or the line that is wrong.
    fn read(bytes: &[u8]) -> Result<(Self, Data, usize), String> {
        let mut head = Self::default();
        let window = bytes.get(..LONGEST_HEAD).unwrap_or(bytes);
        let mut at = 0;
        loop {
            let rest = window.get(at..).unwrap_or_default();
            let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
                return Err("it has no line DATA".to_owned());
            };
            let line = rest.get(..length).unwrap_or_default().trim_ascii();
            at += length + 1;
            let line = String::from_utf8_lossy(line);
            let wrong = || line.chars().take(60).collect::<String>();
            let mut words = line.split_ascii_whitespace();
            let Some(key) = words.next() else { continue };
            let numbers = || -> Option<Vec<u64>> {
                let words = line.split_ascii_whitespace().skip(1);
                words.map(|word| word.parse().ok()).collect()
            };
            let sizes = || -> Option<Vec<usize>> {
                let numbers = numbers()?.into_iter();
                numbers.map(|it| usize::try_from(it).ok()).collect()
            };
            let first = || numbers().and_then(|all| all.first().copied());
            match key {
                "FIELDS" | "COLUMNS" => head.fields = words.map(str::to_owned).collect(),
                "SIZE" => head.sizes = sizes().ok_or_else(wrong)?,
                "COUNT" => head.counts = sizes().ok_or_else(wrong)?,
                "TYPE" => {
                    let kinds = words.map(|word| match word {
                        "I" => Some(Kind::Signed),
                        "U" => Some(Kind::Unsigned),
                        "F" => Some(Kind::Float),
                        _ => None,
                    });
                    head.kinds = kinds.collect::<Option<_>>().ok_or_else(wrong)?;
                }
                "WIDTH" => head.width = first().ok_or_else(wrong)?,
                "HEIGHT" => head.height = first().ok_or_else(wrong)?,
                "POINTS" => head.points = Some(first().ok_or_else(wrong)?),
                "DATA" => {
                    let data = match words.next() {
                        Some("ascii") => Data::Text,
                        Some("binary") => Data::Binary,
                        Some("binary_compressed") => Data::Compressed,
                        _ => return Err(wrong()),
                    };
                    return Ok((head, data, at));
                }
                "VERSION" | "VIEWPOINT" => {}
                _ if key.starts_with('#') => {}
                _ => return Err(wrong()),
            }
        }
    }

    /// Name and place of every column, and the bytes of a row.
    fn layout(&self) -> Option<(Vec<String>, Vec<Column>, usize)> {
        /// More numbers in a row than any program writes.
        const MOST: usize = 4096;
        let (mut names, mut columns, mut offset) = (Vec::new(), Vec::new(), 0usize);
        for (place, field) in self.fields.iter().enumerate() {
            let (size, kind) = (*self.sizes.get(place)?, *self.kinds.get(place)?);
            let count = self.counts.get(place).copied().unwrap_or(1);
            if count > MOST || columns.len() > MOST {
                return None;
            }
            let scalar = Scalar::new(kind, size, false)?;
            for _ in 0..count {
                names.push(field.clone());
                columns.push(Column { scalar, offset });
                offset = offset.checked_add(size)?;
            }
        }
        (!columns.is_empty()).then_some((names, columns, offset))
    }
}

/// Whether the points of a PCD file, by how it begins, are compressed.
pub(super) fn is_compressed(bytes: &[u8]) -> bool {
    matches!(Head::read(bytes), Ok((_, Data::Compressed, _)))
}
