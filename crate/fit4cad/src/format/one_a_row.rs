//! Texts of one value a row, as files of labels and of types are.

use super::number;
use super::scan::{is_line_end, is_remark, is_whitespace};
use crate::surface::SurfaceType;

/// The values and their offsets, without quotes. Linear in the length of the text.
pub(super) struct Values<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Values<'a> {
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let mark = bytes.starts_with(&[0xEF, 0xBB, 0xBF]);
        let at = if mark { 3 } else { 0 };
        Self { bytes, at }
    }
}

impl<'a> Iterator for Values<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let rest = self.bytes.get(self.at..)?;
            let length = |ends: &dyn Fn(u8) -> bool| {
                let end = rest.iter().position(|&byte| ends(byte));
                end.unwrap_or(rest.len())
            };
            match *rest.first()? {
                byte if is_between(byte) => self.at += 1,
                byte if is_remark(byte) => self.at += length(&is_line_end),
                _ => {
                    let length = length(&is_between);
                    let start = self.at;
                    self.at += length;
                    return Some((start, bare(rest.get(..length)?)));
                }
            }
        }
    }
}

fn is_between(byte: u8) -> bool {
    is_whitespace(byte) || matches!(byte, b',' | b';')
}

fn bare(word: &[u8]) -> &[u8] {
    let inner = word
        .strip_prefix(b"\"")
        .and_then(|word| word.strip_suffix(b"\""));
    inner.unwrap_or(word)
}

/// The number that a value is and nothing else.
pub(super) fn number_of(word: &[u8]) -> Option<f64> {
    let (value, end) = number::read(word, 0)?;
    (end == word.len()).then_some(value)
}

/// Rows by which a text is told; the first of other texts may be a number of rows.
const JUDGED: usize = 3;

/// Whether each of the first rows of a text holds one number, or the name of a type; a column's name may stand before
/// them. Of fewer rows the same is so of all, but a single one tells nothing. `None` where `all` is false and what is
/// here may go on.
pub(super) fn is_one_a_row(bytes: &[u8], all: bool) -> Option<bool> {
    let mut lines = bytes.split(|&byte| is_line_end(byte));
    let cut_off = if all { None } else { lines.next_back() };
    let rows = lines.map(Values::of).map(Iterator::collect::<Vec<_>>);
    let mut rows = rows.filter(|row| !row.is_empty());
    let is_value = |row: &Vec<(usize, &[u8])>| match row[..] {
        [(_, word)] => number_of(word).is_some() || SurfaceType::from_name(word).is_some(),
        _ => false,
    };
    let Some(first) = rows.next() else {
        return cut_off.is_none().then_some(false);
    };
    if first.len() > 1 {
        return Some(false);
    }
    let others: Vec<_> = rows.take(JUDGED - 1).collect();
    if !others.iter().all(is_value) {
        return Some(false);
    }
    let is_whole = others.len() == JUDGED - 1 || cut_off.is_none();
    is_whole.then_some(!others.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_stand_between_blanks_commas_and_remarks() {
        let text = b"\xEF\xBB\xBF# label\n\"3\", 4;5\r\n 6 % end\n\n7";
        let words: Vec<&[u8]> = Values::of(text).map(|(_, word)| word).collect();
        assert_eq!(words, [b"3", b"4", b"5", b"6", b"7"]);
        assert_eq!(Values::of(text).next().map(|(at, _)| at), Some(11));
    }

    #[test]
    fn one_number_a_row_is_told_from_rows_of_points() {
        for text in [
            "0\n0\n1\n",
            "-1\n1.0e+00",
            "label\n3\n3\n3\n",
            "# types\nPlane\nCone\n",
        ] {
            assert!(
                is_one_a_row(text.as_bytes(), true) == Some(true),
                "{text:?}"
            );
        }
        for text in [
            "",
            "12\n",
            "2\n0 0 0\n1 0 0\n",
            "x y z\n1 2 3\n",
            "Points:=[\n[1, 2, 3]\n",
            "1\n2\n0 0 0\n",
            "solid\n0 0 0\n",
        ] {
            assert_eq!(is_one_a_row(text.as_bytes(), true), Some(false), "{text:?}");
        }
        assert_eq!(is_one_a_row(b"0\n1\n2 3 4", false), None);
        assert_eq!(is_one_a_row(b"0\n1\n2\n", false), Some(true));
    }
}
