//! STEP files as models of the benchmark.
//!
//! Bytes of a STEP file (ISO 10303-21; AP203, AP214, AP242) become trimmed faces, placed as the
//! assembly places them and in millimetres; faces become points that lie exactly on their surfaces,
//! and the truth of which face each point came from.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(all(test, target_arch = "wasm32"))]
#[macro_use]
extern crate fit4cad_testing;

mod declared;
mod document;
mod error;
mod face;
mod file;
mod geometry;
mod import;
mod join;
mod options;
mod placement;
mod read;
mod recognise;
mod report;
mod sampling;
mod sight;
mod units;
mod write;

pub use declared::{OptionInfo, OptionValue, import_options};
pub use document::{Document, Progress};
pub use error::{StepError, Trouble};
pub use file::LARGEST_FILE;
pub use import::Import;
pub use options::{Amount, Options, Spread};
pub use placement::{Frame, Motion};
pub use report::{BodyReport, FaceReport, Report};
pub use write::{Colour, write_step};
