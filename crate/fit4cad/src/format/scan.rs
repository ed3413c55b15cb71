//! Walking over the bytes of a file and saying where something is.

use crate::diagnostics::Position;

/// Longest excerpt of a file shown in a diagnostic.
const EXCERPT_CHARS: usize = 40;

/// A position in the bytes of a file. Nothing here reads past the end, whatever the bytes.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    /// Offset of the next byte.
    pub(super) at: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub(super) fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    #[inline]
    pub(super) fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// Steps over the byte if it is the next.
    #[inline]
    pub(super) fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    #[inline]
    pub(super) fn skip_while(&mut self, keep: impl Fn(u8) -> bool) {
        while self.peek().is_some_and(&keep) {
            self.at += 1;
        }
    }

    #[inline]
    pub(super) fn skip_whitespace(&mut self) {
        self.skip_while(is_whitespace);
    }

    /// To the end of the line, not over it.
    pub(super) fn skip_line(&mut self) {
        self.skip_while(|byte| !is_line_end(byte));
    }

    /// Steps over a word of letters and digits that begins with a letter; empty if there is none.
    pub(super) fn word(&mut self) -> &'a [u8] {
        let start = self.at;
        if self.peek().is_some_and(|byte| byte.is_ascii_alphabetic()) {
            self.skip_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        }
        self.bytes.get(start..self.at).unwrap_or_default()
    }

    /// Whether `...` stands here, by which MATLAB continues a line.
    pub(super) fn at_continuation(&self) -> bool {
        let rest = self.bytes.get(self.at..);
        rest.is_some_and(|rest| rest.starts_with(b"..."))
    }

    /// Steps over what cannot be part of the grammar up to the next separator or bracket, at least
    /// one byte, so that a reader that meets it always moves on.
    pub(super) fn skip_token(&mut self) {
        self.at = (self.at + 1).min(self.bytes.len());
        self.skip_while(|byte| !is_separator(byte));
    }
}

pub(super) fn is_whitespace(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n' | 0x0b | 0x0c)
}

pub(super) fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// `#` and `%` (MATLAB) begin a remark up to the end of the line.
pub(super) fn is_remark(byte: u8) -> bool {
    matches!(byte, b'#' | b'%')
}

/// What ends a number or a word.
pub(super) fn is_separator(byte: u8) -> bool {
    is_whitespace(byte) || is_remark(byte) || matches!(byte, b',' | b';' | b'[' | b']')
}

/// Turns offsets into lines and columns. A file is walked at most once as long as the offsets
/// rise, so that many diagnostics cost no more than one.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    /// Lines before these bytes.
    before: u32,
    /// Up to where lines have been counted, the line there and where it begins.
    counted: usize,
    line: u32,
    line_start: usize,
}

impl<'a> Lines<'a> {
    #[cfg(test)]
    fn new(bytes: &'a [u8]) -> Self {
        Self::after(0, bytes)
    }

    /// Of bytes before which there are so many lines.
    pub(super) fn after(before: u32, bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            before,
            counted: 0,
            line: before.saturating_add(1),
            line_start: 0,
        }
    }

    /// Line and column of an offset. `\n`, `\r\n` and a lone `\r` each end a line.
    pub(super) fn position(&mut self, offset: usize) -> Position {
        let offset = offset.min(self.bytes.len());
        if offset < self.line_start {
            *self = Self::after(self.before, self.bytes);
        }
        while self.counted < offset {
            let byte = self.bytes.get(self.counted).copied();
            let next = self.bytes.get(self.counted + 1).copied();
            self.counted += 1;
            if byte == Some(b'\n') || (byte == Some(b'\r') && next != Some(b'\n')) {
                self.line = self.line.saturating_add(1);
                self.line_start = self.counted;
            }
        }
        Position {
            line: self.line,
            column: u32::try_from(offset - self.line_start + 1).unwrap_or(u32::MAX),
        }
    }
}

/// What stands at an offset, up to the end of its line, shortened and printable.
pub(super) fn excerpt(bytes: &[u8], at: usize) -> String {
    let rest = bytes.get(at..).unwrap_or_default();
    if rest.is_empty() {
        return "the end of the file".to_owned();
    }
    // Four bytes a character at most.
    let window = rest.get(..EXCERPT_CHARS * 4).unwrap_or(rest);
    let line = window
        .split(|&byte| is_line_end(byte))
        .next()
        .unwrap_or_default();
    if line.is_empty() {
        return "the end of the line".to_owned();
    }
    quote(&String::from_utf8_lossy(line))
}

/// One token in quotes, shortened and printable; where the line is at its end, that it is.
pub(super) fn token(bytes: &[u8], at: usize) -> String {
    let mut end = Cursor { bytes, at };
    if end.peek().is_some_and(is_line_end) {
        return excerpt(bytes, at);
    }
    end.skip_token();
    match bytes.get(at..end.at) {
        Some(token) if !token.is_empty() => {
            let window = token.get(..EXCERPT_CHARS * 4).unwrap_or(token);
            quote(&String::from_utf8_lossy(window))
        }
        _ => excerpt(bytes, at),
    }
}

fn quote(text: &str) -> String {
    format!("`{}`", shortened(text.trim_end(), EXCERPT_CHARS))
}

/// A text, printable and of no more than so many characters.
pub(super) fn shortened(text: &str, most: usize) -> String {
    let mut characters = text.chars().map(|character| match character {
        '\t' => ' ',
        other if other.is_control() => char::REPLACEMENT_CHARACTER,
        other => other,
    });
    let mut short: String = characters.by_ref().take(most).collect();
    if characters.next().is_some() {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(text: &str, offset: usize) -> (u32, u32) {
        let Position { line, column } = Lines::new(text.as_bytes()).position(offset);
        (line, column)
    }

    #[test]
    fn lines_end_with_lf_crlf_or_cr() {
        for text in ["ab\ncd\nef", "ab\rcd\ref"] {
            assert_eq!(position(text, 0), (1, 1));
            assert_eq!(position(text, 4), (2, 2));
            assert_eq!(position(text, 6), (3, 1));
        }
        assert_eq!(position("ab\r\ncd", 4), (2, 1));
        assert_eq!(position("ab\r\n\r\ncd", 7), (3, 2));
    }

    #[test]
    fn positions_may_be_asked_for_in_any_order() {
        let mut lines = Lines::new(b"a\nbc\nd");
        assert_eq!(lines.position(5), Position { line: 3, column: 1 });
        assert_eq!(lines.position(3), Position { line: 2, column: 2 });
        assert_eq!(lines.position(99), Position { line: 3, column: 2 });
    }

    #[test]
    fn excerpts_are_short_and_printable() {
        assert_eq!(excerpt(b"ab\x01c\ndef", 0), "`ab\u{FFFD}c`");
        assert_eq!(excerpt(b"ab", 2), "the end of the file");
        assert_eq!(excerpt(&[b'x'; 1000], 0).chars().count(), EXCERPT_CHARS + 3);
        assert_eq!(token(b"1x2, 3", 0), "`1x2`");
        assert_eq!(token(b"\"\nnext", 1), "the end of the line");
    }
}
