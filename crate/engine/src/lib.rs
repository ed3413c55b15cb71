//! The engine as JavaScript sees it: a thin wasm-bindgen boundary over [`fit4cad`].
//!
//! Points cross as typed arrays, everything else as small plain objects whose TypeScript types are
//! generated from the Rust ones. Nothing is computed here: each function reads its arguments, calls
//! the engine and hands the result over. Failures are JavaScript errors with a clear text.

#[cfg(feature = "workshop")]
mod audit;
mod diagnostic;
#[cfg(feature = "workshop")]
mod fit;
mod group;
mod imperfect;
mod input;
#[cfg(feature = "workshop")]
mod lesson;
mod lists;
mod look;
mod model;
mod part;
mod primitive;
mod report;
mod statistics;
mod stop;
#[cfg(feature = "workshop")]
mod studio;
mod summary;

#[cfg(feature = "workshop")]
pub use audit::{Audit, Corrected, Correction, Finding, FormAudit, PrimitiveAudit};
pub use diagnostic::{DiagnosticInfo, Severity};
#[cfg(feature = "workshop")]
pub use fit::{FitMethod, FitParameters, ParameterInfo, fit_parameters};
pub use group::{Grouping, ModelFiles, Override, Overrides, PlacedFile, Unplaced, group};
pub use input::{InputFile, Role};
#[cfg(feature = "workshop")]
pub use lesson::forms::{FormComparison, Forms, SurfaceSliders};
#[cfg(feature = "workshop")]
pub use lesson::growing::{GrowingLesson, PartitionInfo, SlippageInfo, SplitInfo};
#[cfg(feature = "workshop")]
pub use lesson::hough::{
    AxisInfo, CellInfo, HoughLesson, MaximumInfo, PolishInfo, RivalInfo, SliceInfo,
};
#[cfg(feature = "workshop")]
pub use lesson::painting::{CountsInfo, PaintedScore};
pub use lists::PointLists;
pub use look::PatchMesh;
pub use model::{BoundsInfo, Model, ModelInfo, Texts};
pub use part::{PartInfo, SampleOptions, parts};
pub use primitive::{PrimitiveInfo, SurfaceInfo, SurfaceType};
pub use report::{
    Hidden, Measures, PredictionReport, Protocol, Report, TruthReport, TypeConfusion,
};
pub use statistics::{DatasetStatistics, ModelStatistics, Spread, Types, dataset_statistics};
#[cfg(feature = "workshop")]
pub use studio::{Block, Operation, ShapeInfo, shapes};
pub use summary::{Distribution, distribution};

use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// Version of the engine.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// Hands a plain value to JavaScript.
fn hand_over<T: Tsify + serde::Serialize>(value: &T) -> Result<Ts<T>, JsError> {
    value.into_ts().map_err(JsError::from)
}
