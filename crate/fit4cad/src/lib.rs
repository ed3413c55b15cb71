//! The Fit4CAD engine: reading, fitting and scoring simple primitives in point clouds of CAD objects.
//!
//! Fit4CAD (Romanengo, Raffo, Qie, Anwer and Falcidieno, 2021) is a benchmark for methods that
//! segment a point cloud into planes, cylinders, cones, spheres and tori. This crate holds all of
//! the playground that is not presentation. It is pure: it knows nothing of JavaScript, files on disk
//! or the clock, nor of threads but in [`batch`] where the feature `rayon` is on, so the same code runs
//! natively, in a browser and under Node.
//!
//! Data flows one way: text files → [`mod@format`] → [`model::Model`] → [`fit`] (makes a
//! [`model::Submission`]) → [`metrics`] (makes a report). [`sample`] makes models with known truth,
//! [`audit`] checks one, [`statistics`] counts what a set of models holds; [`batch`] does many at once.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(all(test, target_arch = "wasm32"))]
#[macro_use]
extern crate fit4cad_testing;

pub mod audit;
pub mod batch;
pub mod cloud;
pub mod diagnostics;
mod disjoint;
pub mod export;
pub mod fit;
pub mod format;
pub mod lesson;
pub mod metrics;
pub mod model;
pub mod random;
pub mod sample;
mod sorting;
pub mod statistics;
pub mod surface;
