//! PLY (Turk 1994): text, or binary of either order.

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF, NO_COORDINATES};
use super::scalar::{Kind, Scalar};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::Findings;
use crate::format::number;
use crate::format::window::Window;

/// Longest head that is read, in bytes; real ones are below a thousand.
const LONGEST_HEAD: usize = 1 << 16;

/// One property of an element.
#[derive(Debug, Clone, Copy)]
enum Property {
    One(Scalar),
    /// How the count before a list is stored, and each of its members.
    List(Scalar, Scalar),
}

/// Vertices, faces or whatever else a file holds.
#[derive(Debug, Default)]
struct Element {
    name: String,
    count: u64,
    names: Vec<String>,
    properties: Vec<Property>,
}

#[derive(Debug)]
struct Head {
    text: bool,
    elements: Vec<Element>,
    /// Offset behind it.
    end: usize,
}

/// Reads the vertices; what other elements hold is passed over.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read(
    mut findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    let nothing = |findings: Findings<'_>| Ok((CloudFile::default(), findings.finish()));
    window.reach(LONGEST_HEAD)?;
    let head = match Head::read(window.bytes()) {
        Ok(head) => head,
        Err(line) => {
            findings.add_whole(&BAD_HEADER, line);
            return nothing(findings);
        }
    };
    let Some(place) = head.elements.iter().position(|it| it.name == "vertex") else {
        findings.add_whole(&NO_COORDINATES, "no element `vertex`".to_owned());
        return nothing(findings);
    };
    let Some((before, [vertices, ..])) = head.elements.split_at_checked(place) else {
        return nothing(findings);
    };
    let has = |axis: &str| {
        vertices
            .names
            .iter()
            .any(|name| name.eq_ignore_ascii_case(axis))
    };
    let columns = Columns::named(&vertices.names).filter(|_| has("x") && has("y") && has("z"));
    let Some(columns) = columns else {
        findings.add_whole(&NO_COORDINATES, vertices.names.join(" "));
        return nothing(findings);
    };
    let mut body = Body {
        window,
        at: head.end,
        text: head.text,
    };
    for element in before {
        for _ in 0..element.count {
            if !body.row(element, &mut |_, _| {})? {
                break;
            }
        }
    }
    // No row takes less than a byte, or two of text; so many bytes are there.
    let possible = body.rest() / vertices.least_size(head.text).max(1) as u64;
    let rows = usize::try_from(vertices.count.min(possible)).unwrap_or(usize::MAX);
    let mut gather = Gather::new(findings, rows, columns.label.is_some());
    gather.tell_columns(&columns);
    let [x, y, z] = columns.coordinates;
    while (gather.rows() as u64) < vertices.count && gather.has_room() {
        let (mut row, mut label) = ([f64::NAN; 3], None);
        let whole = body.row(vertices, &mut |column, value| {
            if let Some(axis) = [x, y, z].iter().position(|&axis| axis == column) {
                row[axis] = value;
            } else if Some(column) == columns.label {
                label = Some(value);
            }
        })?;
        if !whole {
            let found = format!("{} points of {}", gather.rows(), vertices.count);
            gather.findings().add_whole(&CUT_OFF, found);
            break;
        }
        gather.push(row, label);
    }
    Ok(gather.finish())
}

impl Head {
    /// The line that is wrong, where one is.
    fn read(bytes: &[u8]) -> Result<Self, String> {
        let mut head = Self {
            text: true,
            elements: Vec::new(),
            end: 0,
        };
        let mut big_endian = false;
        let window = bytes.get(..LONGEST_HEAD).unwrap_or(bytes);
        loop {
            let rest = window.get(head.end..).unwrap_or_default();
            let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
                return Err("it has no end".to_owned());
            };
            let line = rest.get(..length).unwrap_or_default().trim_ascii();
            head.end += length + 1;
            let line = String::from_utf8_lossy(line);
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            match words[..] {
                ["end_header"] => return Ok(head),
                ["format", "ascii", _] => head.text = true,
                ["format", "binary_little_endian", _] => head.text = false,
                ["format", "binary_big_endian", _] => (head.text, big_endian) = (false, true),
                ["element", name, count] => head.elements.push(Element {
                    name: name.to_owned(),
                    count: count
                        .parse()
                        .map_err(|_| line.chars().take(60).collect::<String>())?,
                    ..Element::default()
                }),
                ["property", ref kind @ .., name] => {
                    let property = property(kind, big_endian);
                    match (property, head.elements.last_mut()) {
                        (Some(property), Some(element)) => {
                            element.names.push(name.to_owned());
                            element.properties.push(property);
                        }
                        _ => return Err(line.chars().take(60).collect()),
                    }
                }
                ["ply" | "comment" | "obj_info", ..] | [] => {}
                _ => return Err(line.chars().take(60).collect()),
            }
        }
    }
}

