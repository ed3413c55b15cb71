//! What holds of the engine as a whole, seen from outside. One binary: each costs a link, natively
//! and under wasm.

#[cfg(target_arch = "wasm32")]
#[macro_use]
extern crate fit4cad_testing;

mod audit;
mod benchmark;
mod conversions;
mod field;
mod golden;
mod hostile_input;
mod hough;
mod real_files;
mod sample;
mod scans;
mod scoring;
mod surfaces;
