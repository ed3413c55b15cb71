//! The four text files of a model: reading, writing and grouping them.

mod assemble;
mod cloud;
mod entry;
mod findings;
pub mod group;
pub mod limits;
mod number;
mod numbering;
mod primitives;
mod read;
mod scan;
mod surfaces;
mod write;

#[cfg(test)]
mod tests;

pub use assemble::{Named, assemble};
pub use cloud::{CloudText, read_cloud};
pub use group::{Grouping, ModelFiles, Override, PlacedFile, Unplaced, group, model_number};
pub use numbering::{Numbering, PointNumber};
pub use primitives::{PointList, read_primitives};
pub use read::{Role, SourceFile, read_model};
pub use surfaces::{SurfaceEntry, SurfaceFile, read_surfaces};
pub use write::{write_cloud, write_primitives, write_surfaces};
