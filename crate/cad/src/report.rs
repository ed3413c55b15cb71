//! What became of a file and its faces, as plain objects.

use serde::Serialize;
use tsify::Tsify;

/// What became of a file.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct ImportReport {
    /// The system that wrote the file, as its header says; empty where it does not.
    pub system: String,
    /// The schema its header names.
    pub schema: String,
    /// How many bodies there are.
    pub bodies: usize,
    /// How many instances of them.
    pub instances: usize,
    /// Every body of the file, in its order: what there is to choose from.
    pub choice: Vec<BodyReport>,
    /// Diagonal of the part, in millimetres.
    pub diagonal: f64,
    /// Area of all faces used, in square millimetres.
    pub area: f64,
    /// About how far neighbouring points lie apart, in millimetres.
    pub spacing: f64,
    /// Every face of every instance.
    pub faces: Vec<FaceReport>,
    /// How many of them are not in the cloud.
    pub lost: usize,
    /// What has a shape but is no face that could be used, and why.
    pub left_out: Vec<String>,
    /// What else is to be known.
    pub warnings: Vec<String>,
    /// All that is not in the cloud or is in doubt, a clause each.
    pub doubts: Vec<String>,
}

/// A body that can be kept or not.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct BodyReport {
    /// Its name.
    pub name: String,
    /// How many faces it has.
    pub faces: usize,
    /// Whether it is in the cloud.
    pub kept: bool,
}

/// What became of one face of one instance.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct FaceReport {
    /// Number of the face in the file (`#123`).
    pub face: f64,
    /// Name of its body.
    pub body: String,
    /// Which instance it is of, from 1.
    pub instance: usize,
    /// The type of its surface in the file.
    pub surface: String,
    /// The family that its points are primitives of; `null` of free-form faces.
    #[serde(rename = "type")]
    pub kind: Option<&'static str>,
    /// Whether the file calls it something else than its family.
    pub recognised: bool,
    /// Area in square millimetres.
    pub area: f64,
    /// How many points lie on it.
    pub points: usize,
    /// Number of the primitive that its points belong to; `null` where they belong to none.
    pub primitive: Option<u32>,
    /// Why there is nothing of it, or what about it is doubtful; empty where all is well.
    pub remark: String,
}

impl From<&fit4cad_step::Report> for ImportReport {
    fn from(report: &fit4cad_step::Report) -> Self {
        let faces = report.faces.iter().map(|face| FaceReport {
            face: face.face as f64,
            body: face.body.clone(),
            instance: face.instance,
            surface: face.surface.clone(),
            kind: face.kind.map(|kind| kind.name()),
            recognised: face.recognised,
            area: face.area,
            points: face.points,
            primitive: face.primitive,
            remark: face.remark.clone(),
        });
        let choice = report.choice.iter().map(|body| BodyReport {
            name: body.name.clone(),
            faces: body.faces,
            kept: body.kept,
        });
        Self {
            system: report.system.clone(),
            schema: report.schema.clone(),
            bodies: report.bodies,
            instances: report.instances,
            choice: choice.collect(),
            diagonal: report.diagonal,
            area: report.area,
            spacing: report.spacing,
            faces: faces.collect(),
            lost: report.lost(),
            left_out: report.left_out.clone(),
            warnings: report.warnings.clone(),
            doubts: report.doubts(),
        }
    }
}
