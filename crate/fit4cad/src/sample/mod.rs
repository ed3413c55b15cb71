//! CAD-like parts with known truth, made by a deterministic generator.
//!
//! [`generate`] makes one of the [`parts`] of the catalogue, [`build`] any [`blocks::Part`], which
//! [`compose`] makes of [`Block`]s; [`degraded`] and [`without`] make a model worse. The points are
//! spread as a surface mesher spreads vertices, which is what the benchmark's clouds look like:
//! corners, then edges, then faces, all at about one distance; a point on an edge is listed by every
//! primitive that meets there. A primitive is one connected patch of one surface. Free-form faces
//! are sampled but belong to no primitive.
//!
//! One part, options and seed give one model. Sines, arc tangents and logarithms come from `libm`,
//! not from the platform, so that it is the same model natively and under WebAssembly.

pub mod blocks;
mod boundary;
mod catalogue;
mod compose;
mod cut;
mod degrade;
mod grid;
mod imperfect;
mod mesh;
mod options;
mod patches;
mod ranges;
mod shapes;
pub mod single;

use blocks::Part;
use boundary::Boundary;
pub use catalogue::{PartInfo, parts};
pub use compose::{Block, MAX_BLOCKS, compose};
pub use cut::{FEWEST_POINTS, Lasso, Losses, MAX_CORNERS, Region, points_in, thin, without};
pub use degrade::Degradation;
use degrade::Worn;
pub use imperfect::imperfect;
use mesh::Mesh;
pub use options::Options;
use patches::Patch;
pub use ranges::{OPTIONS, OptionInfo, SEED, WEAR};
pub use shapes::{SHAPES, Shape, ShapeInfo};

use crate::cloud::{Cloud, Point};
use crate::model::{Model, Primitive, Segmentation};
use crate::surface::Surface;

/// Most points a model may have before outliers are added.
pub const MAX_POINTS: usize = 2_000_000;

/// Why no model was made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SampleError {
    /// The catalogue has no part of that name.
    #[error("there is no part “{name}”; choose one of {}", known.join(", "))]
    UnknownPart {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: Vec<&'static str>,
    },
    /// An option is not a number in its range.
    #[error("{option} must be between {min} and {max}, not {value}")]
    OutOfRange {
        /// Name of the option.
        option: &'static str,
        /// Its value.
        value: f64,
        /// Least value allowed.
        min: f64,
        /// Greatest value allowed.
        max: f64,
    },
    /// The spacing is too fine for the part.
    #[error("the part would have more than {limit} points; choose a wider spacing")]
    TooManyPoints {
        /// The most there may be.
        limit: usize,
    },
    /// Blocks reach far beyond what is left of the part.
    #[error(
        "blocks are far too large for this spacing; make those that cut little larger than what \
         they cut, or choose a wider spacing"
    )]
    TooLarge,
    /// A part does not describe an object.
    #[error("feature {feature} of the part cannot be built: {reason}")]
    InvalidPart {
        /// Its place among the features, from 1.
        feature: usize,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A block makes no solid.
    #[error("block {block} ({shape}): {reason}")]
    InvalidBlock {
        /// Its place among the blocks, from 1.
        block: usize,
        /// Title of its shape.
        shape: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// More blocks than a part may have.
    #[error("a part may have up to {limit} blocks")]
    TooManyBlocks {
        /// The most there may be.
        limit: usize,
    },
    /// A region to cut away is none.
    #[error("the region to cut away is not one: {reason}")]
    InvalidRegion {
        /// What is wrong with it.
        reason: &'static str,
    },
}

/// Makes a part of the catalogue. O(n) for n points, but for missing data, O(n log n); a few
/// seconds per million points.
///
/// # Errors
/// [`SampleError`] if there is no such part, an option is out of its range, or there would be more
/// than [`MAX_POINTS`].
///
/// ```
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.02, noise: 0.001, ..Options::default() };
/// let model = generate("bracket", &options)?;
/// assert!(model.truth.is_some_and(|truth| truth.primitives.len() > 5));
/// assert!(generate("braket", &options).is_err());
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn generate(part: &str, options: &Options) -> Result<Model, SampleError> {
    build(part, &catalogue::part(part)?, options)
}

