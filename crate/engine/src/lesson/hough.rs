//! The Hough transform of a small part, step by step.

use fit4cad::cloud::{Cloud, Point};
use fit4cad::fit::Candidate;
use fit4cad::fit::hough::gamma::Coordinate;
use fit4cad::fit::hough::grid::Axis;
use fit4cad::lesson::hough::{Transform, polish, rivals, typical};
use fit4cad::surface::{self, Surface, patch::Patch};
use js_sys::{Float32Array, Uint32Array};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::look::PatchMesh;
use crate::model::Model;
use crate::primitive::{SurfaceInfo, SurfaceType};

/// One free parameter of a slice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct AxisInfo {
    /// What it is.
    pub name: &'static str,
    /// Smallest value.
    pub start: f64,
    /// Length of a cell.
    pub step: f64,
    /// Number of cells.
    pub count: u32,
}

impl AxisInfo {
    fn new(kind: surface::SurfaceType, coordinate: Coordinate, axis: &Axis) -> Self {
        use surface::SurfaceType::{Cone, Plane, Sphere};
        let name = match (kind, coordinate) {
            (Plane, Coordinate::Turn) => "turn of the normal, in radians",
            (Plane, Coordinate::Along) => "offset along the normal",
            (Sphere, Coordinate::Across) => "centre, along x",
            (Sphere, Coordinate::Beside) => "centre, along y",
            (Cone, Coordinate::Along) => "apex, along the axis",
            (Cone, Coordinate::Size) => "half-angle, in radians",
            (_, Coordinate::Across) => "centre, across the axis",
            (_, Coordinate::Beside) => "centre, across both",
            (_, Coordinate::Along) => "along the axis",
            (_, Coordinate::Turn) => "turn, in radians",
            (_, Coordinate::Size) => "major radius",
            (_, Coordinate::MinorRadius) => "minor radius",
        };
        Self {
            name,
            start: axis.start(),
            step: axis.step(),
            count: axis.count() as u32,
        }
    }
}

/// A slice of a family's parameter space.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct SliceInfo {
    /// The surface at whose values all but two parameters are held.
    pub base: SurfaceInfo,
    /// The free parameter that changes from row to row of cells.
    pub rows: AxisInfo,
    /// The free parameter that changes along a row.
    pub columns: AxisInfo,
}

/// One cell: a surface, and who voted for it.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct CellInfo {
    /// The surface in the middle of the cell.
    pub surface: SurfaceInfo,
    /// The points whose curve meets the cell, ascending.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub voters: Uint32Array,
    /// The part of the surface that the voters cover; absent without voters.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub patch: Option<PatchMesh>,
}

/// A local maximum of the accumulator.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct MaximumInfo {
    /// Its highest cell.
    pub cell: u32,
    /// Level at which it appears, in votes.
    pub birth: f64,
    /// Level at which it meets a higher one, in votes.
    pub death: f64,
    /// Whether its persistence reaches the share of the highest cell asked for.
    pub kept: bool,
}

/// A peak polished.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct PolishInfo {
    /// The fitted surface.
    pub surface: SurfaceInfo,
    /// The points it was grown over, ascending.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array")]
    pub support: Uint32Array,
    /// Root mean square distance of those points, in the units of the cloud.
    pub error: f64,
    /// The part of the surface that they cover.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub patch: Option<PatchMesh>,
    /// The best surface of each family through the same points.
    pub rivals: Vec<RivalInfo>,
}

/// A family's best surface through the points of a peak.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct RivalInfo {
    /// The family.
    #[serde(rename = "type")]
    pub kind: SurfaceType,
    /// Mean fitting error.
    pub mfe: f64,
    /// Whether that is the least of all.
    pub least: bool,
    /// Whether the fitter keeps it.
    pub kept: bool,
}

/// The transform of one model's points for one family. Release it with `free()`.
#[derive(Debug)]
#[wasm_bindgen]
pub struct HoughLesson {
    cloud: Cloud,
    transform: Transform,
}

