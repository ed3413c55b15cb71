//! The files of a model: reading, writing and grouping them.

mod assemble;
mod cloud;
mod contents;
mod counting;
mod encoding;
mod entry;
mod files;
mod findings;
pub mod foreign;
pub mod group;
mod labels;
pub mod limits;
mod number;
mod one_a_row;
mod paths;
mod pieces;
mod primitives;
mod purpose;
mod read;
mod readers;
mod scan;
mod segments;
mod shrec;
mod source;
mod surfaces;
mod typed;
pub mod types;
mod window;
mod write;

#[cfg(test)]
mod tests;

pub use assemble::{Named, assemble};
pub use cloud::{CloudFile, read_cloud};
pub use contents::{read_cloud_by_pieces, read_foreign_cloud_by_pieces};
pub use files::{FILE_KINDS, FileKind, Holds};
pub use group::{
    Grouping, ModelFiles, Override, PlacedFile, Recognised, Unplaced, group, model_number,
};
pub use labels::{Segment, by_label};
pub use paths::{Layout, file_name, path_of};
pub use primitives::{PointList, read_primitives};
pub use read::{Reading, read_files, read_model};
pub use readers::{Readers, Taken};
pub use shrec::{read_answer, write_answer};
pub use source::{Role, Source, SourceFile};
pub use surfaces::{SurfaceEntry, SurfaceFile, read_surfaces};
pub use write::{write_cloud, write_primitives, write_surfaces};
