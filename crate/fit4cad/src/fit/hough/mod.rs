//! HT: the Hough-transform fitter (paper, section "HT: Simple primitive fitting based on Hough
//! transform").

pub mod accumulator;
pub mod directions;
pub mod family;
pub mod gamma;
pub mod grid;
pub mod persistence;
pub mod space;
pub mod vote;