#[wasm_bindgen]
impl HoughLesson {
    /// Lets every point of a model vote for a family. The parameters that the slice holds are those
    /// of the true primitive whose direction and size most others share.
    ///
    /// # Errors
    /// If the model's truth has no primitive of the family.
    #[wasm_bindgen(constructor)]
    pub fn new(model: &Model, family: Ts<SurfaceType>) -> Result<HoughLesson, JsError> {
        let kind = surface::SurfaceType::from(family.to_rust()?);
        let primitives = &model.segmentation(None)?.primitives;
        let surfaces: Vec<Surface> = primitives.iter().filter_map(|each| each.surface).collect();
        let base = typical(&surfaces, kind);
        let base = base.ok_or_else(|| JsError::new(&format!("the part has no {kind}")))?;
        let cloud = model.model.cloud.clone();
        Ok(Self {
            transform: Transform::new(&cloud, base),
            cloud,
        })
    }

    /// The slice of parameter space.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn slice(&self) -> Result<Ts<SliceInfo>, JsError> {
        let base = self.transform.base();
        let ([first, second], [rows, columns]) = (self.transform.free(), self.transform.axes());
        hand_over(&SliceInfo {
            base: SurfaceInfo::from(base),
            rows: AxisInfo::new(base.kind(), first, rows),
            columns: AxisInfo::new(base.kind(), second, columns),
        })
    }

    /// The cells that a point lights, ascending.
    pub fn gamma(&self, point: u32) -> Uint32Array {
        self.transform.gamma(point).into()
    }

    /// Votes by cell, row after row, when these points have voted.
    pub fn heights(&self, points: &[u32]) -> Float32Array {
        let heights = self.transform.heights(points.iter().copied());
        let heights: Vec<f32> = heights.into_iter().map(|height| height as f32).collect();
        heights.as_slice().into()
    }

    /// A cell's surface and voters; nothing beyond the last cell.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn cell(&self, cell: u32) -> Result<Option<Ts<CellInfo>>, JsError> {
        let Some(surface) = self.transform.surface(cell) else {
            return Ok(None);
        };
        let voters = self.transform.voters(cell);
        let info = CellInfo {
            surface: SurfaceInfo::from(&surface),
            patch: self.patch(&surface, &voters),
            voters: voters.as_slice().into(),
        };
        hand_over(&info).map(Some)
    }

    /// The maxima when every point has voted, most persistent first; kept where their persistence
    /// is at least `share` of the highest cell.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn maxima(&self, share: f64) -> Result<Vec<Ts<MaximumInfo>>, JsError> {
        let diagram = self.transform.diagram();
        let kept = diagram.significant(share).count();
        let peaks = diagram.peaks.iter().enumerate();
        peaks
            .map(|(place, peak)| {
                hand_over(&MaximumInfo {
                    cell: peak.position as u32,
                    birth: peak.birth,
                    death: peak.death,
                    kept: place < kept,
                })
            })
            .collect()
    }

    /// Fits a cell's surface to its voters, grows it, and sets the other families against it;
    /// nothing where too few points hold on to it.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn polish(&self, cell: u32) -> Result<Option<Ts<PolishInfo>>, JsError> {
        let Some(start) = self.transform.surface(cell) else {
            return Ok(None);
        };
        let polished = polish(&self.cloud, &start, &self.transform.voters(cell));
        let Some(polished) = polished else {
            return Ok(None);
        };
        hand_over(&self.polished(&polished)).map(Some)
    }
}

impl HoughLesson {
    fn polished(&self, candidate: &Candidate) -> PolishInfo {
        let rivals = rivals(&self.cloud, candidate).into_iter();
        PolishInfo {
            surface: SurfaceInfo::from(&candidate.surface),
            support: candidate.support.as_slice().into(),
            error: candidate.error,
            patch: self.patch(&candidate.surface, &candidate.support),
            rivals: rivals
                .map(|rival| RivalInfo {
                    kind: rival.surface.kind().into(),
                    mfe: rival.accuracy.mfe,
                    least: rival.least,
                    kept: rival.kept,
                })
                .collect(),
        }
    }

    fn patch(&self, surface: &Surface, points: &[u32]) -> Option<PatchMesh> {
        let all = self.cloud.points();
        let points = points.iter().filter_map(|&index| all.get(index as usize));
        let points: Vec<Point> = points.copied().collect();
        let patch = Patch::new(surface, &points)?;
        Some(PatchMesh::new(&patch, &self.cloud.bounds().centre()))
    }
}
