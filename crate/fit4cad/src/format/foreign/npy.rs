//! NumPy's `.npy`: one array, its shape and type in a head of text. Python objects are never opened.

use std::borrow::Cow;

use super::scalar::{Kind, Scalar};

/// Longest head that is read, in bytes.
pub(super) const LONGEST_HEAD: usize = 1 << 16;

/// An array of numbers, or of rows of named numbers.
#[derive(Debug, Clone)]
pub(super) struct Array<'a> {
    /// Length of each axis.
    pub(super) shape: Vec<usize>,
    /// Names of the numbers of an element; one without a name in a plain array.
    pub(super) names: Vec<String>,
    /// How each is stored, and where in an element.
    fields: Vec<(Scalar, usize)>,
    element_size: usize,
    /// Whether the first index runs fastest.
    fortran: bool,
    /// Elements from a row to the next, and from a column to the next, of the axes that are longer than one.
    strides: (usize, usize),
    /// Offset of the numbers in the file.
    start: usize,
    data: Cow<'a, [u8]>,
}

/// Why an array is not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Unread {
    /// It holds Python objects.
    Pickled,
    /// Its head makes no sense, or is of something that is no number.
    Head(String),
    /// It should be so many bytes and is fewer.
    CutOff(String),
}

impl<'a> Array<'a> {
    /// All of it.
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, Unread> {
        let mut array = Self::head(bytes, bytes.len() as u64)?;
        array.data = Cow::Borrowed(bytes.get(array.start..).unwrap_or_default());
        Ok(array)
    }

    /// The array without its numbers, of a file of so many bytes by its first ones.
    pub(super) fn head(bytes: &[u8], size: u64) -> Result<Self, Unread> {
        let wrong = |what: &str| Unread::Head(what.to_owned());
        let (length, start) = match *bytes {
            [_, _, _, _, _, _, 1, _, a, b, ..] => (usize::from(u16::from_le_bytes([a, b])), 10),
            [_, _, _, _, _, _, 2 | 3, _, a, b, c, d, ..] => {
                (u32::from_le_bytes([a, b, c, d]) as usize, 12)
            }
            _ => return Err(wrong("an unknown version")),
        };
        if length > LONGEST_HEAD {
            return Err(wrong("a very long head"));
        }
        let head = bytes
            .get(start..start + length)
            .ok_or_else(|| wrong("it is cut off"))?;
        let head = String::from_utf8_lossy(head);
        let shown = || Unread::Head(head.trim().chars().take(80).collect());
        let (descr, shape) = (after(&head, "descr"), after(&head, "shape"));
        let (Some(descr), Some(shape)) = (descr, shape) else {
            return Err(shown());
        };
        let fortran = after(&head, "fortran_order").is_some_and(|it| it.starts_with("True"));
        let shape = shape_of(shape).ok_or_else(shown)?;
        let (mut names, mut fields, mut element_size) = (Vec::new(), Vec::new(), 0);
        for (name, kind) in types_of(descr).ok_or_else(shown)? {
            if kind.contains('O') {
                return Err(Unread::Pickled);
            }
            let scalar = scalar(&kind).ok_or_else(shown)?;
            names.push(name);
            fields.push((scalar, element_size));
            element_size += scalar.size;
        }
        let mut array = Self {
            shape,
            names,
            fields,
            element_size,
            fortran,
            strides: (1, 1),
            start: start + length,
            data: Cow::Borrowed(&[]),
        };
        array.strides = match array.squeezed()[..] {
            [_, columns] if !fortran => (columns, 1),
            [rows, _] => (1, rows),
            // One row of columns, or one column of rows.
            _ => (1, 1),
        };
        let needed = array
            .count()
            .and_then(|count| count.checked_mul(element_size));
        let there = size.saturating_sub(array.start as u64);
        match needed {
            Some(needed) if needed as u64 <= there && element_size > 0 => Ok(array),
            Some(needed) => Err(Unread::CutOff(format!("{there} bytes of {needed}"))),
            None => Err(Unread::CutOff(format!("shape {:?}", array.shape))),
        }
    }

    /// Offset of the numbers in the file.
    pub(super) fn start(&self) -> usize {
        self.start
    }

