//! Files packed by gzip (RFC 1952).

use crate::format::limits::MAX_FILE_BYTES;

/// Whether bytes begin as what gzip packs.
pub fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1F, 0x8B])
}

/// What gzip packed; `None` where it cannot be had, or is larger than
/// [`MAX_FILE_BYTES`].
pub fn unpack_gzip(bytes: &[u8]) -> Option<Vec<u8>> {
    let flags = *bytes.get(3)?;
    let mut at = 10;
    if flags & 4 != 0 {
        let length: [u8; 2] = bytes.get(at..at + 2)?.try_into().ok()?;
        at += 2 + usize::from(u16::from_le_bytes(length));
    }
    // Name and remark, each ended by a zero.
    for flag in [8, 16] {
        if flags & flag != 0 {
            at += bytes.get(at..)?.iter().position(|&byte| byte == 0)? + 1;
        }
    }
    if flags & 2 != 0 {
        at += 2;
    }
    let most = usize::try_from(MAX_FILE_BYTES).unwrap_or(usize::MAX);
    miniz_oxide::inflate::decompress_to_vec_with_limit(bytes.get(at..)?, most).ok()
}
