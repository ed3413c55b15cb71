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

/// A finding as a compiler prints it, in one line whatever names and texts hold:
/// `file:line:column: severity: message (found …, expected …). hint`. What is empty is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OneLine<'a> {
    /// How much it matters.
    pub severity: Severity,
    /// Path of the file.
    pub file: &'a str,
    /// Where in the file.
    pub position: Option<Position>,
    /// What is wrong.
    pub message: &'a str,
    /// What was found.
    pub found: &'a str,
    /// What would have been right.
    pub expected: &'a str,
    /// What to do.
    pub hint: &'a str,
}

impl<'a> From<&'a Diagnostic> for OneLine<'a> {
    fn from(diagnostic: &'a Diagnostic) -> Self {
        Self {
            severity: diagnostic.severity,
            file: &diagnostic.file,
            position: diagnostic.position,
            message: &diagnostic.message,
            found: &diagnostic.found,
            expected: &diagnostic.expected,
            hint: &diagnostic.hint,
        }
    }
}

impl fmt::Display for OneLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", Plain(self.file))?;
        if let Some(Position { line, column }) = self.position {
            write!(f, ":{line}:{column}")?;
        }
        write!(f, ": {}: {}", self.severity, Plain(self.message))?;
        let (found, expected) = (Plain(self.found), Plain(self.expected));
        match (self.found.is_empty(), self.expected.is_empty()) {
            (true, true) => {}
            (false, true) => write!(f, " (found {found})")?,
            (true, false) => write!(f, " (expected {expected})")?,
            (false, false) => write!(f, " (found {found}, expected {expected})")?,
        }
        if self.hint.is_empty() {
            Ok(())
        } else {
            write!(f, ". {}", Plain(self.hint))
        }
    }
}

/// A text that came out of files, with a mark in the place of each character that would end the
/// line or tell the terminal something.
struct Plain<'a>(&'a str);

impl fmt::Display for Plain<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use fmt::Write as _;
        let unruly = |character: char| {
            character.is_control() || matches!(character, '\u{2028}' | '\u{2029}')
        };
        self.0.chars().try_for_each(|character| {
            f.write_char(if unruly(character) {
                char::REPLACEMENT_CHARACTER
            } else {
                character
            })
        })
    }
}

impl fmt::Display for Diagnostic {
    /// [`OneLine`].
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        OneLine::from(self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finding_is_one_line_and_what_is_empty_leaves_no_trace() {
        let full = OneLine {
            severity: Severity::Warning,
            file: "PC1.txt",
            position: Some(Position { line: 3, column: 7 }),
            message: "There is no number",
            found: "x",
            expected: "a coordinate",
            hint: "Write one",
        };
        assert_eq!(
            full.to_string(),
            "PC1.txt:3:7: warning: There is no number (found x, expected a coordinate). Write one"
        );
        let bare = OneLine {
            position: None,
            found: "",
            hint: "",
            ..full
        };
        assert_eq!(
            bare.to_string(),
            "PC1.txt: warning: There is no number (expected a coordinate)"
        );
    }

    #[test]
    fn no_name_and_no_text_ends_the_line() {
        let hostile = OneLine {
            severity: Severity::Error,
            file: "a\nb\u{1b}[2J",
            position: None,
            message: "x\u{2028}y",
            found: "\r",
            expected: "",
            hint: "",
        };
        let text = hostile.to_string();
        assert!(!text.chars().any(char::is_control), "{text:?}");
        assert_eq!(text.lines().count(), 1);
        assert!(text.starts_with("a\u{fffd}b\u{fffd}[2J: error:"));
    }
}
