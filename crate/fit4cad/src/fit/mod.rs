//! Methods that make a submission from a bare cloud.

pub mod hough;
