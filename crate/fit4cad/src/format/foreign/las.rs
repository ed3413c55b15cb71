//! LAS of the American Society for Photogrammetry and Remote Sensing, versions 1.0 to 1.4: coordinates, and a column
//! of labels among what programs add to each point (specification 1.4 R15, “Extra Bytes”). Its own classes of ground,
//! buildings and the like are no segments.

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF, LAZ};
use super::scalar::{Kind, Scalar};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::Findings;
use crate::format::window::Window;

/// What every such file begins with.
pub(super) const MAGIC: &[u8] = b"LASF";

/// Bytes of a point that each format has of its own, formats 0 to 10.
const OWN: [usize; 11] = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67];

/// Bytes that describe one added column.
const DESCRIPTION: usize = 192;

/// Most added columns that are looked at; a point has room for no more.
const MOST_COLUMNS: usize = 4096;

struct Head {
    /// Where the points begin, and the bytes of each.
    start: usize,
    record: usize,
    /// How many there are, it says.
    points: u64,
    /// Bytes of each that are its format's own.
    own: usize,
    scale: [f64; 3],
    offset: [f64; 3],
}

/// Reads a LAS file. Coordinates are whole numbers of the head's unit beyond the head's offset.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read(
    mut findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    window.reach(LONGEST_OWN_HEAD)?;
    // What describes the points lies before them.
    let start = whole(window.bytes(), 96, 4).and_then(|start| usize::try_from(start).ok());
    window.reach(start.unwrap_or(0))?;
    let head = match Head::read(window.bytes()) {
        Ok(head) => head,
        Err(None) => {
            findings.add_whole(&LAZ, String::new());
            return Ok((CloudFile::default(), findings.finish()));
        }
        Err(Some(wrong)) => {
            findings.add_whole(&BAD_HEADER, wrong.to_owned());
            return Ok((CloudFile::default(), findings.finish()));
        }
    };
    let added = added(window.bytes());
    let names = ["x", "y", "z"].map(str::to_owned).into_iter();
    let names: Vec<String> = names.chain(added.iter().map(|it| it.0.clone())).collect();
    let columns = Columns::named(&names);
    let label = columns.as_ref().and_then(|columns| columns.label);
    let label = label.and_then(|column| added.get(column.checked_sub(3)?));
    let there = window.size().saturating_sub(head.start as u64) / head.record as u64;
    let rows = usize::try_from(head.points.min(there)).unwrap_or(usize::MAX);
    let mut gather = Gather::new(findings, rows, label.is_some());
    if let Some(columns) = &columns {
        gather.tell_columns(columns);
    }
    let mut at = head.start;
    while gather.rows() < rows && gather.has_room() {
        let Some(row) = window.row(&mut at, head.record)? else {
            break;
        };
        let axis = |axis: usize| {
            let count = COORDINATE.read(row, 4 * axis).unwrap_or(f64::NAN);
            count * head.scale[axis] + head.offset[axis]
        };
        let label = label.and_then(|&(_, scalar, at)| scalar.read(row, head.own + at));
        gather.push([axis(0), axis(1), axis(2)], label);
    }
    if (gather.rows() as u64) < head.points && gather.has_room() {
        let found = format!("{} points of {}", gather.rows(), head.points);
        gather.findings().add_whole(&CUT_OFF, found);
    }
    Ok(gather.finish())
}

/// Longest head of any version, in bytes, without what it says lies behind.
const LONGEST_OWN_HEAD: usize = 375;

/// How each coordinate is stored.
const COORDINATE: Scalar = Scalar {
    kind: Kind::Signed,
    size: 4,
    big_endian: false,
};

impl Head {
    /// The head; else what is wrong with it, or nothing where the points are packed.
    fn read(bytes: &[u8]) -> Result<Self, Option<&'static str>> {
        let short = || Some("it ends within its head");
        let number = |at: usize, size: usize| {
            whole(bytes, at, size)
                .and_then(|value| usize::try_from(value).ok())
                .ok_or_else(short)
        };
        let minor = number(25, 1)?;
        let format = number(104, 1)?;
        // LAZ sets the highest bit, or the one below.
        if format & 0xC0 != 0 {
            return Err(None);
        }
        let own = *OWN
            .get(format)
            .ok_or(Some("no point format from 0 to 10"))?;
        let record = number(105, 2)?;
        if record < own {
            return Err(Some("its points are shorter than their format"));
        }
        let few = number(107, 4)? as u64;
        let many = whole(bytes, 247, 8).filter(|_| minor >= 4);
        let three = |at: usize| -> Result<[f64; 3], Option<&'static str>> {
            let mut values = [0.0; 3];
            for (axis, value) in values.iter_mut().enumerate() {
                *value = f64::from_bits(whole(bytes, at + 8 * axis, 8).ok_or_else(short)?);
            }
            Ok(values)
        };
        Ok(Self {
            start: number(96, 4)?,
            record,
            points: many.filter(|&many| many > 0).unwrap_or(few),
            own,
            scale: three(131)?,
            offset: three(155)?,
        })
    }
}

/// Name, kind and place of each column that is added to the format's own.
fn added(bytes: &[u8]) -> Vec<(String, Scalar, usize)> {
    let mut columns = Vec::new();
    let mut at = whole(bytes, 94, 2).unwrap_or(0) as usize;
    for _ in 0..whole(bytes, 100, 4).unwrap_or(0) {
        // Reserved, user, number, length, description.
        let (Some(user), Some(number), Some(length)) = (
            bytes.get(at + 2..at + 18),
            whole(bytes, at + 18, 2),
            whole(bytes, at + 20, 2),
        ) else {
            break;
        };
        let body = at + 54..at + 54 + length as usize;
        at = body.end;
        if !user.starts_with(b"LASF_Spec") || number != 4 {
            continue;
        }
        let descriptions = bytes.get(body).unwrap_or_default();
        let mut place = 0;
        for one in descriptions.chunks_exact(DESCRIPTION).take(MOST_COLUMNS) {
            let name = one.get(4..36).unwrap_or_default();
            let name = name.split(|&byte| byte == 0).next().unwrap_or_default();
            let Some(scalar) = scalar_of(one.get(2).copied().unwrap_or(0)) else {
                // Of bytes without a meaning the options tell the number.
                place += usize::from(one.get(3).copied().unwrap_or(0));
                continue;
            };
            let name = String::from_utf8_lossy(name).into_owned();
            columns.push((name, scalar, place));
            place += scalar.size;
        }
    }
    columns
}

/// The kinds of numbers that an added column may be of, by their code from 1.
fn scalar_of(code: u8) -> Option<Scalar> {
    let (kind, size) = match code {
        1 | 3 | 5 | 7 => (Kind::Unsigned, 1 << (code / 2)),
        2 | 4 | 6 | 8 => (Kind::Signed, 1 << (code / 2 - 1)),
        9 => (Kind::Float, 4),
        10 => (Kind::Float, 8),
        _ => return None,
    };
    Scalar::new(kind, size, false)
}

/// A whole number of so many bytes, the lowest first.
fn whole(bytes: &[u8], at: usize, size: usize) -> Option<u64> {
    let bytes = bytes.get(at..at.checked_add(size)?)?;
    Some(
        bytes
            .iter()
            .rev()
            .fold(0, |value, &byte| value << 8 | u64::from(byte)),
    )
}