/// Makes a model of any part. Costs what [`generate`] does.
///
/// # Errors
/// [`SampleError`] if the part describes no object, an option is out of its range, or there would
/// be more than [`MAX_POINTS`].
pub fn build(name: &str, part: &Part, options: &Options) -> Result<Model, SampleError> {
    options.check()?;
    let (boundary, mesh, patches) = meshed(part, options)?;
    let degradation = options.degradation();
    let worn = degrade::degrade(&mesh.points, boundary.diagonal, &degradation, options.seed);
    let lists = patches.iter().map(|patch| worn.list(&patch.points));
    let truth = numbered(patches.iter().map(|patch| patch.surface).zip(lists));
    Ok(of_points(name, worn.points, truth))
}

/// The part that the page opens with: what [`generate`] makes of the first of the catalogue by the options'
/// defaults. Needs none of what makes the other parts, or wears them.
///
/// # Errors
/// None in practice: this part can be made.
pub fn opening() -> Result<Model, SampleError> {
    let first = catalogue::FIRST;
    let (_, mesh, patches) = meshed(&first.part(), &Options::default())?;
    let patches = patches.into_iter();
    let truth = numbered(patches.map(|patch| (patch.surface, patch.points)));
    Ok(of_points(first.name, mesh.points, truth))
}

/// A part as its faces, with points on them.
fn meshed(part: &Part, options: &Options) -> Result<(Boundary, Mesh, Vec<Patch>), SampleError> {
    let boundary = Boundary::new(part)?;
    let spacing = options.spacing * boundary.diagonal;
    let mesh = mesh::mesh(&boundary, spacing, options.seed, MAX_POINTS)?;
    let patches = patches::patches(&boundary, &mesh, spacing);
    Ok((boundary, mesh, patches))
}

/// The primitives that have points, numbered from 1.
fn numbered(patches: impl Iterator<Item = (Surface, Vec<u32>)>) -> Segmentation {
    let mut primitives: Vec<Primitive> = Vec::new();
    for (surface, points) in patches {
        if !points.is_empty() {
            let number = primitives.len() as u32 + 1;
            primitives.push(Primitive::on(surface, number, points));
        }
    }
    Segmentation { primitives }
}

fn of_points(name: &str, points: Vec<Point>, truth: Segmentation) -> Model {
    Model {
        name: name.to_owned(),
        cloud: Cloud::new(points),
        truth: Some(truth),
        submissions: Vec::new(),
    }
}

/// The model as a worse scan would show it, without its submissions. The truth keeps its surfaces
/// and loses the points that are cut away; primitives of which none is left are left out.
/// O(n log n).
///
/// # Errors
/// [`SampleError::OutOfRange`] names the first number of `degradation` that is out of its range.
///
/// ```
/// use fit4cad::sample::{Degradation, Options, degraded, generate};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let model = generate("flange", &options)?;
/// let scan = Degradation { missing: 0.2, ..Degradation::default() };
/// assert!(degraded(&model, &scan, 1)?.cloud.len() < model.cloud.len());
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn degraded(model: &Model, degradation: &Degradation, seed: u64) -> Result<Model, SampleError> {
    degradation.check()?;
    let diagonal = model.cloud.bounds().diagonal();
    let worn = degrade::degrade(model.cloud.points(), diagonal, degradation, seed);
    Ok(Model {
        name: model.name.clone(),
        truth: model.truth.as_ref().map(|truth| truth_on(&worn, truth)),
        cloud: Cloud::new(worn.points),
        submissions: Vec::new(),
    })
}

/// The primitives of which points are left, with their new lists and their old numbers.
fn truth_on(worn: &Worn, truth: &Segmentation) -> Segmentation {
    let left = truth.primitives.iter().map(|primitive| Primitive {
        points: worn.list(&primitive.points),
        ..primitive.clone()
    });
    Segmentation {
        primitives: left
            .filter(|primitive| !primitive.points.is_empty())
            .collect(),
    }
}

/// The largest distance of a point from the surface of a primitive that lists it, as a share of the
/// cloud's diagonal; `None` where no point is listed.
#[cfg(test)]
fn farthest_off(model: &Model) -> Option<f64> {
    let primitives = model.truth.iter().flat_map(|truth| &truth.primitives);
    let distances = primitives.flat_map(|primitive| {
        let points = primitive.points.iter();
        let points = points.map(|&index| &model.cloud.points()[index as usize]);
        points.map(|point| primitive.surface.map_or(f64::NAN, |it| it.distance(point)))
    });
    // Unlike `f64::max`, this keeps NaN, which is at most nothing.
    let farthest = distances.max_by(f64::total_cmp)?;
    Some(farthest / model.cloud.bounds().diagonal())
}