fn property(kind: &[&str], big_endian: bool) -> Option<Property> {
    match *kind {
        [name] => Some(Property::One(scalar(name, big_endian)?)),
        ["list", count, member] => Some(Property::List(
            scalar(count, big_endian)?,
            scalar(member, big_endian)?,
        )),
        _ => None,
    }
}

fn scalar(name: &str, big_endian: bool) -> Option<Scalar> {
    let (kind, size) = match name {
        "char" | "int8" => (Kind::Signed, 1),
        "uchar" | "uint8" => (Kind::Unsigned, 1),
        "short" | "int16" => (Kind::Signed, 2),
        "ushort" | "uint16" => (Kind::Unsigned, 2),
        "int" | "int32" => (Kind::Signed, 4),
        "uint" | "uint32" => (Kind::Unsigned, 4),
        "int64" | "long" => (Kind::Signed, 8),
        "uint64" | "ulong" => (Kind::Unsigned, 8),
        "float" | "float32" => (Kind::Float, 4),
        "double" | "float64" => (Kind::Float, 8),
        _ => return None,
    };
    Scalar::new(kind, size, big_endian)
}

impl Element {
    /// Bytes that a row takes at least.
    fn least_size(&self, text: bool) -> usize {
        let sizes = self.properties.iter().map(|property| match property {
            // A digit and what separates it.
            _ if text => 2,
            Property::One(scalar) | Property::List(scalar, _) => scalar.size,
        });
        sizes.sum()
    }
}

/// What follows the head.
struct Body<'b, 't> {
    window: &'b mut Window<'t>,
    at: usize,
    text: bool,
}

impl Body<'_, '_> {
    /// Bytes of the file from here on.
    fn rest(&self) -> u64 {
        let at = self.window.from() + self.at as u64;
        self.window.size().saturating_sub(at)
    }

    /// Hands the single numbers of a row over, with their places; whether the file goes on to the end of the row. Of a row
    /// that the piece of the file cuts off, some may be handed over twice.
    fn row(&mut self, element: &Element, take: &mut dyn FnMut(usize, f64)) -> Result<bool, String> {
        // Rows of nothing, of which there may be any number.
        if element.properties.is_empty() {
            return Ok(false);
        }
        loop {
            let mut piece = Piece {
                bytes: self.window.bytes(),
                at: self.at,
                text: self.text,
                last: self.window.is_last(),
            };
            if piece.row(element, take).is_some() {
                self.at = piece.at;
                return Ok(true);
            }
            if !self.window.advance(&mut self.at)? {
                return Ok(false);
            }
        }
    }
}

/// What is in memory of it.
struct Piece<'a> {
    bytes: &'a [u8],
    at: usize,
    text: bool,
    /// Whether the file ends with it.
    last: bool,
}

impl Piece<'_> {
    /// Hands the single numbers of a row over, with their places; `None` where the piece ends before.
    fn row(&mut self, element: &Element, take: &mut dyn FnMut(usize, f64)) -> Option<()> {
        for (column, property) in element.properties.iter().enumerate() {
            match *property {
                Property::One(scalar) => take(column, self.number(scalar)?),
                Property::List(count, member) => {
                    let count = self.number(count)?;
                    if self.text {
                        for _ in 0..count as u64 {
                            self.number(member)?;
                        }
                    } else {
                        let skipped = (count.max(0.0) as usize).checked_mul(member.size)?;
                        self.at = self.at.checked_add(skipped)?;
                        if self.at > self.bytes.len() {
                            return None;
                        }
                    }
                }
            }
        }
        Some(())
    }

    fn number(&mut self, scalar: Scalar) -> Option<f64> {
        if !self.text {
            let value = scalar.read(self.bytes, self.at)?;
            self.at += scalar.size;
            return Some(value);
        }
        let rest = self.bytes.get(self.at..)?;
        let start = self.at + rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        let rest = self.bytes.get(start..)?;
        let length = rest.iter().position(u8::is_ascii_whitespace);
        if length.is_none() && !self.last {
            return None;
        }
        self.at = start + length.unwrap_or(rest.len());
        match number::read(self.bytes, start) {
            Some((value, end)) if end == self.at => Some(value),
            // Something else in the place of a number breaks its row alone.
            _ => Some(f64::NAN),
        }
    }
}
