//! Numbers as they lie in binary files.

/// How a number is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scalar {
    /// What it is.
    pub kind: Kind,
    /// In bytes.
    pub size: usize,
    /// Whether the byte of most weight comes first.
    pub big_endian: bool,
}

/// What a stored number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A whole number in two's complement.
    Signed,
    /// A whole number without sign.
    Unsigned,
    /// Of IEEE 754.
    Float,
}

impl Scalar {
    /// One of a kind and size that there is: whole numbers of 1, 2, 4 and 8 bytes, others of 2, 4 and 8.
    pub fn new(kind: Kind, size: usize, big_endian: bool) -> Option<Self> {
        let exists = match kind {
            Kind::Float => matches!(size, 2 | 4 | 8),
            Kind::Signed | Kind::Unsigned => matches!(size, 1 | 2 | 4 | 8),
        };
        exists.then_some(Self {
            kind,
            size,
            big_endian,
        })
    }

    /// The number that lies at an offset; `None` where the bytes end before.
    #[inline]
    pub fn read(self, bytes: &[u8], at: usize) -> Option<f64> {
        let bytes = bytes.get(at..at.checked_add(self.size)?)?;
        let mut word = [0u8; 8];
        let low = word.get_mut(..self.size)?;
        low.copy_from_slice(bytes);
        if self.big_endian {
            low.reverse();
        }
        let raw = u64::from_le_bytes(word);
        Some(match (self.kind, self.size) {
            (Kind::Unsigned, _) => raw as f64,
            (Kind::Signed, size) => {
                // The sign is at the top of its own bytes.
                let shift = 64 - 8 * size as u32;
                ((raw << shift) as i64 >> shift) as f64
            }
            (Kind::Float, 2) => half(raw as u16),
            (Kind::Float, 4) => f64::from(f32::from_bits(raw as u32)),
            (Kind::Float, _) => f64::from_bits(raw),
        })
    }
}

/// A number of IEEE 754 binary16.
fn half(bits: u16) -> f64 {
    let sign = if bits >> 15 == 0 { 1.0 } else { -1.0 };
    let exponent = i32::from(bits >> 10 & 31);
    let fraction = f64::from(bits & 1023);
    sign * match exponent {
        0 => fraction / 1024.0 * (2.0f64).powi(-14),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1.0 + fraction / 1024.0) * (2.0f64).powi(exponent - 15),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_kind_and_order() {
        let read = |kind, bytes: &[u8], big| Scalar::new(kind, bytes.len(), big)?.read(bytes, 0);
        assert_eq!(read(Kind::Signed, &[0xFE], false), Some(-2.0));
        assert_eq!(read(Kind::Signed, &[0xFF, 0xFE], true), Some(-2.0));
        assert_eq!(read(Kind::Unsigned, &[0xFF, 0xFE], false), Some(65279.0));
        assert_eq!(
            read(Kind::Signed, &(-7i64).to_le_bytes(), false),
            Some(-7.0)
        );
        assert_eq!(read(Kind::Float, &1.5f32.to_be_bytes(), true), Some(1.5));
        assert_eq!(
            read(Kind::Float, &(-0.1f64).to_le_bytes(), false),
            Some(-0.1)
        );
        assert_eq!(read(Kind::Float, &[0x00, 0xC1], false), Some(-2.5));
        assert_eq!(
            read(Kind::Float, &[0x01, 0x00], false),
            Some(2.0f64.powi(-24))
        );
        assert_eq!(read(Kind::Float, &[0], false), None);
        let wide = Scalar::new(Kind::Float, 8, false).unwrap();
        assert_eq!(wide.read(&[0; 8], usize::MAX), None);
    }
}
