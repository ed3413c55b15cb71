//! PG: the primitive-growing fitter (paper, section "PG: a discrete curvature-based method for point
//! cloud segmentation", after Qie and others 2021).
//!
//! Where the Hough transform starts from parameter space, this starts from neighbourhoods: points
//! on sharp edges are told by their surface variation ([`variation`]), what lies between them grows
//! into regions ([`regions`]), the rigid motions that slide a region over itself give its invariance
//! class ([`slippage`]), and regions of more than one surface are split by RANSAC ([`ransac`]). What
//! is left over is mostly thin faces, which only what lies beside them tells ([`leftovers`]).
//!
//! | step of the paper | function | in the trace |
//! |---|---|---|
//! | 1 surface variation, sharp points | [`variation::surface_variation`], [`variation::threshold`] | `SurfaceVariation` |
//! | 2 region growing | [`regions::grow`] | `Regions` |
//! | 3 slippage analysis | [`slippage::Slippage::of`] | `Slippage` |
//! | 4 least squares, RANSAC | [`slippage::Slippage::starts`], [`ransac::split`] | `Accepted` |
//! | 5 sharp points, oversegmented neighbours | [`label`](super::stages::label()), [`prune`](super::stages::prune()) | the result |
//!
//! The fifth is shared with every other fitter, and follows on pruning: what is merged is labelled once.

pub mod leftovers;
pub mod ransac;
pub mod regions;
pub mod slippage;
pub mod variation;

use super::least_squares::{self, Loss};
use super::local::{self, Curvature};
use super::progress::{Cancelled, Observer, Stage};
use super::search::Search;
use super::trace::Event;
use super::{Candidate, Parameters, detect};
use crate::cloud::{Point, Vector};
use slippage::{Invariance, Slippage};

/// Points of a region that its slippage is taken over; more would not make it clearer.
const SLIPPAGE_SAMPLE: usize = 300;
/// Share of a region that one surface must explain for the region to be of a simple class.
const SIMPLE: f64 = 0.5;

/// Finds surfaces by growing primitives, step by step as in the paper.
///
/// # Errors
/// If the observer stops the fit.
pub fn find(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    let order = detect::shuffled(search);
    let regions = smooth_regions(search, &order, observer);
    for (place, region) in regions.iter().enumerate() {
        let done = 0.6 * place as f64 / regions.len() as f64;
        observer.progress(Stage::Find, done)?;
        refine(search, place, region, done, observer)?;
    }
    drop(regions);
    // Sharp points on a primitive are its own by now, as growth follows a surface up to its edges.
    // Faces so narrow that all of their points are sharp are left: regions too, of no simple class.
    let left = regions::grow(&search.graph, &order, |i| search.is_explained(i));
    drop(order);
    for (place, region) in left.iter().enumerate() {
        let done = 0.6 + 0.3 * place as f64 / left.len() as f64;
        observer.progress(Stage::Find, done)?;
        ransac::split(search, region, done, observer)?;
    }
    drop(left);
    if search.scale.is_clean() {
        leftovers::about_known_axes(search, observer)?;
    }
    if search.scale.shows_rows() {
        leftovers::thin_faces(search, observer)?;
    }
    Ok(())
}

/// The regions between sharp points, grown from seeds in the given order.
fn smooth_regions(
    search: &Search<'_>,
    order: &[u32],
    observer: &mut dyn Observer,
) -> Vec<Vec<u32>> {
    let parameters = search.parameters;
    let neighbours = Parameters::count(parameters.variation_neighbours);
    let values = variation::surface_variation(search.cloud.points(), &search.graph, neighbours);
    let threshold = variation::threshold(&values, parameters.sharp_quantile);
    if observer.wants_trace() {
        observer.trace(Event::SurfaceVariation {
            values: values.iter().map(|&value| value as f32).collect(),
            quantile: threshold.quantile,
            threshold: threshold.value,
        });
    }
    let regions = regions::grow(&search.graph, order, |i| {
        values[i as usize] > threshold.value
    });
    if observer.wants_trace() {
        observer.trace(Event::Regions(regions::labels(
            search.cloud.len(),
            &regions,
        )));
    }
    regions
}

