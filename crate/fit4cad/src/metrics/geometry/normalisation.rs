//! What lengths are divided by: every group divides by something else, so the figure says by what.

use std::fmt;
use std::str::FromStr;

use crate::cloud::{Bounds, Cloud, Point};
use crate::model::Primitive;

/// What lengths are divided by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Normalisation {
    /// The diagonal of the bounding box of the primitive's points: the Fit4CAD paper's l.
    Primitive,
    /// The diagonal of the cloud's bounding box.
    Cloud,
    /// The largest distance of a point from the mean of all: a shape scaled to the unit sphere
    /// (SPFN, CPFN).
    #[default]
    UnitSphere,
    /// The longest side of the cloud's bounding box: a shape scaled to the unit cube (ParseNet,
    /// NVDNet).
    UnitCube,
    /// Nothing: lengths in the units of the file.
    Nothing,
}

impl Normalisation {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Primitive,
        Self::Cloud,
        Self::UnitSphere,
        Self::UnitCube,
        Self::Nothing,
    ];

    /// Name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Primitive => "primitive",
            Self::Cloud => "cloud",
            Self::UnitSphere => "unit-sphere",
            Self::UnitCube => "unit-cube",
            Self::Nothing => "none",
        }
    }

    /// What a length is given in, for the head of a column.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Primitive => "of the primitive's diagonal",
            Self::Cloud => "of the cloud's diagonal",
            Self::UnitSphere => "of the unit sphere's radius",
            Self::UnitCube => "of the unit cube's side",
            Self::Nothing => "in the file's units",
        }
    }

    /// What it divides by and who does so.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Primitive => {
                "Lengths over the diagonal of the box of the primitive's points, as Fit4CAD has it."
            }
            Self::Cloud => "Lengths over the diagonal of the cloud's box.",
            Self::UnitSphere => {
                "Lengths of a shape scaled to the unit sphere about the mean of its points, as SPFN \
                 and CPFN have it."
            }
            Self::UnitCube => {
                "Lengths of a shape whose longest side is scaled to 1, as ParseNet and NVDNet have \
                 it."
            }
            Self::Nothing => "Lengths in the units of the file.",
        }
    }
}

impl fmt::Display for Normalisation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// There is no normalisation of that name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no normalisation `{0}`; choose primitive, cloud, unit-sphere, unit-cube or none")]
pub struct UnknownNormalisation(pub String);

impl FromStr for Normalisation {
    type Err = UnknownNormalisation;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let mut all = Self::ALL.into_iter();
        all.find(|each| each.name() == name)
            .ok_or_else(|| UnknownNormalisation(name.to_owned()))
    }
}

/// The length that is 1.
pub(in crate::metrics) enum Lengths {
    /// Of every primitive its own.
    Own,
    /// One for all; `None` where the cloud has no extent.
    Whole(Option<f64>),
}

impl Lengths {
    pub(in crate::metrics) fn of(cloud: &Cloud, normalisation: Normalisation) -> Self {
        let bounds = cloud.bounds();
        let whole = match normalisation {
            Normalisation::Primitive => return Self::Own,
            Normalisation::Cloud => bounds.diagonal(),
            Normalisation::UnitSphere => farthest_from_mean(cloud),
            Normalisation::UnitCube => bounds.longest_side(),
            Normalisation::Nothing => 1.0,
        };
        Self::Whole(usable(whole))
    }

    /// What lengths at a primitive are divided by.
    pub(in crate::metrics) fn of_primitive(
        &self,
        cloud: &Cloud,
        primitive: &Primitive,
    ) -> Option<f64> {
        match self {
            Self::Whole(length) => *length,
            Self::Own => {
                let points = primitive.points.iter();
                let known = points.filter_map(|&index| cloud.points().get(index as usize));
                usable(cloud.length_of(&Bounds::of(known)))
            }
        }
    }
}

fn usable(length: f64) -> Option<f64> {
    (length > 0.0 && length.is_finite()).then_some(length)
}

fn farthest_from_mean(cloud: &Cloud) -> f64 {
    let points = cloud.points();
    // About the middle of the box, so that a part far from the origin loses no digits.
    let middle = cloud.bounds().centre();
    let mut sum = crate::cloud::Vector::zeros();
    for point in points {
        sum += point - middle;
    }
    let mean: Point = middle + sum / points.len().max(1) as f64;
    let squares = points.iter().map(|point| (point - mean).norm_squared());
    squares.fold(0.0, f64::max).sqrt()
}
