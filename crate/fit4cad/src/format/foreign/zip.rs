//! The zips that NumPy writes: entries stored or deflated, found by the directory at the end.

use std::borrow::Cow;

use crate::format::limits::MAX_FILE_BYTES;

/// More entries than arrays that anybody keeps together.
const MOST_ENTRIES: usize = 4096;

/// One entry of the directory.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) name: String,
    deflated: bool,
    packed: usize,
    whole: usize,
    /// Offset of its local head.
    at: usize,
}

fn short(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes: [u8; 2] = bytes.get(at..at.checked_add(2)?)?.try_into().ok()?;
    Some(usize::from(u16::from_le_bytes(bytes)))
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(bytes)).ok()
}

/// The entries of a zip, but for those packed in some other way; `None` where it has no directory.
pub(super) fn entries(bytes: &[u8]) -> Option<Vec<Entry>> {
    // The end is 22 bytes and a remark of at most 65,535.
    let from = bytes.len().saturating_sub(22 + 65_535);
    let tail = bytes.get(from..)?;
    let end = from + tail.windows(4).rposition(|four| four == b"PK\x05\x06")?;
    let count = short(bytes, end + 10)?.min(MOST_ENTRIES);
    let mut at = long(bytes, end + 16)?;
    let mut entries = Vec::new();
    for _ in 0..count {
        if bytes.get(at..at.checked_add(4)?)? != b"PK\x01\x02" {
            break;
        }
        let (name, extra, remark) = (
            short(bytes, at + 28)?,
            short(bytes, at + 30)?,
            short(bytes, at + 32)?,
        );
        let method = short(bytes, at + 10)?;
        let text = bytes.get(at + 46..at + 46 + name)?;
        if matches!(method, 0 | 8) {
            entries.push(Entry {
                name: String::from_utf8_lossy(text).into_owned(),
                deflated: method == 8,
                packed: long(bytes, at + 20)?,
                whole: long(bytes, at + 24)?,
                at: long(bytes, at + 42)?,
            });
        }
        at = at.checked_add(46 + name + extra + remark)?;
    }
    Some(entries)
}

impl Entry {
    /// The bytes that were packed; `None` where they are not what the directory says.
    pub(super) fn unpack<'z>(&self, zip: &'z [u8]) -> Option<Cow<'z, [u8]>> {
        if zip.get(self.at..self.at.checked_add(4)?)? != b"PK\x03\x04" {
            return None;
        }
        let head = 30 + short(zip, self.at + 26)? + short(zip, self.at + 28)?;
        let start = self.at.checked_add(head)?;
        let packed = zip.get(start..start.checked_add(self.packed)?)?;
        if !self.deflated {
            return (self.packed == self.whole).then_some(Cow::Borrowed(packed));
        }
        if self.whole as u64 > MAX_FILE_BYTES {
            return None;
        }
        let whole = miniz_oxide::inflate::decompress_to_vec_with_limit(packed, self.whole).ok()?;
        (whole.len() == self.whole).then_some(Cow::Owned(whole))
    }
}

/// Whether the first entry of a zip is an array of NumPy.
pub(super) fn holds_arrays(bytes: &[u8]) -> bool {
    let name = short(bytes, 26).and_then(|length| bytes.get(30..30 + length));
    name.is_some_and(|name| name.ends_with(b".npy"))
}
