//! The bytes of a file, had where they are asked for: it may be larger than memory.

use std::sync::Arc;

use fit4cad::format::foreign::unpack_lzf;
use hdf5_reader::error::Error;
use hdf5_reader::storage::DynStorage;
use hdf5_reader::{BlockCacheStorage, FilterRegistry, OpenOptions, RangeRequestStorage};

/// Bytes that are had at a time, and how many such blocks are kept: directories of arrays lie all over a file.
const BLOCK: usize = 1 << 16;
const BLOCKS: usize = 256;

/// Most bytes of one array of one model: what the engine reads of a file.
const MOST_BYTES: usize = fit4cad::format::limits::MAX_FILE_BYTES as usize;

/// h5py's own filter, registered with The HDF Group under this number.
const LZF: u16 = 32_000;

/// A file of so many bytes, of which `read` gives those from an offset on.
pub(crate) fn storage(
    size: u64,
    read: impl Fn(u64, usize) -> Result<Vec<u8>, String> + Send + Sync + 'static,
) -> DynStorage {
    let read = move |from: u64, length: usize| read(from, length).map_err(Error::Other);
    let all = Arc::new(RangeRequestStorage::new(size, read));
    Arc::new(BlockCacheStorage::new(all, BLOCK, BLOCKS))
}

/// How files are opened: with h5py's filter, and within the limits of the engine.
pub(crate) fn options() -> OpenOptions {
    let mut filters = FilterRegistry::new();
    filters.register(
        LZF,
        Box::new(|filter, packed, _| {
            // Version of the filter, of the library, and the bytes of a chunk.
            let size = filter.client_data.get(2).map_or(0, |&size| size as usize);
            let whole = unpack_lzf(packed, size.min(MOST_BYTES));
            whole.ok_or_else(|| Error::FilterError("the data is damaged".to_owned()))
        }),
    );
    OpenOptions::default()
        .with_filter_registry(filters)
        .with_max_read_bytes(MOST_BYTES)
}
