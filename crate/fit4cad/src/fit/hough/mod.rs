//! HT: the Hough-transform fitter (paper, section "HT: Simple primitive fitting based on Hough
//! transform").

pub mod accumulator;
mod borders;
mod coaxial;
mod curve;
pub mod directions;
pub mod family;
mod find;
pub mod gamma;
pub mod grid;
mod noisy;
pub mod persistence;
mod rounds;
mod solutions;
pub mod space;
pub mod trace;
pub mod vote;

pub use find::find;
