//! The engine as JavaScript sees it: a thin wasm-bindgen boundary over [`fit4cad`].
//!
//! Points cross as typed arrays, everything else as small plain objects whose TypeScript types are
//! generated from the Rust ones. Nothing is computed here: each function reads its arguments, calls
//! the engine and hands the result over. Failures are JavaScript errors with a clear text.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(all(test, target_arch = "wasm32"))]
#[macro_use]
extern crate fit4cad_testing;

#[cfg(feature = "workshop")]
mod audit;
mod comparison;
#[cfg(feature = "workshop")]
mod declared;
mod diagnostic;
#[cfg(feature = "workshop")]
mod errors;
#[cfg(feature = "workshop")]
mod export;
#[cfg(feature = "workshop")]
mod field;
#[cfg(feature = "workshop")]
mod fit;
mod fitted;
mod group;
mod imperfect;
mod input;
mod keys;
#[cfg(feature = "workshop")]
mod lesson;
mod lists;
#[cfg(feature = "workshop")]
mod look;
mod model;
mod normals;
mod outcome;
#[cfg(feature = "workshop")]
mod part;
mod paths;
mod primitive;
#[cfg(feature = "workshop")]
mod recognition;
mod report;
#[cfg(feature = "workshop")]
mod section;
#[cfg(feature = "workshop")]
mod single;
#[cfg(feature = "workshop")]
mod statistics;
mod stop;
#[cfg(feature = "workshop")]
mod strata;
#[cfg(feature = "workshop")]
mod studio;
mod summary;

#[cfg(feature = "workshop")]
pub use audit::{Audit, Corrected, Correction, Finding, FormAudit, PrimitiveAudit};
#[cfg(feature = "workshop")]
pub use comparison::compare_figures;
pub use comparison::{Comparison, Difference, Outcome, Paired, SignedRank, compare};
#[cfg(feature = "workshop")]
pub use declared::{
    Better, Declarations, FigureGroup, FigureInfo, FileKindInfo, FitterInfo, Group, MeasureInfo,
    NormalisationInfo, ParameterInfo, PartInfo, ProtocolDifference, ProtocolInfo, RoleInfo,
    ShapeInfo, StageInfo, SurfaceTypeInfo, Term, declarations,
};
pub use diagnostic::{DiagnosticInfo, Severity, one_lines};
#[cfg(feature = "workshop")]
pub use errors::{NoiseInfo, StandardErrorsInfo};
#[cfg(feature = "workshop")]
pub use export::ExportInfo;
#[cfg(feature = "workshop")]
pub use field::{FieldReport, FieldRow, FigureScale, FigureSpread, Figures, distribution};
#[cfg(feature = "workshop")]
pub use fit::{FitMethod, FitParameters};
pub use group::{
    Grouping, ModelFiles, Override, Overrides, PlacedFile, Recognised, Unplaced, group,
};
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
#[cfg(feature = "workshop")]
pub use look::PatchMesh;
pub use model::{BoundsInfo, Model, ModelInfo, Texts};
pub use outcome::{Counted, Histogram};
#[cfg(feature = "workshop")]
pub use part::SampleOptions;
pub use paths::{Layout, file_name, path_of};
pub use primitive::{PrimitiveInfo, SurfaceInfo, SurfaceType};
#[cfg(feature = "workshop")]
pub use recognition::{Answered, Rates, RecognitionInfo, Segment, rates};
pub use report::{
    FitMeasures, Hidden, Measures, PredictionReport, Protocol, Report, TruthReport, TypeConfusion,
};
#[cfg(feature = "workshop")]
pub use section::{CurveInfo, SectionInfo};
#[cfg(feature = "workshop")]
pub use single::{SingleInfo, Singles, VerdictInfo};
#[cfg(feature = "workshop")]
pub use statistics::{
    DatasetStatistics, ModelStatistics, Spread, TypeShares, Types, dataset_statistics,
};
#[cfg(feature = "workshop")]
pub use strata::{By, Condition, StrataInfo, declared_condition};
#[cfg(feature = "workshop")]
pub use studio::{Block, Losses, Operation, Thin};
pub use summary::{Distribution, MethodSummary, Scores, summarise};

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
