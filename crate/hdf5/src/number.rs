//! Numbers of any kind that HDF5 has, as `f64`.

use fit4cad::format::foreign::{Scalar, ScalarKind};
use hdf5_reader::error::Error;
use hdf5_reader::{ByteOrder, Datatype, H5Type};

/// A number of an array, whatever it is stored as.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Number(pub(crate) f64);

/// How an array's numbers are stored; `None` where it has none.
fn stored(kind: &Datatype) -> Option<Scalar> {
    let (kind, size, order) = match kind {
        Datatype::FixedPoint {
            size,
            signed: true,
            byte_order,
        } => (ScalarKind::Signed, size, byte_order),
        Datatype::FixedPoint {
            size, byte_order, ..
        } => (ScalarKind::Unsigned, size, byte_order),
        Datatype::FloatingPoint { size, byte_order } => (ScalarKind::Float, size, byte_order),
        // Truth values are an enumeration.
        Datatype::Enum { base, .. } => return stored(base),
        _ => return None,
    };
    Scalar::new(kind, usize::from(*size), *order == ByteOrder::BigEndian)
}

/// Whether an array is of numbers.
pub(crate) fn is_numeric(kind: &Datatype) -> bool {
    stored(kind).is_some()
}

/// Whether its numbers are whole ones by their type.
pub(crate) fn is_whole(kind: &Datatype) -> bool {
    stored(kind).is_some_and(|stored| stored.kind != ScalarKind::Float)
}

/// Whether single precision loses nothing of its numbers.
pub(crate) fn is_single(kind: &Datatype) -> bool {
    stored(kind).is_some_and(|stored| stored.kind == ScalarKind::Float && stored.size <= 4)
}

impl H5Type for Number {
    fn hdf5_type() -> Datatype {
        f64::hdf5_type()
    }

    fn from_bytes(bytes: &[u8], kind: &Datatype) -> Result<Self, Error> {
        let value = stored(kind).and_then(|stored| stored.read(bytes, 0));
        value.map(Self).ok_or_else(|| Error::TypeMismatch {
            expected: "a number".to_owned(),
            actual: "something else".to_owned(),
        })
    }

    fn element_size(kind: &Datatype) -> usize {
        stored(kind).map_or(8, |stored| stored.size)
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
