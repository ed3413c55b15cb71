//! PCD of the Point Cloud Library, version 0.7 and before: text, binary, or compressed by LZF.

use std::borrow::Cow;

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF, NO_COORDINATES, PACKED_BADLY};
use super::lzf;
use super::scalar::{Kind, Scalar};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::Findings;
use crate::format::limits::MAX_FILE_BYTES;
use crate::format::number;

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

/// Reads a PCD file.
pub(super) fn read(mut findings: Findings<'_>, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    let (head, data, start) = match Head::read(bytes) {
        Ok(read) => read,
        Err(line) => {
            findings.add_whole(&BAD_HEADER, line);
            return (CloudFile::default(), findings.finish());
        }
    };
    let Some((names, layout, row_size)) = head.layout() else {
        findings.add_whole(&BAD_HEADER, head.fields.join(" "));
        return (CloudFile::default(), findings.finish());
    };
    let has = |axis: &str| names.iter().any(|name| name.eq_ignore_ascii_case(axis));
    let columns = Columns::named(&names).filter(|_| has("x") && has("y") && has("z"));
    let Some(columns) = columns else {
        findings.add_whole(&NO_COORDINATES, names.join(" "));
        return (CloudFile::default(), findings.finish());
    };
    let said = head
        .points
        .unwrap_or(head.width.saturating_mul(head.height.max(1)));
    let rest = bytes.get(start..).unwrap_or_default();
    let body = match data {
        Data::Compressed => match unpacked(rest) {
            Some(body) => Cow::Owned(body),
            None => {
                findings.add_whole(&PACKED_BADLY, String::new());
                return (CloudFile::default(), findings.finish());
            }
        },
        Data::Text | Data::Binary => Cow::Borrowed(rest),
    };
    let least = if data == Data::Text { 2 } else { row_size };
    let there = body.len() / least.max(1);
    let rows = usize::try_from(said).unwrap_or(usize::MAX).min(there);
    let mut gather = Gather::new(findings, rows, columns.label.is_some());
    gather.tell_columns(&columns);
    if data == Data::Text {
        text(&mut gather, &body, said, &columns);
    } else {
        binary(
            &mut gather,
            &body,
            rows,
            &columns,
            &layout,
            (data, row_size),
        );
    }
    if (gather.rows() as u64) < said && gather.has_room() {
        let found = format!("{} points of {said}", gather.rows());
        gather.findings().add_whole(&CUT_OFF, found);
    }
    gather.finish()
}

fn text(gather: &mut Gather<'_>, body: &[u8], said: u64, columns: &Columns) {
    let lines = body.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    for line in lines.filter(|line| !line.is_empty()) {
        if gather.rows() as u64 >= said || !gather.has_room() {
            return;
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
    }
}

fn binary(
    gather: &mut Gather<'_>,
    body: &[u8],
    rows: usize,
    columns: &Columns,
    layout: &[Column],
    (data, row_size): (Data, usize),
) {
    let value = |column: usize, row: usize| {
        let Column { scalar, offset } = *layout.get(column)?;
        let at = match data {
            // Column after column: those before it take so many bytes a row.
            Data::Compressed => offset.checked_mul(rows)?.checked_add(row * scalar.size)?,
            _ => row.checked_mul(row_size)?.checked_add(offset)?,
        };
        scalar.read(body, at)
    };
    for row in 0..rows {
        if !gather.has_room() {
            return;
        }
        let axis = |column: usize| value(column, row).unwrap_or(f64::NAN);
        let label = columns.label.and_then(|column| value(column, row));
        gather.push(columns.coordinates.map(axis), label);
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
