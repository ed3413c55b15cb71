//! STEP files as JavaScript sees them: a thin wasm-bindgen boundary over [`fit4cad_step`]. A module
//! apart from the engine, fetched at the first STEP file: the reader is as large as the scorer.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod declared;
mod options;
mod part;
mod report;
mod write;

pub use declared::{OptionInfo, OptionKind, import_options};
pub use options::ImportOptions;
pub use part::{Part, PartFiles, Sampled};
pub use report::{BodyReport, FaceReport, ImportReport};
pub use write::{StepText, write};
