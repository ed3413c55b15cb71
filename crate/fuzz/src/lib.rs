//! What is fuzzed: a target for every parser and every function that takes what a reader, a link or a
//! script can give. The runner beside this library mutates inputs and watches.
//!
//! A target takes bytes and does with them what the page or the command line would. What it must
//! not do is panic, run for more than two seconds, or hold far more memory than its input is long; what
//! must hold besides of the result it asserts. Text goes in as it is; other arguments are decoded
//! with [`Bytes`], for which every input stands for something.

mod bytes;
mod shapes;
mod targets;

pub use bytes::Bytes;
pub use targets::{PLANTED, TARGETS};

/// Something to be fuzzed.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Name by which it is asked for, and of its file of inputs.
    pub name: &'static str,
    /// Runs it on an input.
    pub run: fn(&[u8]),
    /// Inputs to begin with, made by the project's own generator and writers.
    pub seeds: fn() -> Vec<Vec<u8>>,
    /// What belongs into its inputs and chance would hardly make.
    pub words: &'static [&'static str],
    /// Most bytes of an input.
    pub longest: usize,
    /// Bytes of memory that it may hold whatever its input; to these come 1,000 per byte of it.
    pub floor: usize,
    /// How many runs a quick look gives it: about a second.
    pub quick: u64,
}