/// Region refinement: a region of a simple class gets its surface by least squares, started from
/// the slippable motion; what that does not explain is split.
fn refine(
    search: &mut Search<'_>,
    place: usize,
    region: &[u32],
    done: f64,
    observer: &mut dyn Observer,
) -> Result<(), Cancelled> {
    let open: Vec<u32> = region
        .iter()
        .copied()
        .filter(|&i| !search.is_explained(i))
        .collect();
    if open.len() < Parameters::count(search.parameters.smallest) {
        return Ok(());
    }
    let (points, normals) = oriented(search, &open);
    let slippage = Slippage::of(&points, &normals);
    if let Some(slippage) = &slippage {
        if observer.wants_trace() {
            observer.trace(Event::Slippage {
                region: u32::try_from(place).unwrap_or(u32::MAX),
                eigenvalues: slippage.eigenvalues,
                class: slippage.class.name(),
                centre: slippage.centre,
            });
        }
        if let Some(candidate) = simple_surface(search, &open, &points, slippage) {
            detect::keep(search, candidate, observer);
        }
    }
    ransac::split(search, &open, done, observer)
}

/// An even sample of a region with normals from the curvature of each neighbourhood.
fn oriented(search: &Search<'_>, region: &[u32]) -> (Vec<Point>, Vec<Vector>) {
    let stride = region.len().div_ceil(SLIPPAGE_SAMPLE).max(1);
    region
        .iter()
        .step_by(stride)
        .filter_map(|&index| Some((*search.point(index), normal(search, index)?)))
        .unzip()
}

/// Unit normal at a point, from the quadratic height function over its neighbourhood: at the point
/// itself, which the plane of the neighbourhood misses on a bent surface.
pub(super) fn normal(search: &Search<'_>, index: u32) -> Option<Vector> {
    let mut patch = vec![*search.point(index)];
    let neighbours = search.graph.of(index).iter().take(10);
    patch.extend(neighbours.map(|&neighbour| *search.point(neighbour)));
    let shape = Curvature::of(&patch)?;
    let offset = patch[0] - shape.point;
    let mut normal = shape.normal.into_inner();
    for (curvature, direction) in shape.values.iter().zip(&shape.directions) {
        normal -= direction.into_inner() * (curvature * offset.dot(direction));
    }
    normal.try_normalize(f64::MIN_POSITIVE)
}

/// The one surface of a region of a simple class, if it explains most of the region.
fn simple_surface(
    search: &mut Search<'_>,
    region: &[u32],
    sample: &[Point],
    slippage: &Slippage,
) -> Option<Candidate> {
    let tolerance = search.scale.tolerance;
    let mut candidates = Vec::new();
    for start in slippage.starts(sample) {
        let needed = sample.len() / 2;
        let Some((surface, _)) = local::polish(&start, sample, tolerance, needed) else {
            continue;
        };
        let on = |&i: &u32| surface.distance(search.point(i)) <= tolerance;
        let seeds: Vec<u32> = region.iter().copied().filter(|i| on(i)).collect();
        if let Some(candidate) = search.grow(&surface, &seeds)
            && detect::is_worth_keeping(search, &candidate)
            && search.own(&candidate) as f64 >= SIMPLE * region.len() as f64
        {
            candidates.push(candidate);
        }
    }
    // A cone of hardly any slope slides like a cylinder.
    if slippage.class == Invariance::Cylindrical {
        let cylinder = slippage.starts(sample).into_iter().next();
        if let Some(crate::surface::Surface::Cylinder(cylinder)) = cylinder
            && let Some(cone) = least_squares::fit_cone_near(&cylinder, sample, Loss::Squares)
            && search.is_plausible(&cone.surface)
        {
            candidates.extend(
                search.grow(&cone.surface, region).filter(|candidate| {
                    search.own(candidate) as f64 >= SIMPLE * region.len() as f64
                }),
            );
        }
    }
    search.best(candidates)
}

#[cfg(test)]
mod tests;
