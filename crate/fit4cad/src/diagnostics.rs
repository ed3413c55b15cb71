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
