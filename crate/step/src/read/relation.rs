//! Which representations belong together.

use crate::error::Got;
use crate::file::File;

/// The two representations of a relationship.
pub(super) fn relates(file: &File, id: u64) -> Got<[u64; 2]> {
    let own = file
        .part(id, "REPRESENTATION_RELATIONSHIP", 0)
        .map_or_else(|| file.fields(id), Ok)?;
    Ok([own.reference(2)?, own.reference(3)?])
}
