//! How a table separates its fields, told from lines all over it.

use super::fields::{Dialect, Fields, is_number_like, number_of};

/// Tells how the lines, which hold numbers, are written.
///
/// Semicolons separate wherever there are two of them; then commas can only be decimal. Else commas
/// separate, but where blanks already do and each comma stands within a number. Two tabs in a row
/// leave a field empty only where that gives every line as many fields.
pub(super) fn tell(lines: &[&[u8]]) -> Dialect {
    let most = |mark: u8| {
        let with = lines.iter().filter(|line| count(line, mark) >= 2);
        2 * with.count() > lines.len()
    };
    let points = lines.iter().any(|line| line.contains(&b'.'));
    if most(b';') {
        return Dialect {
            mark: Some(b';'),
            decimal_comma: !points && lines.iter().any(|line| line.contains(&b',')),
        };
    }
    if !points && lines.iter().all(|line| has_decimal_commas(line)) {
        return Dialect {
            mark: tab(lines, true),
            decimal_comma: true,
        };
    }
    Dialect {
        mark: if most(b',') {
            Some(b',')
        } else {
            tab(lines, false)
        },
        decimal_comma: false,
    }
}

fn count(line: &[u8], mark: u8) -> usize {
    line.iter().filter(|&&byte| byte == mark).count()
}

/// Whether a line has three numbers or more, separated by blanks, and each comma in one of them.
fn has_decimal_commas(line: &[u8]) -> bool {
    let dialect = Dialect {
        mark: None,
        decimal_comma: true,
    };
    let within = |at: usize| {
        let before = at.checked_sub(1).and_then(|at| line.get(at));
        let around = [before, line.get(at + 1)];
        around.iter().all(|it| it.is_some_and(u8::is_ascii_digit))
    };
    let mut commas = line
        .iter()
        .enumerate()
        .filter(|&(_, &byte)| byte == b',')
        .peekable();
    if commas.peek().is_none() || !commas.all(|(at, _)| within(at)) {
        return false;
    }
    let numbers = Fields::of(line, dialect).filter(|field| number_of(field, dialect).is_some());
    numbers.count() >= 3 && Fields::of(line, dialect).all(|field| is_number_like(field, dialect))
}

/// The tab as a mark, where it separates and marks of it keep the columns in line.
fn tab(lines: &[&[u8]], decimal_comma: bool) -> Option<u8> {
    let marked = Dialect {
        mark: Some(b'\t'),
        decimal_comma,
    };
    let mut counts = lines.iter().map(|line| Fields::of(line, marked).count());
    let first = counts.next()?;
    let gaps = lines
        .iter()
        .any(|line| line.windows(2).any(|two| two == b"\t\t"));
    (gaps && first >= 3 && counts.all(|count| count == first)).then_some(b'\t')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_separator_is_told_and_decimal_commas_where_they_can_only_be_that() {
        for (line, mark, decimal_comma) in [
            ("1 2 3", None, false),
            ("1.5\t2.5\t3.5", None, false),
            ("1.5,2.5,3.5", Some(b','), false),
            ("1, 2, 3", Some(b','), false),
            ("1;2;3", Some(b';'), false),
            ("1,5;2,5;3,5", Some(b';'), true),
            ("1,5 2,5 3,5", None, true),
            ("1,5\t2,5\t3,5", None, true),
            // Three numbers with commas between them, whatever else they might be.
            ("1,2,3", Some(b','), false),
            // Decimal points: the commas separate.
            ("1.5, 2.5, 3.5", Some(b','), false),
        ] {
            let expected = Dialect {
                mark,
                decimal_comma,
            };
            assert_eq!(tell(&[line.as_bytes()]), expected, "{line}");
        }
        let gaps = ["1\t2\t3\t\t5", "1\t2\t3\t4\t5"].map(str::as_bytes);
        assert_eq!(tell(&gaps).mark, Some(b'\t'));
        let padded = ["1\t\t2\t3", "1\t2\t3"].map(str::as_bytes);
        assert_eq!(tell(&padded).mark, None);
    }
}
