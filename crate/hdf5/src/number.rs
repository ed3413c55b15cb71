//! Numbers of any kind that HDF5 has, as `f64`.

use hdf5_reader::error::Error;
use hdf5_reader::{ByteOrder, Datatype, H5Type};

/// A number of an array, whatever it is stored as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Number(pub(crate) f64);

/// How a number is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Stored {
    size: usize,
    is_float: bool,
    is_signed: bool,
    order: ByteOrder,
}

impl Stored {
    /// `None` where it is no number.
    fn of(kind: &Datatype) -> Option<Self> {
        let (size, is_float, is_signed, order) = match kind {
            Datatype::FixedPoint {
                size,
                signed,
                byte_order,
            } => (*size, false, *signed, *byte_order),
            Datatype::FloatingPoint { size, byte_order } => (*size, true, true, *byte_order),
            // Truth values are an enumeration.
            Datatype::Enum { base, .. } => return Self::of(base),
            _ => return None,
        };
        let exists = matches!(size, 1 | 2 | 4 | 8) && !(is_float && size == 1);
        exists.then_some(Self {
            size: usize::from(size),
            is_float,
            is_signed,
            order,
        })
    }

    fn read(self, bytes: &[u8]) -> Option<f64> {
        let mut word = [0u8; 8];
        let low = word.get_mut(..self.size)?;
        low.copy_from_slice(bytes.get(..self.size)?);
        if self.order == ByteOrder::BigEndian {
            low.reverse();
        }
        let raw = u64::from_le_bytes(word);
        Some(match (self.is_float, self.size) {
            (true, 2) => half(raw as u16),
            (true, 4) => f64::from(f32::from_bits(raw as u32)),
            (true, _) => f64::from_bits(raw),
            (false, size) if self.is_signed => {
                // The sign is at the top of its own bytes.
                let shift = 64 - 8 * size as u32;
                ((raw << shift) as i64 >> shift) as f64
            }
            (false, _) => raw as f64,
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

/// Whether an array is of numbers.
pub(crate) fn is_numeric(kind: &Datatype) -> bool {
    Stored::of(kind).is_some()
}

/// Whether its numbers are whole ones by their type.
pub(crate) fn is_whole(kind: &Datatype) -> bool {
    Stored::of(kind).is_some_and(|stored| !stored.is_float)
}

/// Whether single precision loses nothing of its numbers.
pub(crate) fn is_single(kind: &Datatype) -> bool {
    Stored::of(kind).is_some_and(|stored| stored.is_float && stored.size <= 4)
}

impl H5Type for Number {
    fn hdf5_type() -> Datatype {
        f64::hdf5_type()
    }

    fn from_bytes(bytes: &[u8], kind: &Datatype) -> Result<Self, Error> {
        let value = Stored::of(kind).and_then(|stored| stored.read(bytes));
        value.map(Self).ok_or_else(|| Error::TypeMismatch {
            expected: "a number".to_owned(),
            actual: "something else".to_owned(),
        })
    }

    fn element_size(kind: &Datatype) -> usize {
        Stored::of(kind).map_or(8, |stored| stored.size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_kind_and_order() {
        let whole = |size, signed, byte_order| Datatype::FixedPoint {
            size,
            signed,
            byte_order,
        };
        let float = |size, byte_order| Datatype::FloatingPoint { size, byte_order };
        let (big, little) = (ByteOrder::BigEndian, ByteOrder::LittleEndian);
        let read = |bytes: &[u8], kind| Number::from_bytes(bytes, &kind).unwrap().0;
        assert_eq!(read(&[0xFE], whole(1, true, little)), -2.0);
        assert_eq!(read(&[0xFF, 0xFE], whole(2, true, big)), -2.0);
        assert_eq!(read(&[0xFE, 0xFF], whole(2, false, little)), 65534.0);
        assert_eq!(read(&1.5f32.to_be_bytes(), float(4, big)), 1.5);
        assert_eq!(read(&(-0.1f64).to_le_bytes(), float(8, little)), -0.1);
        assert_eq!(read(&[0x00, 0xC1], float(2, little)), -2.5);
        let truth = Datatype::Enum {
            base: Box::new(whole(1, true, little)),
            members: Vec::new(),
        };
        assert_eq!(read(&[1], truth), 1.0);
        assert!(Number::from_bytes(&[1], &whole(3, true, little)).is_err());
        assert!(Number::from_bytes(&[1], &float(8, little)).is_err());
    }
}
