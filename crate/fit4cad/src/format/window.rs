//! Files that are read piece by piece: of one that is too long to be held, only what is being read is in memory.

use std::borrow::Cow;

use super::scan::is_line_end;

/// Bytes of a piece. Files of up to a few of them are read whole.
pub(super) const PIECE: usize = 4 << 20;

/// A text as something that can be read at any place.
#[derive(Clone, Copy)]
pub(super) struct Text<'t> {
    /// Its length in bytes.
    pub(super) size: u64,
    /// The bytes from one offset to before another, both within it.
    pub(super) part: &'t dyn Fn(u64, u64) -> Result<Cow<'t, [u8]>, String>,
}

impl<'t> Text<'t> {
    fn read(&self, from: u64, to: u64) -> Result<Cow<'t, [u8]>, String> {
        let part = (self.part)(from, to)?;
        if part.len() as u64 == to - from {
            Ok(part)
        } else {
            Err("it became shorter while it was read".to_owned())
        }
    }
}

/// The part of a text that is in memory: all of it, or some that moves on.
pub(super) struct Window<'t> {
    /// Where more comes from; nothing where all is here.
    text: Option<Text<'t>>,
    piece: usize,
    /// Offset of the first byte that is here.
    from: u64,
    bytes: Cow<'t, [u8]>,
    /// Lines before it.
    lines: u32,
}

impl<'t> Window<'t> {
    /// All of a text.
    pub(super) fn whole(bytes: &'t [u8]) -> Self {
        Self {
            text: None,
            piece: 0,
            from: 0,
            bytes: Cow::Borrowed(bytes),
            lines: 0,
        }
    }

    /// The first piece of a text.
    ///
    /// # Errors
    /// Why it cannot be had.
    pub(super) fn open(text: Text<'t>, piece: usize) -> Result<Self, String> {
        let end = text.size.min(piece as u64);
        Ok(Self {
            text: Some(text),
            piece,
            from: 0,
            bytes: text.read(0, end)?,
            lines: 0,
        })
    }

    /// A second one at the same place.
    ///
    /// # Errors
    /// Why what is here cannot be had again.
    pub(super) fn again(&self) -> Result<Self, String> {
        let Some(text) = self.text else {
            return Ok(Self {
                bytes: self.bytes.clone(),
                ..*self
            });
        };
        let end = self.from + self.bytes.len() as u64;
        Ok(Self {
            bytes: text.read(self.from, end)?,
            ..*self
        })
    }

    /// What is here.
    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Offset in the text of what is here.
    pub(super) fn from(&self) -> u64 {
        self.from
    }

    /// How many lines come before what is here.
    pub(super) fn lines(&self) -> u32 {
        self.lines
    }

    /// Length of the text.
    pub(super) fn size(&self) -> u64 {
        self.text.map_or(self.bytes.len() as u64, |text| text.size)
    }

    /// Whether the text ends with what is here.
    pub(super) fn is_last(&self) -> bool {
        self.from + self.bytes.len() as u64 >= self.size()
    }

    /// Reads the next piece behind what is here, or as much as there is already, so that a text of one line takes
    /// no more than linear time.
    ///
    /// # Errors
    /// Why it cannot be had.
    pub(super) fn read_on(&mut self) -> Result<(), String> {
        let Some(text) = self.text.filter(|_| !self.is_last()) else {
            return Ok(());
        };
        let from = self.from + self.bytes.len() as u64;
        let piece = self.piece.max(self.bytes.len()).max(1) as u64;
        let next = text.read(from, text.size.min(from + piece))?;
        if self.bytes.is_empty() {
            self.bytes = next;
        } else {
            let bytes = self.bytes.to_mut();
            bytes.reserve_exact(next.len());
            bytes.extend_from_slice(&next);
        }
        Ok(())
    }

    /// Lets go of the lines before an offset into what is here, and tells the offset of the same byte after that.
    pub(super) fn let_go(&mut self, offset: usize) -> usize {
        let gone = self.bytes.get(..offset).unwrap_or(&self.bytes);
        let ended = |&at: &usize| self.ends_line(at);
        let start = (0..gone.len()).rev().find(ended).map_or(0, |at| at + 1);
        self.lines = self.lines.saturating_add(self.line_ends_before(start));
        self.drop_before(start);
        offset - start
    }

    /// Lets go of the bytes before an offset into what is here, whatever they are, and reads the next piece.
    ///
    /// # Errors
    /// Why it cannot be had.
    pub(super) fn move_on(&mut self, offset: usize) -> Result<(), String> {
        let offset = offset.min(self.bytes.len());
        self.drop_before(offset);
        self.read_on()
    }

    /// Goes on to the next piece behind an offset, which stays that of the same byte; whether there is one.
    ///
    /// # Errors
    /// Why it cannot be had.
    pub(super) fn advance(&mut self, at: &mut usize) -> Result<bool, String> {
        if self.is_last() {
            return Ok(false);
        }
        let gone = (*at).min(self.bytes.len());
        self.move_on(gone)?;
        *at -= gone;
        Ok(true)
    }