    /// Bytes of a row, where rows lie one after another.
    pub(super) fn row_size(&self) -> Option<usize> {
        match self.shape[..] {
            [_] if self.names.len() > 1 => Some(self.element_size),
            [_, columns] if self.names.len() == 1 && !self.fortran => {
                self.element_size.checked_mul(columns)
            }
            _ => None,
        }
    }

    /// A number of a row by its bytes, where rows lie one after another.
    pub(super) fn in_row(&self, row: &[u8], column: usize) -> f64 {
        let field = if self.names.len() > 1 { column } else { 0 };
        let value = self.fields.get(field).and_then(|&(scalar, offset)| {
            let before = if field == column { 0 } else { column };
            scalar.read(row, before.checked_mul(self.element_size)? + offset)
        });
        value.unwrap_or(f64::NAN)
    }

    /// How many elements; `None` where that is beyond counting.
    pub(super) fn count(&self) -> Option<usize> {
        self.shape
            .iter()
            .try_fold(1usize, |all, &axis| all.checked_mul(axis))
    }

    /// Whether its numbers are whole ones by their type.
    pub(super) fn is_whole(&self) -> bool {
        self.fields
            .iter()
            .all(|(scalar, _)| scalar.kind != Kind::Float)
    }

    /// The axes but those of length one.
    pub(super) fn squeezed(&self) -> Vec<usize> {
        self.shape
            .iter()
            .copied()
            .filter(|&axis| axis != 1)
            .collect()
    }

    /// A number of a plain array by its place along the axes that are longer than one, or of an
    /// element of a row of named numbers.
    pub(super) fn at(&self, row: usize, column: usize) -> f64 {
        let plain = self.fields.len() == 1;
        let (rows, columns) = self.strides;
        let place = if plain {
            row * rows + column * columns
        } else {
            row
        };
        let field = if plain { 0 } else { column };
        let value = self.fields.get(field).and_then(|&(scalar, offset)| {
            scalar.read(&self.data, place.checked_mul(self.element_size)? + offset)
        });
        value.unwrap_or(f64::NAN)
    }
}

/// What stands behind a key of the head.
fn after<'h>(head: &'h str, key: &str) -> Option<&'h str> {
    ['\'', '"'].into_iter().find_map(|quote| {
        let (_, rest) = head.split_once(&format!("{quote}{key}{quote}"))?;
        Some(rest.trim_start().strip_prefix(':')?.trim_start())
    })
}

fn shape_of(text: &str) -> Option<Vec<usize>> {
    let (inner, _) = text.strip_prefix('(')?.split_once(')')?;
    let axes = inner
        .split(',')
        .map(str::trim)
        .filter(|axis| !axis.is_empty());
    axes.map(|axis| axis.trim_end_matches('L').parse().ok())
        .collect()
}

/// Name and type of each number of an element.
fn types_of(descr: &str) -> Option<Vec<(String, String)>> {
    let quoted = |text: &str| -> Option<Vec<String>> {
        let parts = text.split(['\'', '"']).skip(1).step_by(2);
        Some(parts.map(str::to_owned).collect())
    };
    if !descr.starts_with('[') {
        let kind = quoted(descr)?.into_iter().next()?;
        return Some(vec![(String::new(), kind)]);
    }
    let (inner, _) = descr.split_once(']')?;
    let words = quoted(inner)?;
    let (pairs, rest) = words.as_chunks::<2>();
    // One pair a bracket: more brackets are of fields that are arrays themselves.
    let flat = rest.is_empty() && inner.matches('(').count() == pairs.len();
    flat.then(|| {
        let pairs = pairs.iter();
        pairs
            .map(|[name, kind]| (name.clone(), kind.clone()))
            .collect()
    })
}

/// `<f4`, `|u1`, `>i8`, `|b1`.
fn scalar(kind: &str) -> Option<Scalar> {
    let big_endian = kind.starts_with('>');
    let kind = kind.trim_start_matches(['<', '>', '|', '=']);
    let size = kind.get(1..)?.parse().ok()?;
    let kind = match kind.chars().next()? {
        'f' => Kind::Float,
        'i' => Kind::Signed,
        'u' | 'b' => Kind::Unsigned,
        _ => return None,
    };
    Scalar::new(kind, size, big_endian)
}
