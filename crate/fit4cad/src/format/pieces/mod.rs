//! Clouds that hold the points of one primitive each, as CloudCompare's RANSAC leaves them: their names tell
//! the type, their coordinates which points of the model they are.

mod matching;
mod name;
mod union;

#[cfg(test)]
mod tests;

pub(super) use matching::onto;
pub(super) use name::{PieceName, of_path};
pub(super) use union::Union;

use crate::cloud::Point;
use crate::surface::SurfaceType;

/// The points of one primitive, out of a file of their own.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece<'a> {
    /// Path of the file.
    pub(super) path: &'a str,
    /// The type that its name tells.
    pub(super) kind: SurfaceType,
    /// The points, as the file has them.
    pub(super) points: Vec<Point>,
}
