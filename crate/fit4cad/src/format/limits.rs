//! How much one file may ask for. Each is well above the benchmark's largest (49,000 points, 104
//! primitives, 2.5 MB) and low enough that a hostile file cannot exhaust a browser tab.

/// Bytes in one file: 512 MiB.
pub const MAX_FILE_BYTES: u64 = 512 << 20;

/// Bytes in all files of one model: 1 GiB. The text is read file by file, and no file's result is
/// larger than twice its text (an index of four bytes for a digit and a blank), so that text and
/// results of a model stay below the 4 GiB that wasm can address.
pub const MAX_MODEL_BYTES: u64 = 1 << 30;

/// Points in one cloud, broken rows included.
pub const MAX_POINTS: usize = 10_000_000;

/// Entries (`PrimitiveK:=[…];`) in one file.
pub const MAX_PRIMITIVES: usize = 100_000;

/// Indices listed in one file, over all its primitives.
pub const MAX_INDICES: usize = 50_000_000;

/// Findings of one kind shown for one file; the rest are counted.
pub const MAX_SIMILAR_DIAGNOSTICS: usize = 8;
