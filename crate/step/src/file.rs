//! The entities of a STEP file: `step-io`'s reader of Part 21, and access to what it reads.
//!
//! Of `step-io` the syntax alone is used. What its scene makes of the entities (curves of edges,
//! placements, faces of solids, units) has faults that this crate has no part in: it reads them itself.

use step_io::parser::{Attribute, Graph, RawEntity, parse};

use crate::error::{Got, StepError, Trouble};

/// Largest file read, in bytes: its entities take about ten times as much memory, and a page has four
/// gigabytes.
pub const LARGEST_FILE: usize = 256 << 20;

/// The entities of a file by their numbers.
pub(crate) struct File {
    graph: Graph,
}

/// Supertypes whose attributes come before those of what is made of them, in that order: where an
/// entity is written part by part (`(ELEMENTARY_SURFACE(#2) PLANE() …)`), the parts are in the order of
/// the alphabet.
const SUPERTYPES: [&str; 16] = [
    "REPRESENTATION_ITEM",
    "ELEMENTARY_SURFACE",
    "SWEPT_SURFACE",
    "CONIC",
    "EDGE",
    "FACE",
    "FACE_SURFACE",
    "FACE_BOUND",
    "CONNECTED_FACE_SET",
    "MANIFOLD_SOLID_BREP",
    "PATH",
    "PLACEMENT",
    "SHAPE_REPRESENTATION",
    "REPRESENTATION",
    "REPRESENTATION_RELATIONSHIP",
    "SURFACE_CURVE",
];

impl File {
    /// Reads the bytes of a file. O(n).
    pub fn parse(bytes: &[u8]) -> Result<Self, StepError> {
        if bytes.len() > LARGEST_FILE {
            return Err(StepError::TooLarge {
                size: bytes.len(),
                limit: LARGEST_FILE,
            });
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let start = bytes.iter().take_while(|byte| byte.is_ascii_whitespace());
        let text = &bytes[start.count()..];
        if !(text.starts_with(b"ISO-10303-21") || text.starts_with(b"/*")) {
            let found = String::from_utf8_lossy(&text[..text.len().min(24)]);
            return Err(StepError::NotStep {
                found: found.chars().filter(|it| !it.is_control()).collect(),
            });
        }
        let end = text.iter().rev();
        // Nulls and blanks after the end are what mailers and old disks leave.
        let blank = end.take_while(|byte| byte.is_ascii_whitespace() || **byte == 0);
        let text = &text[..text.len() - blank.count()];
        let graph = parse(text).or_else(|error| {
            // What the header says matters to nothing: with one that is right the rest may read.
            let whole = with_plain_header(text);
            let read = whole
                .as_ref()
                .and_then(|text| parse(&text[..]).ok())
                .or_else(|| {
                    parse(&with_standard_numbers(whole.as_deref().unwrap_or(text))[..]).ok()
                });
            read.ok_or_else(|| StepError::Syntax {
                reason: error.to_string(),
            })
        });
        Ok(Self { graph: graph? })
    }

    /// Numbers of the entities of a type, ascending.
    pub fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = u64> + 'a {
        let numbers = self.graph.entities.keys().copied();
        numbers.filter(move |&id| self.is(id, name))
    }

