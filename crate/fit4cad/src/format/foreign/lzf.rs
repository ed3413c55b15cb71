//! LZF (Lehmann), by which PCD files and some HDF5 files are compressed.

/// The bytes that were packed by LZF, of which there are `size`; `None` where they do not come to that. Linear in them.
pub fn unpack(packed: &[u8], size: usize) -> Option<Vec<u8>> {
    // A reference of three bytes stands for 264 at most.
    if size / 264 > packed.len() {
        return None;
    }
    let mut whole = Vec::with_capacity(size);
    let mut at = 0;
    while let Some(&control) = packed.get(at) {
        at += 1;
        if control < 32 {
            let length = usize::from(control) + 1;
            whole.extend_from_slice(packed.get(at..at + length)?);
            at += length;
        } else {
            let mut length = usize::from(control >> 5);
            if length == 7 {
                length += usize::from(*packed.get(at)?);
                at += 1;
            }
            let low = usize::from(*packed.get(at)?);
            at += 1;
            let back = (usize::from(control & 31) << 8 | low) + 1;
            let from = whole.len().checked_sub(back)?;
            // What is copied may be part of the copy.
            for place in from..from + length + 2 {
                whole.push(*whole.get(place)?);
            }
        }
        if whole.len() > size {
            return None;
        }
    }
    (whole.len() == size).then_some(whole)
}

#[cfg(test)]
mod tests {
    use super::unpack;

    #[test]
    fn literals_and_references_are_put_together_and_nothing_beyond_them() {
        // "abc", then 9 bytes from 3 back, then 300 of the last.
        let packed = [2, b'a', b'b', b'c', 0xE0, 0, 2, 0xE0, 255, 0, 0xE0, 28, 0];
        let whole = unpack(&packed, 3 + 9 + 264 + 37).unwrap();
        assert_eq!(&whole[..12], b"abcabcabcabc");
        assert!(whole[12..].iter().all(|&byte| byte == b'c'));
        assert_eq!(unpack(&packed, 7), None);
        assert_eq!(unpack(&packed[..5], 12), None);
        assert_eq!(unpack(&[0x20, 9], 3), None);
        assert_eq!(unpack(&[], usize::MAX), None);
    }
}
