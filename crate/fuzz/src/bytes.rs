//! Arguments out of bytes, so that mutating bytes mutates arguments.

/// Numbers at the edges of what there is.
const SPECIAL: [f64; 32] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    10.0,
    45.0,
    90.0,
    360.0,
    1e-3,
    1e-6,
    1e-9,
    1e-12,
    1e-16,
    1e-100,
    1e-154,
    1e-308,
    1e-320,
    f64::EPSILON,
    1e6,
    1e9,
    1e15,
    1e31,
    1e77,
    1e154,
    1e300,
    1e308,
    f64::MAX,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

/// First byte of a number that is followed by all its eight bytes.
const EXACT: u8 = 32;
/// First byte of a number that is followed by its two as a multiple of 1/64.
const MEDIUM: u8 = 96;
/// First byte of a whole number from −48 to 47.
const SMALL: u8 = 160;

/// Bytes read from the front. Beyond the end they are zeros.
#[derive(Debug, Clone)]
pub struct Bytes<'a> {
    left: &'a [u8],
}

impl<'a> Bytes<'a> {
    /// All of some bytes.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { left: bytes }
    }

    /// Whether none is left.
    pub fn is_empty(&self) -> bool {
        self.left.is_empty()
    }

    /// What is left.
    pub fn rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.left)
    }

    /// What is left up to a byte, which goes with it; all where there is none.
    pub fn until(&mut self, end: u8) -> &'a [u8] {
        let Some(at) = self.left.iter().position(|&byte| byte == end) else {
            return self.rest();
        };
        let (part, rest) = self.left.split_at(at);
        self.left = rest.get(1..).unwrap_or_default();
        part
    }

    fn take<const N: usize>(&mut self) -> [u8; N] {
        let count = N.min(self.left.len());
        let (part, rest) = self.left.split_at(count);
        self.left = rest;
        let mut bytes = [0; N];
        bytes[..count].copy_from_slice(part);
        bytes
    }

    /// A byte.
    pub fn byte(&mut self) -> u8 {
        let [byte] = self.take();
        byte
    }

    /// Yes or no.
    pub fn flag(&mut self) -> bool {
        self.byte() & 1 == 1
    }

    /// A whole number below a bound of at most 256; 0 where that is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        usize::from(self.byte()) % bound.max(1)
    }

    /// One of some values.
    pub fn one<T: Copy, const N: usize>(&mut self, of: [T; N]) -> T {
        of[self.below(N)]
    }

    /// A whole number: small ones as a rule, else any.
    pub fn whole(&mut self) -> u32 {
        match self.byte() {
            255 => u32::from_le_bytes(self.take()),
            small => u32::from(small),
        }
    }

    /// A seed.
    pub fn seed(&mut self) -> u64 {
        u64::from(self.whole())
    }

    /// A number: a whole one, one of middling size, one at the edges, or any.
    pub fn number(&mut self) -> f64 {
        match self.byte() {
            tag if tag < EXACT => SPECIAL[usize::from(tag)],
            tag if tag < MEDIUM => f64::from_bits(u64::from_le_bytes(self.take())),
            tag if tag < SMALL => f64::from(i16::from_le_bytes(self.take())) / 64.0,
            tag => f64::from(tag - SMALL) - 48.0,
        }
    }

    /// The same in single precision.
    pub fn single(&mut self) -> f32 {
        self.number() as f32
    }

    /// As many numbers.
    pub fn numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.number())
    }

    /// A list of what a function reads, of up to `most` (at most 255), while there are bytes.
    pub fn list<T>(&mut self, most: usize, mut each: impl FnMut(&mut Self) -> T) -> Vec<T> {
        let count = self.below(most + 1);
        let mut list = Vec::new();
        while list.len() < count && !self.is_empty() {
            list.push(each(self));
        }
        list
    }

    /// Text up to a zero byte; what is no UTF-8 is replaced.
    pub fn text(&mut self) -> String {
        String::from_utf8_lossy(self.until(0)).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beyond_the_end_there_are_zeros() {
        let mut bytes = Bytes::new(&[SMALL + 50, MEDIUM, 64]);
        assert_eq!(bytes.number(), 2.0);
        assert_eq!(bytes.number(), 1.0);
        assert!(bytes.is_empty());
        assert_eq!((bytes.whole(), bytes.number()), (0, 0.0));
    }

    #[test]
    fn parts_end_where_they_say() {
        let mut bytes = Bytes::new(b"ab\0c");
        assert_eq!(bytes.text(), "ab");
        assert_eq!(bytes.until(b'x'), b"c");
        assert!(bytes.is_empty());
    }
}
