//! Trimmed faces: what of a surface lies within the bounds.

mod boundary;
mod columns;
mod draw;
mod link;
mod path;

pub(crate) use draw::Trimmed;
