//! What an audit says.

use std::fmt;

use crate::diagnostics::{Severity, Subject};

/// What was checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Check {
    /// Files: absent, empty, cut off, unreadable or one too many.
    File,
    /// The way entries are written, where what is meant is clear.
    Syntax,
    /// Points of the cloud that could not be read.
    Point,
    /// Numbers by which points, surfaces and primitives belong together.
    Numbering,
    /// Indices of a point list: in range, and at least one.
    Index,
    /// Indices that a point list holds twice.
    Duplicate,
    /// Types: one of the five families, the same in both files.
    Type,
    /// Vectors: present, as long as their type asks for, made of numbers.
    Vector,
    /// Vectors that are surfaces of their type: radii equal, frame square, quartic a torus.
    Family,
    /// Distance of the points to the parametric form.
    ParametricDistance,
    /// Distance of the points to the implicit form.
    ImplicitDistance,
    /// Distance of the points to the surface, where both forms agree on it.
    SurfaceDistance,
    /// Single points off a surface on which all others lie.
    StrayPoint,
    /// Distance between the two forms, where neither is off the points.
    Agreement,
    /// First-order distance |f| / |∇f| of the points to the implicit form, where the Euclidean one
    /// is small.
    FirstOrderDistance,
}

impl Check {
    /// All of them, in the order of the findings about one primitive.
    pub const ALL: [Self; 15] = [
        Self::File,
        Self::Syntax,
        Self::Point,
        Self::Numbering,
        Self::Index,
        Self::Duplicate,
        Self::Type,
        Self::Vector,
        Self::Family,
        Self::ParametricDistance,
        Self::ImplicitDistance,
        Self::SurfaceDistance,
        Self::StrayPoint,
        Self::Agreement,
        Self::FirstOrderDistance,
    ];

    /// A name for tables and files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Syntax => "syntax",
            Self::Point => "point",
            Self::Numbering => "numbering",
            Self::Index => "index",
            Self::Duplicate => "duplicate",
            Self::Type => "type",
            Self::Vector => "vector",
            Self::Family => "family",
            Self::ParametricDistance => "parametric distance",
            Self::ImplicitDistance => "implicit distance",
            Self::SurfaceDistance => "surface distance",
            Self::StrayPoint => "stray point",
            Self::Agreement => "agreement",
            Self::FirstOrderDistance => "first-order distance",
        }
    }
}

impl From<Subject> for Check {
    fn from(subject: Subject) -> Self {
        match subject {
            Subject::File => Self::File,
            Subject::Syntax => Self::Syntax,
            Subject::Point => Self::Point,
            Subject::Index => Self::Index,
            Subject::Duplicate => Self::Duplicate,
            Subject::Vector => Self::Vector,
            Subject::Type => Self::Type,
            Subject::Numbering => Self::Numbering,
            Subject::Family => Self::Family,
        }
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One thing that is wrong with a ground truth.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Number of the primitive; `None` where it is about a file or the cloud.
    pub primitive: Option<u32>,
    /// Which check found it.
    pub check: Check,
    /// How much it matters.
    pub severity: Severity,
    /// What was measured, where something was: a share of the primitive's diagonal, or for
    /// [`Check::Family`] of the surface's size.
    pub value: Option<f64>,
    /// What it may be at most.
    pub limit: Option<f64>,
    /// One sentence: what is wrong.
    pub message: String,
    /// Why, or what to do; may be empty.
    pub hint: String,
}
