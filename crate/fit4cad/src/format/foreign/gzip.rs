//! Files packed by gzip (RFC 1952), of one member or several, unpacked from the beginning as far as they are asked for.

use std::borrow::Cow;

use miniz_oxide::inflate::stream::{InflateState, inflate};
use miniz_oxide::{DataFormat, MZFlush, MZStatus};

use crate::format::limits::MAX_FILE_BYTES;

/// Packed bytes that are had at a time.
const PACKED: u64 = 1 << 20;

/// Bytes that are unpacked at a time.
const UNPACKED: usize = 1 << 16;

/// Unpacked bytes of which two copies are too many.
const LONG: usize = 1 << 20;

/// Longest head of a member, in bytes: the file's name and a remark are in it.
const LONGEST_HEAD: u64 = 1 << 17;

/// Whether bytes begin as what gzip packs.
pub fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1F, 0x8B])
}

/// What gzip packed; `None` where it cannot be had, or is larger than
/// [`MAX_FILE_BYTES`].
pub fn unpack_gzip(bytes: &[u8]) -> Option<Vec<u8>> {
    let part = |from: u64, to: u64| {
        let [from, to] = [from, to].map(|at| usize::try_from(at).unwrap_or(usize::MAX));
        Ok(Cow::Borrowed(bytes.get(from..to).unwrap_or_default()))
    };
    let mut unpacking = Unpacking::new(bytes.len() as u64, &part);
    let whole = unpacking.read(0, MAX_FILE_BYTES + 1).ok()?;
    (whole.len() as u64 <= MAX_FILE_BYTES).then_some(whole)
}

/// The bytes of a packed file from one offset to before another.
pub(in crate::format) type Packed<'s> = dyn Fn(u64, u64) -> Result<Cow<'s, [u8]>, String> + 's;

const DAMAGED: &str = "what gzip packed is damaged";

/// A packed file while it is unpacked. Of what was unpacked only that is held that was asked for last: whoever reads
/// forwards has it unpacked once, whoever goes back has it begun anew.
pub(in crate::format) struct Unpacking<'s> {
    part: &'s Packed<'s>,
    /// Packed bytes in all.
    size: u64,
    state: Box<InflateState>,
    /// Whether a member has begun and not ended.
    within: bool,
    /// Offset of the packed bytes that come next, some of which are here.
    at: u64,
    input: Cow<'s, [u8]>,
    taken: usize,
    /// Offset of what is held in what is unpacked.
    start: u64,
    held: Vec<u8>,
}

impl<'s> Unpacking<'s> {
    /// Of a file of so many packed bytes.
    pub(in crate::format) fn new(size: u64, part: &'s Packed<'s>) -> Self {
        Self {
            part,
            size,
            state: InflateState::new_boxed(DataFormat::Raw),
            within: false,
            at: 0,
            input: Cow::Borrowed(&[]),
            taken: 0,
            start: 0,
            held: Vec::new(),
        }
    }

    /// How long it is unpacked, which is found out by unpacking it; no more than a byte beyond [`MAX_FILE_BYTES`].
    ///
    /// # Errors
    /// Why it cannot be unpacked to its end.
    pub(in crate::format) fn length(&mut self) -> Result<u64, String> {
        self.rewind();
        while self.start <= MAX_FILE_BYTES && self.unpack()? {
            self.start += self.held.len() as u64;
            self.held.clear();
        }
        Ok(self.start)
    }

    /// The unpacked bytes from one offset to before another; fewer where it ends before.
    ///
    /// # Errors
    /// Why they cannot be had.
    pub(in crate::format) fn read(&mut self, from: u64, to: u64) -> Result<Vec<u8>, String> {
        if from < self.start {
            self.rewind();
        }
        loop {
            let gone = usize::try_from(from - self.start).unwrap_or(usize::MAX);
            let gone = gone.min(self.held.len());
            self.held.drain(..gone);
            self.start += gone as u64;
            if self.start == from {
                break;
            }
            if !self.unpack()? {
                return Ok(Vec::new());
            }
        }
        let length = usize::try_from(to.saturating_sub(from)).unwrap_or(usize::MAX);
        if (LONG..=16 * LONG).contains(&length) {
            let room = length + UNPACKED;
            self.held
                .reserve_exact(room.saturating_sub(self.held.len()));
        }
        while self.held.len() < length && self.unpack()? {}
        if length >= LONG {
            // Of a long piece there is no second copy; whoever wants it again has it unpacked again.
            let rest = self.held.split_off(length.min(self.held.len()));
            self.start += self.held.len() as u64;
            return Ok(std::mem::replace(&mut self.held, rest));
        }
        let held = self.held.get(..length).unwrap_or(&self.held);
        Ok(held.to_vec())
    }

    fn rewind(&mut self) {
        let new = Self::new(self.size, self.part);
        let state = std::mem::replace(self, new).state;
        self.state = state;
    }

    /// Unpacks some more behind what is held; whether there was any.
    fn unpack(&mut self) -> Result<bool, String> {
        let before = self.held.len();
        while self.held.len() == before {
            if !self.within && !self.begin_member()? {
                return Ok(false);
            }
            self.fetch()?;
            self.held.resize(before + UNPACKED, 0);
            let room = self.held.get_mut(before..).unwrap_or_default();
            let packed = self.input.get(self.taken..).unwrap_or_default();
            let done = inflate(&mut self.state, packed, room, MZFlush::None);
            self.held.truncate(before + done.bytes_written);
            self.taken += done.bytes_consumed;
            match done.status {
                Ok(MZStatus::StreamEnd) => {
                    self.within = false;
                    // Its checksum and its length.
                    let behind = self.at - (self.input.len() - self.taken) as u64;
                    self.seek(behind + 8);
                }
                Ok(_) if done.bytes_consumed + done.bytes_written > 0 => {}
                _ => return Err(DAMAGED.to_owned()),
            }
        }
        Ok(true)
    }

    /// Has the next packed bytes, where none are here.
    fn fetch(&mut self) -> Result<(), String> {
        if self.taken < self.input.len() {
            return Ok(());
        }
        let end = self.size.min(self.at.saturating_add(PACKED));
        self.input = (self.part)(self.at.min(end), end)?;
        self.taken = 0;
        self.at += self.input.len() as u64;
        if self.input.is_empty() {
            return Err("what gzip packed is cut off".to_owned());
        }
        Ok(())
    }

    fn seek(&mut self, at: u64) {
        self.at = at;
        self.input = Cow::Borrowed(&[]);
        self.taken = 0;
    }

    /// Passes over the head of a member; whether there is one. What else may follow the last is nothing.
    fn begin_member(&mut self) -> Result<bool, String> {
        let at = self.at;
        if at >= self.size {
            return Ok(false);
        }
        let end = self.size.min(at.saturating_add(LONGEST_HEAD));
        let head = (self.part)(at, end)?;
        if !is_gzip(&head) && at > 0 {
            return Ok(false);
        }
        let length = head_length(&head).ok_or(DAMAGED)?;
        self.seek(at + length as u64);
        self.state.reset(DataFormat::Raw);
        self.within = true;
        Ok(true)
    }
}

/// Bytes of a member's head.
fn head_length(bytes: &[u8]) -> Option<usize> {
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
    Some(at)
}
