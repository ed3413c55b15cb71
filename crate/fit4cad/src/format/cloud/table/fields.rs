//! The fields of one line of a table.

use crate::format::number;

/// How the fields of a table are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Dialect {
    /// The mark between fields, of which two in a row leave one empty; blanks alone where there is
    /// none. Blanks separate in any case.
    pub(super) mark: Option<u8>,
    /// Whether decimals are written with a comma.
    pub(super) decimal_comma: bool,
}

/// What stands for blanks: also the brackets that some programs put around a row, the bars between columns, and
/// semicolons and commas where they are no marks.
fn is_blank(byte: u8, dialect: Dialect) -> bool {
    match byte {
        b' ' | 0x0b | 0x0c | b'(' | b')' | b'[' | b']' | b'{' | b'}' | b'|' => true,
        b'\t' | b';' => dialect.mark != Some(byte),
        b',' => dialect.mark != Some(byte) && !dialect.decimal_comma,
        _ => false,
    }
}

/// The fields of a line, one after the other, without the quotes around them.
#[derive(Debug, Clone)]
pub(super) struct Fields<'a> {
    line: &'a [u8],
    dialect: Dialect,
    at: usize,
}

impl<'a> Fields<'a> {
    pub(super) fn of(line: &'a [u8], dialect: Dialect) -> Self {
        Self {
            line,
            dialect,
            at: 0,
        }
    }

    fn skip_blanks(&mut self) {
        while let Some(&byte) = self.line.get(self.at)
            && is_blank(byte, self.dialect)
        {
            self.at += 1;
        }
    }

    /// Past the blanks and the mark after a field.
    fn skip_separator(&mut self) {
        self.skip_blanks();
        if let (Some(mark), Some(&byte)) = (self.dialect.mark, self.line.get(self.at))
            && mark == byte
        {
            self.at += 1;
        }
    }

    fn ends_field(&self, byte: u8) -> bool {
        Some(byte) == self.dialect.mark || is_blank(byte, self.dialect)
    }

    /// The next field and where in the line it begins.
    pub(super) fn next_at(&mut self) -> Option<(usize, &'a [u8])> {
        self.skip_blanks();
        let start = self.at;
        let &first = self.line.get(start)?;
        if first == b'"' {
            let inner = start + 1;
            let rest = self.line.get(inner..)?;
            let length = rest.iter().position(|&byte| byte == b'"');
            let length = length.unwrap_or(rest.len());
            self.at = inner + length + 1;
            self.skip_separator();
            return Some((inner, rest.get(..length)?));
        }
        while let Some(&byte) = self.line.get(self.at)
            && !self.ends_field(byte)
        {
            self.at += 1;
        }
        let field = self.line.get(start..self.at)?;
        self.skip_separator();
        Some((start, field))
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        self.next_at().map(|(_, field)| field)
    }
}

/// The number that a field is, nothing before or after it.
pub(super) fn number_of(field: &[u8], dialect: Dialect) -> Option<f64> {
    /// Longer ones are no numbers that anybody writes.
    const LONGEST: usize = 64;
    if dialect.decimal_comma && field.contains(&b',') {
        let mut pointed = [0u8; LONGEST];
        let pointed = pointed.get_mut(..field.len())?;
        for (to, &from) in pointed.iter_mut().zip(field) {
            *to = if from == b',' { b'.' } else { from };
        }
        return whole(pointed);
    }
    whole(field)
}

fn whole(field: &[u8]) -> Option<f64> {
    let (value, end) = number::read(field, 0)?;
    (end == field.len()).then_some(value)
}

/// Whether a field is a number, or stands where one would.
pub(super) fn is_number_like(field: &[u8], dialect: Dialect) -> bool {
    number_of(field, dialect).is_some() || is_no_number(field)
}

/// What programs write where there is no number.
pub(super) fn is_no_number(field: &[u8]) -> bool {
    let word = field.strip_prefix(b"-").unwrap_or(field);
    let word = word.strip_prefix(b"+").unwrap_or(word);
    const WORDS: [&[u8]; 8] = [
        b"nan",
        b"inf",
        b"infinity",
        b"na",
        b"n/a",
        b"null",
        b"none",
        b"1.#qnan",
    ];
    WORDS.iter().any(|known| word.eq_ignore_ascii_case(known))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fields(line: &str, mark: Option<u8>) -> Vec<String> {
        let dialect = Dialect {
            mark,
            decimal_comma: false,
        };
        let fields = Fields::of(line.as_bytes(), dialect);
        fields
            .map(|field| String::from_utf8_lossy(field).into_owned())
            .collect()
    }

    #[test]
    fn marks_hold_empty_fields_and_blanks_do_not() {
        assert_eq!(fields(" 1  2\t3 ", None), ["1", "2", "3"]);
        assert_eq!(fields("(1, 2, 3);", None), ["1", "2", "3"]);
        assert_eq!(
            fields("1, 2,,\"a b\" ,5", Some(b',')),
            ["1", "2", "", "a b", "5"]
        );
        assert_eq!(fields("1\t\t3", Some(b'\t')), ["1", "", "3"]);
        assert_eq!(fields("1;2; 3;", Some(b';')), ["1", "2", "3"]);
        assert_eq!(fields("\"1", Some(b',')), ["1"]);
    }

    #[test]
    fn decimals_may_have_a_comma() {
        let dialect = Dialect {
            mark: Some(b';'),
            decimal_comma: true,
        };
        assert_eq!(number_of(b"-1,5e1", dialect), Some(-15.0));
        assert_eq!(number_of(b"1,234,5", dialect), None);
        assert_eq!(number_of(&[b'1', b',', b'5'].repeat(40), dialect), None);
    }
}