    /// So many bytes at an offset, which moves behind them; `None` where the file ends before.
    ///
    /// # Errors
    /// Why they cannot be had.
    pub(super) fn row(&mut self, at: &mut usize, size: usize) -> Result<Option<&[u8]>, String> {
        while self.bytes.len() < at.saturating_add(size) {
            if !self.advance(at)? {
                return Ok(None);
            }
        }
        let start = *at;
        *at += size;
        Ok(self.bytes.get(start..*at))
    }

    /// Hands over every line from an offset on, without what ends it, until `take` has enough. Between the two bytes of
    /// `\r\n` there is an empty one.
    ///
    /// # Errors
    /// Why they cannot be had.
    pub(super) fn each_line(
        &mut self,
        mut at: usize,
        mut take: impl FnMut(&[u8]) -> bool,
    ) -> Result<(), String> {
        loop {
            let end = self.line_end(at)?;
            let lines = self.bytes.get(at..end).unwrap_or_default();
            if !lines.split(|&byte| is_line_end(byte)).all(&mut take) || self.is_last() {
                return Ok(());
            }
            at = self.let_go(end);
            self.read_on()?;
        }
    }

    /// Reads on until so many bytes are here, or all there are.
    ///
    /// # Errors
    /// Why they cannot be had.
    pub(super) fn reach(&mut self, length: usize) -> Result<(), String> {
        while self.bytes.len() < length && !self.is_last() {
            self.read_on()?;
        }
        Ok(())
    }

    fn drop_before(&mut self, start: usize) {
        self.from += start as u64;
        match &mut self.bytes {
            Cow::Borrowed(bytes) => *bytes = bytes.get(start..).unwrap_or_default(),
            Cow::Owned(bytes) => {
                bytes.drain(..start);
            }
        }
    }

    /// Whether a line ends with a byte; of one that ends with `\r\n` it is the second.
    fn ends_line(&self, at: usize) -> bool {
        match self.bytes.get(at) {
            Some(b'\n') => true,
            Some(b'\r') => self.bytes.get(at + 1).is_some_and(|&next| next != b'\n'),
            _ => false,
        }
    }

    fn line_ends_before(&self, end: usize) -> u32 {
        let bytes = self.bytes.get(..end).unwrap_or_default();
        let count = |byte: u8| bytes.iter().filter(|&&it| it == byte).count();
        let (feeds, returns) = (count(b'\n'), count(b'\r'));
        let pairs = match returns {
            0 => 0,
            _ => bytes.windows(2).filter(|two| two == b"\r\n").count(),
        };
        u32::try_from(feeds + returns - pairs).unwrap_or(u32::MAX)
    }

    /// Where the last whole line here ends, which is after an offset; where the text ends here, its end. Reads on
    /// until there is one.
    ///
    /// # Errors
    /// Why more cannot be had.
    pub(super) fn line_end(&mut self, after: usize) -> Result<usize, String> {
        self.last(after, |window, at| window.ends_line(at - 1))
    }

    /// The last place here after an offset that is of a kind; where the text ends here, its end. Reads on until there
    /// is one.
    ///
    /// # Errors
    /// Why more cannot be had.
    pub(super) fn last(
        &mut self,
        after: usize,
        is: impl Fn(&Self, usize) -> bool,
    ) -> Result<usize, String> {
        loop {
            let length = self.bytes.len();
            if self.is_last() {
                return Ok(length);
            }
            if let Some(found) = (after + 1..=length).rev().find(|&at| is(self, at)) {
                return Ok(found);
            }
            self.read_on()?;
        }
    }

    /// What an offset into the text and the lines after it are made of: as much as `wants`, which is shown more and more
    /// until it has enough, or all there is. It is told whether that is so.
    ///
    /// # Errors
    /// Why it cannot be had.
    pub(super) fn look_at<T>(
        &self,
        offset: u64,
        mut wants: impl FnMut(&[u8], bool) -> Option<T>,
    ) -> Result<Option<T>, String> {
        const FIRST: u64 = 4096;
        let size = self.size();
        let Some(text) = self.text else {
            let at = usize::try_from(offset - self.from).unwrap_or(usize::MAX);
            return Ok(wants(self.bytes.get(at..).unwrap_or_default(), true));
        };
        let mut length = FIRST.min(self.piece as u64).max(1);
        loop {
            let end = size.min(offset.saturating_add(length));
            let found = wants(&text.read(offset.min(size), end)?, end == size);
            if found.is_some() || end == size {
                return Ok(found);
            }
            length *= 4;
        }
    }
}

/// Whether a list in the paper's form is between two rows before a byte, whatever came before it: at a bracket that
/// begins a line.
pub(super) fn begins_row(window: &Window<'_>, at: usize) -> bool {
    let bytes = window.bytes();
    bytes.get(at) == Some(&b'[')
        && at
            .checked_sub(1)
            .and_then(|before| bytes.get(before))
            .is_some_and(|&byte| is_line_end(byte))
}
