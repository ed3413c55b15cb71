//! HDF5 files of networks that fit primitives (SPFN, CPFN, ParseNet, HPNet) as models of the benchmark. What is in them is
//! told by the names and shapes of their arrays; each model comes out as arrays of NumPy, which the engine reads. A
//! module apart from the engine, fetched at the first such file.
//!
//! Attributes are not read: SPFN's hold pickled objects, and what is pickled by a stranger is a program.

#[cfg(target_arch = "wasm32")]
mod boundary;
mod contents;
mod names;
mod number;
mod opened;
mod storage;

#[cfg(test)]
mod tests;

pub use opened::{Entry, Error, Opened};

#[cfg(target_arch = "wasm32")]
pub use boundary::{ArrayFile, ArrayFileEntry};
