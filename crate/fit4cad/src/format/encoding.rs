//! Text as bytes of UTF-8, whatever it was saved as.

use std::borrow::Cow;

/// The bytes as UTF-8 where they are UTF-16, of either order, with its byte order mark or without;
/// else the bytes themselves. What is no character becomes U+FFFD. Linear in their length.
pub(super) fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let (text, little) = match bytes {
        [0xFF, 0xFE, text @ ..] => (text, true),
        [0xFE, 0xFF, text @ ..] => (text, false),
        // Two characters of ASCII: no text of one byte a character has a zero in it.
        [1..=0x7F, 0, 1..=0x7F, 0, ..] => (bytes, true),
        [0, 1..=0x7F, 0, 1..=0x7F, ..] => (bytes, false),
        _ => return Cow::Borrowed(bytes),
    };
    let (pairs, _) = text.as_chunks::<2>();
    let units = pairs.iter().map(|&pair| {
        if little {
            u16::from_le_bytes(pair)
        } else {
            u16::from_be_bytes(pair)
        }
    });
    let mut decoded = String::with_capacity(pairs.len());
    decoded
        .extend(char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER)));
    Cow::Owned(decoded.into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf_16_of_either_order_becomes_utf_8_with_and_without_its_mark() {
        let text = "1 2 3 # Grün\n";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for bytes in [
            little.clone(),
            big.clone(),
            [&[0xFF, 0xFE], &little[..]].concat(),
            [&[0xFE, 0xFF], &big[..]].concat(),
        ] {
            assert_eq!(*utf8(&bytes), *text.as_bytes());
        }
        assert_eq!(*utf8(text.as_bytes()), *text.as_bytes());
        // Half a character at the end is left out.
        assert_eq!(*utf8(&[0xFF, 0xFE, b'1', 0, b'2']), *b"1");
    }
}
