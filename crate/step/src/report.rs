//! What became of each face.

use fit4cad::surface::SurfaceType;

/// What became of a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// The system that wrote the file, as its header says; empty where it does not.
    pub system: String,
    /// The schema its header names.
    pub schema: String,
    /// How many bodies there are, and how many instances of them.
    pub bodies: usize,
    /// Instances of bodies.
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
    /// What has a shape but is no face that could be used, and why.
    pub left_out: Vec<String>,
    /// What else is to be known.
    pub warnings: Vec<String>,
}

/// A body that can be kept or not.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct BodyReport {
    /// Its name.
    pub name: String,
    /// How many faces it has.
    pub faces: usize,
    /// Whether it is in the cloud.
    pub kept: bool,
}

impl Report {
    /// How many faces are not in the cloud.
    pub fn lost(&self) -> usize {
        self.faces.iter().filter(|face| face.is_left_out()).count()
    }

    /// Whatever is not in the cloud or is in doubt, a clause each.
    pub fn doubts(&self) -> Vec<String> {
        let first = self.faces.iter().find(|face| face.is_left_out());
        let faces = first.map(|first| {
            format!(
                "{} of {} faces are not in the cloud. The first is #{}, {}",
                self.lost(),
                self.faces.len(),
                first.face,
                first.remark
            )
        });
        let others = self.left_out.iter();
        let others = others.map(|text| format!("not in the cloud: {text}"));
        let warnings = self.warnings.iter().cloned();
        faces.into_iter().chain(others).chain(warnings).collect()
    }
}

/// How the remark on a face begins that is not in the cloud.
pub(crate) const LEFT_OUT: &str = "left out: ";

impl FaceReport {
    fn is_left_out(&self) -> bool {
        self.remark.starts_with(LEFT_OUT)
    }
}

/// What became of one face of one instance.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FaceReport {
    /// Number of the face in the file (`#123`).
    pub face: u64,
    /// Name of its body.
    pub body: String,
    /// Which instance it is of, from 1.
    pub instance: usize,
    /// The type of its surface in the file.
    pub surface: String,
    /// The family that its points are primitives of; `None` of free-form faces.
    pub kind: Option<SurfaceType>,
    /// Whether the file calls it something else than its family.
    pub recognised: bool,
    /// Area in square millimetres.
    pub area: f64,
    /// How many points lie on it.
    pub points: usize,
    /// Number of the primitive that its points belong to; `None` where they belong to none.
    pub primitive: Option<u32>,
    /// Why there is nothing of it, or what about it is doubtful; empty where all is well.
    pub remark: String,
}
