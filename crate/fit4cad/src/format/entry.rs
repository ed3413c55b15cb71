//! What the three files of primitives share: a sequence of entries `PrimitiveK:=[…];`.

use super::findings::{Findings, Kind};
use super::limits::MAX_PRIMITIVES;
use super::scan::{Cursor, is_line_end, is_remark, is_whitespace};
use crate::diagnostics::{Severity, Subject};

const KEYWORD: &[u8] = b"primitive";

const JUNK: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "This is not an entry and was skipped",
    expected: "`PrimitiveK:=[`",
    hint: "Begin remarks with # or %",
};
const OTHER_FILE: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "This is not a file of primitives but a cloud",
    expected: "`PrimitiveK:=[`",
    hint: "Rename the file or set its role",
};
const BAD_HEADER: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Error,
    message: "An entry does not begin as it should and was skipped",
    expected: "`PrimitiveK:=[` with K a whole number",
    hint: "",
};
const TOO_MANY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file has too many entries; the rest was not read",
    expected: "at most 100,000 entries",
    hint: "",
};
pub(super) const NOT_CLOSED: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "An entry is not closed",
    expected: "`];`",
    hint: "It is taken to end here",
};

/// The beginning of an entry, its bracket included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Header {
    /// K.
    pub(super) number: u32,
    /// Offset of its first letter.
    pub(super) at: usize,
}

/// Moves past the next header; `None` at the end of the file. `read` counts the entries so far.
pub(super) fn next_header(
    cursor: &mut Cursor<'_>,
    findings: &mut Findings<'_>,
    read: usize,
) -> Option<Header> {
    loop {
        // Brackets left over belong to the entry before.
        cursor.skip_while(|byte| is_whitespace(byte) || matches!(byte, b';' | b',' | b']'));
        let at = cursor.at;
        findings.about(None);
        let byte = cursor.peek()?;
        if is_remark(byte) {
            cursor.skip_line();
        } else if at_keyword(cursor) {
            if read >= MAX_PRIMITIVES {
                findings.add(&TOO_MANY, at);
                return None;
            }
            if let Some(number) = header(cursor) {
                findings.about(Some(number));
                return Some(Header { number, at });
            }
            findings.add(&BAD_HEADER, at);
            cursor.at = at + KEYWORD.len();
            skip_junk(cursor);
        } else if cursor.word().eq_ignore_ascii_case(b"points") {
            findings.add(&OTHER_FILE, at);
            return None;
        } else {
            findings.add(&JUNK, at);
            cursor.at = at;
            skip_junk(cursor);
        }
    }
}

/// Whether the keyword stands here, in any case.
pub(super) fn at_keyword(cursor: &Cursor<'_>) -> bool {
    cursor
        .bytes()
        .get(cursor.at..cursor.at + KEYWORD.len())
        .is_some_and(|word| word.eq_ignore_ascii_case(KEYWORD))
}

/// Reads `Primitive7:=[`. The real files also have `Primitive7 :=[` and `Primitive7:[`; MATLAB
/// writes `Primitive7=[`, `Primitive{7}=[` or `Primitive(7)=[`.
fn header(cursor: &mut Cursor<'_>) -> Option<u32> {
    cursor.at += KEYWORD.len();
    cursor.skip_while(|byte| is_whitespace(byte) || matches!(byte, b'_' | b'(' | b'{'));
    let start = cursor.at;
    cursor.skip_while(|byte| byte.is_ascii_digit());
    let digits = cursor.bytes().get(start..cursor.at)?;
    let number = std::str::from_utf8(digits).ok()?.parse().ok()?;
    cursor.skip_while(|byte| is_whitespace(byte) || matches!(byte, b')' | b'}'));
    let assigned = cursor.eat(b':') | cursor.eat(b'=');
    cursor.skip_whitespace();
    (assigned && cursor.eat(b'[')).then_some(number)
}

/// To the end of the line, or to the next entry if that comes first.
fn skip_junk(cursor: &mut Cursor<'_>) {
    loop {
        match cursor.peek() {
            None => return,
            Some(byte) if is_line_end(byte) => return,
            Some(_) if at_keyword(cursor) => return,
            Some(_) => cursor.at += 1,
        }
    }
}
