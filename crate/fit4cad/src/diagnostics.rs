//! What is wrong with an input, said so that a person can act on it.

use std::fmt;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing; nothing is lost.
    Note,
    /// Something was repaired or left out; the rest is used.
    Warning,
    /// Something that was needed could not be used.
    Error,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

/// What a finding is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Subject {
    /// A file as a whole: absent, empty, cut off, unreadable or one too many.
    File,
    /// How something is written, where what is meant is clear.
    Syntax,
    /// A point of the cloud.
    Point,
    /// An index of a point list.
    Index,
    /// An index that a point list holds twice.
    Duplicate,
    /// The vector of a surface: missing, of the wrong length or not of numbers.
    Vector,
    /// The type of a surface.
    Type,
    /// The numbers by which surfaces and primitives belong together.
    Numbering,
    /// A vector that is no surface of its type.
    Family,
}

/// A place in a text file, both counted from 1; the column counts bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Line, from 1.
    pub line: u32,
    /// Byte within the line, from 1.
    pub column: u32,
}

/// One finding about an input: where, what was found, what was expected, what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// What it is about.
    pub subject: Subject,
    /// Number of the primitive it is about, where it is about one.
    pub primitive: Option<u32>,
    /// Path of the file as it was given.
    pub file: String,
    /// Where in the file, if it is about one place.
    pub position: Option<Position>,
    /// One sentence: what is wrong.
    pub message: String,
    /// The text or value found, shortened; empty if it adds nothing.
    pub found: String,
    /// What would have been right; empty if it adds nothing.
    pub expected: String,
    /// What to do about it; empty if there is nothing to do.
    pub hint: String,
}

impl fmt::Display for Diagnostic {
    /// `file:line:column: severity: message (found …, expected …). hint`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if let Some(Position { line, column }) = self.position {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}: {}", self.severity, self.message)?;
        match (self.found.is_empty(), self.expected.is_empty()) {
            (true, true) => {}
            (false, true) => write!(f, " (found {})", self.found)?,
            (true, false) => write!(f, " (expected {})", self.expected)?,
            (false, false) => write!(f, " (found {}, expected {})", self.found, self.expected)?,
        }
        if self.hint.is_empty() {
            Ok(())
        } else {
            write!(f, ". {}", self.hint)
        }
    }
}
