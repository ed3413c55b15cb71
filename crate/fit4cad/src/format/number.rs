//! Decimal numbers, fast and correctly rounded.

/// Powers of ten that a double holds exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Integers up to here are exact in a double.
const EXACT_MANTISSA: u64 = 1 << 53;

/// Digits that fit in 64 bits whatever they are.
const MAX_DIGITS: usize = 19;

/// Reads the decimal number that begins at `start`: its value and where it ends.
///
/// The value is that of [`str::parse`], bit for bit. Accepts a sign, `.5`, `5.` and exponents;
/// `None` for anything else, among it `NaN`, `inf` and numbers too large for a double. What
/// follows the number is not looked at.
///
/// The cloud files hold 14 to 16 digits a number, so nearly all of them take the exact path of
/// Clinger (1990): an integer below 2⁵³ times or over a power of ten up to 10²² is one rounding.
/// The rest is left to the standard library. Linear in the length of the number.
pub(super) fn read(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let mut at = start;
    let negative = match bytes.get(at) {
        Some(b'-') => {
            at += 1;
            true
        }
        Some(b'+') => {
            at += 1;
            false
        }
        _ => false,
    };
    let mut mantissa = 0u64;
    let whole_start = at;
    while let Some(digit) = digit_at(bytes, at) {
        mantissa = mantissa.wrapping_mul(10).wrapping_add(digit);
        at += 1;
    }
    let mut digits = at - whole_start;
    let mut exponent = 0i64;
    if bytes.get(at) == Some(&b'.') {
        at += 1;
        let fraction_start = at;
        // Eight at a time: the twelve decimals of a cloud file take one step of eight and four of
        // one, half again as fast as twelve of one.
        while let Some(eight) = eight_digits_at(bytes, at) {
            mantissa = mantissa.wrapping_mul(100_000_000).wrapping_add(eight);
            at += 8;
        }
        while let Some(digit) = digit_at(bytes, at) {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(digit);
            at += 1;
        }
        digits += at - fraction_start;
        exponent = -i64::try_from(at - fraction_start).unwrap_or(i64::MAX);
    }
    if digits == 0 {
        return None;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (power, end) = read_exponent(bytes, at + 1)?;
        exponent = exponent.saturating_add(power);
        at = end;
    }
    let value = if digits <= MAX_DIGITS && mantissa <= EXACT_MANTISSA {
        scale_exactly(mantissa, exponent)
    } else {
        None
    };
    let value = match value {
        Some(magnitude) if negative => -magnitude,
        Some(magnitude) => magnitude,
        None => std::str::from_utf8(bytes.get(start..at)?)
            .ok()?
            .parse()
            .ok()?,
    };
    value.is_finite().then_some((value, at))
}

#[inline]
fn digit_at(bytes: &[u8], at: usize) -> Option<u64> {
    let digit = bytes.get(at)?.wrapping_sub(b'0');
    (digit < 10).then_some(u64::from(digit))
}

/// The value of eight digits, if the next eight bytes are digits (Lemire 2021, "Number parsing at
/// a gigabyte per second", section 4).
#[inline]
fn eight_digits_at(bytes: &[u8], at: usize) -> Option<u64> {
    let chunk: [u8; 8] = bytes.get(at..at.checked_add(8)?)?.try_into().ok()?;
    let chunk = u64::from_le_bytes(chunk);
    let high = chunk.wrapping_add(0x4646_4646_4646_4646);
    let low = chunk.wrapping_sub(0x3030_3030_3030_3030);
    if (high | low) & 0x8080_8080_8080_8080 != 0 {
        return None;
    }
    let pairs = low.wrapping_mul(10).wrapping_add(low >> 8);
    let first = (pairs & 0x0000_00FF_0000_00FF).wrapping_mul(0x000F_4240_0000_0064);
    let second = ((pairs >> 16) & 0x0000_00FF_0000_00FF).wrapping_mul(0x0000_2710_0000_0001);
    Some(first.wrapping_add(second) >> 32)
}

/// The number after `e`, clamped far outside what a double can hold.
fn read_exponent(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    let (negative, from) = match bytes.get(start) {
        Some(b'-') => (true, start + 1),
        Some(b'+') => (false, start + 1),
        _ => (false, start),
    };
    let mut at = from;
    let mut power = 0i64;
    while let Some(digit) = digit_at(bytes, at) {
        power = power.saturating_mul(10).saturating_add(digit as i64);
        at += 1;
    }
    (at > from).then_some((if negative { -power } else { power }, at))
}

/// `mantissa` · 10^`exponent` where that takes a single rounding.
fn scale_exactly(mantissa: u64, exponent: i64) -> Option<f64> {
    let power = *EXACT_POWERS.get(usize::try_from(exponent.unsigned_abs()).ok()?)?;
    Some(if exponent < 0 {
        mantissa as f64 / power
    } else {
        mantissa as f64 * power
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same_as_the_standard_library(text: &str) {
        let expected: f64 = text.parse().unwrap();
        let read = read(text.as_bytes(), 0);
        if expected.is_finite() {
            let (value, end) = read.unwrap_or_else(|| panic!("{text} was not read"));
            assert_eq!(value.to_bits(), expected.to_bits(), "{text}");
            assert_eq!(end, text.len(), "{text}");
        } else {
            assert_eq!(read, None, "{text}");
        }
    }

    #[test]
    fn awkward_numbers_have_the_value_of_the_standard_library() {
        for text in [
            "0",
            "-0",
            "+1",
            ".5",
            "5.",
            "-.5e1",
            "1e5",
            "1E+5",
            "1.73472e-15",
            "577350",
            "3.843807000000",
            "9007199254740992",
            "9007199254740993",
            "9007199254740993e-3",
            "0.00000000000000000000000000001",
            "123456789012345678901234567890",
            "1e22",
            "1e23",
            "1.7976931348623157e308",
            "1.7976931348623159e308",
            "1e309",
            "-1e400",
            "5e-324",
            "2.4703282292062327e-324",
            "1e-400",
            "1e99999999999999999999",
            "1e-99999999999999999999",
            "0.1234567890123456789",
            "8.41e21",
            "12345678.12345678",
            "00000000000000000000001.5",
        ] {
            same_as_the_standard_library(text);
        }
    }

    #[test]
    fn what_is_no_finite_number_is_not_read() {
        for text in [
            "",
            "-",
            ".",
            "+.",
            "e5",
            "1e",
            "1e+",
            "NaN",
            "inf",
            "-Infinity",
            "--1",
            "x",
        ] {
            assert_eq!(read(text.as_bytes(), 0), None, "{text}");
        }
    }

    #[test]
    fn a_number_ends_where_its_characters_end() {
        assert_eq!(read(b"[12.5, 3]", 1), Some((12.5, 5)));
        assert_eq!(read(b"1-2", 0), Some((1.0, 1)));
    }

    proptest! {
        #[test]
        fn decimals_have_the_value_of_the_standard_library(text in r"[+-]?[0-9]{1,20}(\.[0-9]{0,25})?([eE][+-]?[0-9]{1,3})?") {
            same_as_the_standard_library(&text);
        }

        #[test]
        fn every_double_reads_back_exactly(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            same_as_the_standard_library(&format!("{value}"));
            same_as_the_standard_library(&format!("{value:e}"));
            same_as_the_standard_library(&format!("{value:.12}"));
        }
    }
}
