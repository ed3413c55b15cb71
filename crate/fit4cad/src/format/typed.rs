//! A file with the type of each row of a cloud: a number, as a network numbers them, or a name.

use crate::cloud::{Cloud, Numbering};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::format::encoding;
use crate::format::findings::{Findings, Kind};
use crate::format::foreign::{Content, Purpose, read_foreign};
use crate::format::one_a_row::{Values, number_of};
use crate::format::types::{Coding, Told};
use crate::surface::SurfaceType;

const TYPE_COUNT: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "There is not one type for each row of the cloud, so the file is not used",
    expected: "",
    hint: "Check that the file belongs to this cloud",
};
const BAD_TYPE: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Warning,
    message: "A type could not be read",
    expected: "a whole number, -1 for none, or a name",
    hint: "The point counts as one of another type",
};
const OTHER_TYPE: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Note,
    message: "A type is none of the five",
    expected: "Plane, Cylinder, Cone, Sphere or Torus",
    hint: "",
};
const UNKNOWN_NUMBERS: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Error,
    message: "The types are numbered in a way that is not known, so the file is not used",
    expected: "0 to 3 as SPFN numbers them, 0 to 9 as ParseNet does, or names",
    hint: "Write Plane, Cylinder, Cone, Sphere or Torus in each row",
};
const NUMBERED: Kind = Kind {
    subject: Subject::Type,
    severity: Severity::Note,
    message: "Types are read by their numbers",
    expected: "",
    hint: "Where that is wrong, write Plane, Cylinder, Cone, Sphere or Torus in each row",
};
const NO_TYPES: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file holds points and not the type of each",
    expected: "one whole number, or the name of a type, a row",
    hint: "If it is a cloud of its own, set its role",
};

/// Reads the type of each point of a cloud; nothing where the file cannot be used, and the findings say why. Linear in
/// the length of the file.
pub(super) fn read_types(
    file: &str,
    bytes: &[u8],
    cloud: &Cloud,
) -> (Option<Vec<Told>>, Vec<Diagnostic>) {
    match read_foreign(file, bytes, Purpose::Truth) {
        Some((Content::Labels(numbers, _), earlier)) => {
            let mut findings = Findings::new(file, &[]);
            let rows = numbers.into_iter().map(|number| Row::Number(number.into()));
            let found = Rows(rows.collect()).of(cloud.numbering(), &mut findings);
            (found, [earlier, findings.finish()].concat())
        }
        Some((Content::Cloud(other), mut earlier)) => {
            let mut findings = Findings::new(file, &[]);
            if !other.cloud.is_empty() {
                findings.add_whole(&NO_TYPES, format!("{} points", other.cloud.len()));
            }
            earlier.extend(findings.finish());
            (None, earlier)
        }
        Some((Content::Text(text), _)) => read_text(file, &text, cloud.numbering()),
        None => read_text(file, bytes, cloud.numbering()),
    }
}

fn read_text(
    file: &str,
    bytes: &[u8],
    numbering: &Numbering,
) -> (Option<Vec<Told>>, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    let mut findings = Findings::new(file, bytes);
    let mut rows: Vec<Row> = Vec::new();
    for (place, (at, word)) in Values::of(bytes).enumerate() {
        let row = Row::read(word);
        let shown = || String::from_utf8_lossy(word).chars().take(40).collect();
        match row {
            // The name of the column.
            Row::Other if place == 0 => continue,
            Row::Other => findings.add_row(&OTHER_TYPE, at, shown),
            Row::Broken => findings.add_row(&BAD_TYPE, at, shown),
            Row::Number(_) | Row::Named(_) => {}
        }
        rows.push(row);
    }
    // A number of types before them, as other files of rows begin.
    let count = numbering.rows();
    if rows.len() == count + 1 && rows.first() == Some(&Row::Number(count as f64)) {
        rows.remove(0);
    }
    let told = rows.len();
    let found = Rows(rows).of(numbering, &mut findings);
    (found, findings.finish_rows(told))
}

/// What a row says.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Row {
    /// A number; below 0 for none.
    Number(f64),
    /// One of the five by name.
    Named(SurfaceType),
    /// Another name.
    Other,
    /// Nothing that could be read.
    Broken,
}

impl Row {
    fn read(word: &[u8]) -> Self {
        if let Some(number) = number_of(word) {
            let whole = number.fract() == 0.0 && number >= -1.0;
            return if whole {
                Self::Number(number)
            } else {
                Self::Broken
            };
        }
        match SurfaceType::from_name(word) {
            Some(kind) => Self::Named(kind),
            None if word.first().is_some_and(u8::is_ascii_alphabetic) => Self::Other,
            None => Self::Broken,
        }
    }
}

struct Rows(Vec<Row>);

impl Rows {
    /// The types of the points.
    fn of(self, numbering: &Numbering, findings: &mut Findings<'_>) -> Option<Vec<Told>> {
        let Self(rows) = self;
        let count = numbering.rows();
        if rows.len() != count {
            findings.add_whole(
                &TYPE_COUNT,
                format!("{} types for {count} rows", rows.len()),
            );
            return None;
        }
        let numbers = rows.iter().filter_map(|row| match row {
            Row::Number(number) => Some(*number),
            _ => None,
        });
        let largest = numbers.fold(None, |most: Option<f64>, number| {
            Some(most.map_or(number, |most| most.max(number)))
        });
        let coding = match largest.filter(|&largest| largest >= 0.0) {
            None => None,
            Some(largest) => {
                let Some(coding) = Coding::of_largest(largest) else {
                    findings.add_whole(&UNKNOWN_NUMBERS, format!("numbers up to {largest}"));
                    return None;
                };
                findings.add_whole(&NUMBERED, coding.words().to_owned());
                Some(coding)
            }
        };
        let told = |row: Row| match row {
            Row::Number(number) => coding.and_then(|coding| coding.kind(number)),
            Row::Named(kind) => Some(kind),
            Row::Other | Row::Broken => None,
        };
        let of_points = numbering.of_points(rows.into_iter());
        Some(of_points.map(told).collect())
    }
}