    /// Numbers of all entities, ascending.
    pub fn numbers(&self) -> impl Iterator<Item = u64> + '_ {
        self.graph.entities.keys().copied()
    }

    /// Whether an entity is of a type, alone or among others.
    pub fn is(&self, id: u64, name: &str) -> bool {
        self.types(id).any(|each| each == name)
    }

    /// The names of its types: one, but where it is written part by part.
    pub fn types(&self, id: u64) -> impl Iterator<Item = &str> {
        let (one, many) = match self.graph.entities.get(&id) {
            Some(RawEntity::Simple { name, .. }) => (Some(name.as_str()), &[][..]),
            Some(RawEntity::Complex { parts, .. }) => (None, &parts[..]),
            None => (None, &[][..]),
        };
        one.into_iter()
            .chain(many.iter().map(|part| part.name.as_str()))
    }

    /// What to call an entity: its type.
    pub fn name(&self, id: u64) -> String {
        let types: Vec<&str> = self.types(id).collect();
        if types.is_empty() {
            "an entity that is not in the file".to_owned()
        } else {
            types.join("+")
        }
    }

    /// The attributes of an entity with those it inherits first, however it is written.
    pub fn fields(&self, id: u64) -> Got<Fields<'_>> {
        let values = match self.graph.entities.get(&id) {
            None => return Err(Trouble::new(id, "is not in the file")),
            Some(RawEntity::Simple { attributes, .. }) => attributes.iter().collect(),
            Some(RawEntity::Complex { parts, .. }) => {
                let mut order: Vec<_> = parts.iter().collect();
                order.sort_by_key(|part| {
                    let place = SUPERTYPES.iter().position(|name| *name == part.name);
                    place.unwrap_or(SUPERTYPES.len())
                });
                order.iter().flat_map(|part| &part.attributes).collect()
            }
        };
        Ok(Fields { id, values })
    }

    /// The attributes that one of the parts of an entity declares itself. `inherited` is how many come
    /// before them where the entity is written as one.
    pub fn part(&self, id: u64, name: &str, inherited: usize) -> Option<Fields<'_>> {
        let values = match self.graph.entities.get(&id)? {
            RawEntity::Simple {
                name: own,
                attributes,
                ..
            } => (own == name).then(|| attributes.iter().skip(inherited).collect())?,
            RawEntity::Complex { parts, .. } => {
                let part = parts.iter().find(|part| part.name == name)?;
                part.attributes.iter().collect()
            }
        };
        Some(Fields { id, values })
    }

    /// Text of a header entity's attribute, e.g. the system that wrote the file.
    pub fn header(&self, name: &str, place: usize) -> Option<String> {
        let is_it = |entity: &&RawEntity| matches!(entity, RawEntity::Simple { name: own, .. } if own == name);
        let RawEntity::Simple { attributes, .. } = self.graph.header.iter().find(is_it)? else {
            return None;
        };
        match attributes.get(place)? {
            Attribute::String(text) => Some(text.clone()),
            Attribute::List(items) => match items.first()? {
                Attribute::String(text) => Some(text.clone()),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The file with a header that says nothing, and its data without a name; `None` where there are none.
fn with_plain_header(text: &[u8]) -> Option<Vec<u8>> {
    const HEADER: &[u8] = b"ISO-10303-21;HEADER;FILE_DESCRIPTION((''),'');\
        FILE_NAME('','',(''),(''),'','','');FILE_SCHEMA((''));ENDSEC;DATA;";
    let find = |from: usize, word: &[u8]| {
        let found = text[from..].windows(word.len()).position(|it| it == word)?;
        Some(from + found)
    };
    let mut start = find(0, b"ENDSEC").map_or(0, |at| at + b"ENDSEC".len());
    // `DATA;` or `DATA('name',('schema'));`
    start = find(start, b"DATA")?;
    let data = start + text[start..].iter().position(|byte| *byte == b';')? + 1;
    let mut whole = HEADER.to_vec();
    whole.extend_from_slice(&text[data..]);
    Some(whole)
}

/// The text with its numbers as the standard writes them: small programs print theirs as their language
/// does, `1e-05` for `1.E-05`.
fn with_standard_numbers(text: &[u8]) -> Vec<u8> {
    let mut whole = Vec::with_capacity(text.len() + text.len() / 16);
    let mut quoted = false;
    let (mut digits, mut point) = (false, false);
    for (at, &byte) in text.iter().enumerate() {
        quoted ^= byte == b'\'';
        let follows = text.get(at + 1).copied().unwrap_or(b' ');
        let exponent = matches!(byte, b'e' | b'E')
            && (follows.is_ascii_digit() || matches!(follows, b'+' | b'-'));
        if !quoted && digits && exponent {
            whole.extend_from_slice(if point { b"E" } else { b".E" });
            (digits, point) = (false, false);
            continue;
        }
        // A word may hold digits too: a number begins after what is no letter.
        let before = whole.last().copied().unwrap_or(b' ');
        let in_word = before.is_ascii_alphabetic() || before == b'_' || before == b'#';
        if byte.is_ascii_digit() {
            digits = digits || !in_word;
        } else if byte == b'.' {
            point = digits;
        } else {
            (digits, point) = (false, false);
        }
        whole.push(byte);
    }
    whole
}

/// The attributes of one entity.
#[derive(Clone)]
pub(crate) struct Fields<'a> {
    /// Number of the entity.
    pub id: u64,
    values: Vec<&'a Attribute>,
}

impl<'a> Fields<'a> {
    fn get(&self, place: usize) -> Got<&'a Attribute> {
        let missing = || Trouble::new(self.id, format!("has no attribute {}", place + 1));
        self.values.get(place).copied().ok_or_else(missing)
    }

    fn wrong(&self, place: usize, expected: &str) -> Trouble {
        Trouble::new(
            self.id,
            format!("attribute {} is not {expected}", place + 1),
        )
    }

    /// How many attributes there are.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// A finite number.
    pub fn number(&self, place: usize) -> Got<f64> {
        number(self.get(place)?).ok_or_else(|| self.wrong(place, "a finite number"))
    }

    /// A number greater than zero.
    pub fn length(&self, place: usize) -> Got<f64> {
        let value = self.number(place)?;
        if value > 0.0 {
            Ok(value)
        } else {
            Err(self.wrong(place, "greater than zero"))
        }
    }

    /// A reference to another entity.
    pub fn reference(&self, place: usize) -> Got<u64> {
        self.optional(place)?
            .ok_or_else(|| self.wrong(place, "a reference"))
    }

    /// A reference, or nothing where the attribute is omitted.
    pub fn optional(&self, place: usize) -> Got<Option<u64>> {
        match self.values.get(place) {
            None | Some(Attribute::Unset | Attribute::Derived) => Ok(None),
            Some(Attribute::EntityRef(id)) => Ok(Some(*id)),
            Some(_) => Err(self.wrong(place, "a reference")),
        }
    }

    /// A truth value; `None` where it is unknown or left out.
    pub fn flag(&self, place: usize) -> Option<bool> {
        match self.word(place) {
            Some("T") => Some(true),
            Some("F") => Some(false),
            _ => None,
        }
    }

    /// A word between dots.
    pub fn word(&self, place: usize) -> Option<&'a str> {
        match self.values.get(place) {
            Some(Attribute::Enum(word)) => Some(word.as_str()),
            _ => None,
        }
    }

    /// A text; empty where there is none.
    pub fn text(&self, place: usize) -> &'a str {
        match self.values.get(place) {
            Some(Attribute::String(text)) => text,
            _ => "",
        }
    }

    /// The items of a list.
    pub fn list(&self, place: usize) -> Got<&'a [Attribute]> {
        match self.get(place)? {
            Attribute::List(items) => Ok(items),
            _ => Err(self.wrong(place, "a list")),
        }
    }

    /// A list of references; what is none is left out.
    pub fn references(&self, place: usize) -> Got<Vec<u64>> {
        let items = self.list(place)?.iter();
        Ok(items.filter_map(reference).collect())
    }

    /// A list of finite numbers.
    pub fn numbers(&self, place: usize) -> Got<Vec<f64>> {
        let items = self.list(place)?.iter();
        let values: Option<Vec<f64>> = items.map(number).collect();
        values.ok_or_else(|| self.wrong(place, "a list of finite numbers"))
    }

    /// A list of lists of one kind.
    pub fn table<T>(
        &self,
        place: usize,
        read: impl Fn(&Attribute) -> Option<T>,
    ) -> Got<Vec<Vec<T>>> {
        let rows = self.list(place)?.iter().map(|row| match row {
            Attribute::List(items) => items.iter().map(&read).collect(),
            _ => None,
        });
        let rows: Option<Vec<Vec<T>>> = rows.collect();
        rows.ok_or_else(|| self.wrong(place, "a table"))
    }
}

/// The number an attribute holds, with or without the name of its measure.
pub(crate) fn number(attribute: &Attribute) -> Option<f64> {
    let value = match attribute {
        Attribute::Real(value) => *value,
        Attribute::Integer(value) => *value as f64,
        Attribute::Typed { value, .. } => return number(value),
        _ => return None,
    };
    // Far beyond every part: what is computed from it stays finite.
    (value.abs() <= 1e15).then_some(value)
}

/// The entity an attribute refers to.
pub(crate) fn reference(attribute: &Attribute) -> Option<u64> {
    match attribute {
        Attribute::EntityRef(id) => Some(*id),
        _ => None,
    }
}
