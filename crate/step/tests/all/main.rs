//! The tests of the crate from outside, linked once.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

#[cfg(target_arch = "wasm32")]
#[macro_use]
extern crate fit4cad_testing;

mod assemblies;
mod exporters;
mod hostile;
mod made;
#[cfg(not(target_arch = "wasm32"))]
mod open_cascade;
#[cfg(not(target_arch = "wasm32"))]
mod oracle;
mod readers_faults;
mod sampling;
mod scanning;
mod writing;
