//! A model of the benchmark: a cloud, its true segmentation and the segmentations submitted for it.
//!
//! Files, fitters and the sample generator all make these types, and everything downstream reads
//! them, so a submission looks the same wherever it came from.

use crate::cloud::Cloud;
use crate::surface::{Surface, SurfaceType};

/// One point cloud with everything known about it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    /// Name as in its files, e.g. `PC14`.
    pub name: String,
    /// The points.
    pub cloud: Cloud,
    /// The ground truth, if it is there.
    pub truth: Option<Segmentation>,
    /// Results to be scored, ordered by method.
    pub submissions: Vec<Submission>,
}

/// The result of one method on one model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Submission {
    /// Name of the method, e.g. `HT`.
    pub method: String,
    /// What it found.
    pub segmentation: Segmentation,
}

/// A cloud's points grouped into primitives. Groups may share points (usually along a common
/// edge), and points in no group are unsegmented.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Segmentation {
    /// The primitives, in the order of the file.
    pub primitives: Vec<Primitive>,
}

/// One primitive: a group of points and the surface they lie on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Primitive {
    /// The number the file gives it (`Primitive7`); not always its position.
    pub number: u32,
    /// Indices into the cloud, counted from 0, ascending, each once.
    pub points: Vec<u32>,
    /// The type named by the file, where it is one of the five; `None` for others (`BSpline`) and
    /// where no surface file names it.
    pub kind: Option<SurfaceType>,
    /// The surface for distances (MFE, directed Hausdorff): from the parametric file, or from the
    /// implicit file where there is no parametric file at all.
    pub surface: Option<Surface>,
    /// The parametric vector (paper, appendix "Parametric representations").
    pub parametric: Coefficients,
    /// The implicit vector (paper, appendix "Implicit representations"); exactly converted from
    /// the parametric one where there is no implicit file at all.
    pub implicit: Coefficients,
}

impl Primitive {
    /// Points on a surface that is known exactly: both vectors are converted from it.
    pub fn on(surface: Surface, number: u32, points: Vec<u32>) -> Self {
        Self {
            number,
            points,
            kind: Some(surface.kind()),
            surface: Some(surface),
            parametric: Coefficients::Given(surface.to_parametric()),
            implicit: Coefficients::Given(surface.to_implicit()),
        }
    }
}

/// The numbers of one entry of a surface file.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Coefficients {
    /// The file holds no entry for this primitive.
    #[default]
    Missing,
    /// There is an entry, but it cannot be used (wrong length, not a number).
    Malformed,
    /// As many numbers as the type asks for.
    Given(Vec<f64>),
}

impl Coefficients {
    /// The numbers, if there are any.
    pub fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Given(values) => Some(values),
            Self::Missing | Self::Malformed => None,
        }
    }
}
