//! HT: the Hough-transform fitter (paper, section "HT: Simple primitive fitting based on Hough
//! transform").

pub mod accumulator;
pub mod directions;
pub mod grid;
pub mod persistence;
pub mod space;
