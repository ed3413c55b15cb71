//! Detection from local hypotheses: the best surface through the neighbourhood of a seed.

use super::contest::is_evident;
use super::least_squares;
use super::local::{self, SHEETS, polish};
use super::progress::Observer;
use super::search::Search;
use super::trace::Event;
use super::{Candidate, Parameters};
use crate::surface::{Surface, SurfaceType};

/// Sizes of the neighbourhoods that hypotheses are made from: the small ones fit into fillets and
/// thin faces, the large one says more about slightly curved surfaces.
const SIZES: [usize; 3] = [10, 16, 28];
/// A plane that grew to so many unexplained points needs no rival.
pub(super) const CLEAR: usize = 60;

/// The points in random order.
pub(super) fn shuffled(search: &mut Search<'_>) -> Vec<u32> {
    let mut order: Vec<u32> = (0u32..).take(search.cloud.len()).collect();
    search.random.shuffle(&mut order);
    order
}

/// Accepts a candidate, and tells so.
pub(super) fn keep(search: &mut Search<'_>, candidate: Candidate, observer: &mut dyn Observer) {
    tell(&candidate, observer);
    search.accept(candidate);
}

/// Tells that a candidate is accepted.
pub(super) fn tell(candidate: &Candidate, observer: &mut dyn Observer) {
    if observer.wants_trace() {
        observer.trace(Event::accepted(candidate));
    }
}

/// The best surface through the unexplained points around a seed, if any is worth keeping.
pub fn at(search: &mut Search<'_>, seed: u32) -> Option<Candidate> {
    let mut candidates: Vec<Candidate> = Vec::new();
    for size in SIZES {
        let patch = search.unexplained_near(seed, size);
        if patch.len() < size.min(5) {
            continue;
        }
        for kind in [
            SurfaceType::Plane,
            SurfaceType::Sphere,
            SurfaceType::Cylinder,
            SurfaceType::Cone,
        ] {
            hypotheses(search, kind, &patch, &mut candidates);
            let clear = candidates
                .iter()
                .any(|c| c.surface.kind() == SurfaceType::Plane && search.own(c) >= CLEAR);
            if clear {
                return search.best(candidates);
            }
        }
    }
    if !candidates.iter().any(|c| search.own(c) >= CLEAR) {
        let patch = search.unexplained_near(seed, SIZES[2]);
        hypotheses(search, SurfaceType::Torus, &patch, &mut candidates);
        if candidates.is_empty() && search.scale.is_clean() {
            sheets(search, &patch, &mut candidates);
        }
    }
    search.best(candidates)
}

/// Grows the sheet of a thin wall that the first point of a patch is on.
fn sheets(search: &mut Search<'_>, patch: &[u32], candidates: &mut Vec<Candidate>) {
    let points = search.points(patch);
    for kind in SHEETS {
        let tolerance = search.scale.tolerance;
        for (surface, inliers) in local::through_sheet(kind, &points, tolerance, local::SPARE) {
            grow_surface(search, &surface, patch, &inliers, candidates);
        }
    }
}

/// Grows the hypotheses of one family through a patch and adds those worth keeping.
fn hypotheses(
    search: &mut Search<'_>,
    kind: SurfaceType,
    patch: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let points = search.points(patch);
    for start in local::hypotheses(kind, &points) {
        grow_start(search, &start, patch, candidates);
    }
}

/// Polishes a surface on the points of a patch, grows it, and adds it if it is worth keeping.
pub(super) fn grow_start(
    search: &mut Search<'_>,
    start: &Surface,
    patch: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let kind = start.kind();
    let points = search.points(patch);
    // A third suffices for a plane: the patch may hold both sheets of a thin wall and its rim.
    let needed = if kind == SurfaceType::Plane {
        points.len() / 3
    } else {
        points.len() / 2
    };
    if let Some((surface, inliers)) = polish(start, &points, search.scale.tolerance, needed) {
        grow_surface(search, &surface, patch, &inliers, candidates);
    }
}

/// Grows a surface from those points of a patch that are on it, and adds it if it is worth keeping.
fn grow_surface(
    search: &mut Search<'_>,
    surface: &Surface,
    patch: &[u32],
    inliers: &[usize],
    candidates: &mut Vec<Candidate>,
) {
    if !search.is_plausible(surface) {
        return;
    }
    let kind = surface.kind();
    let seeds: Vec<u32> = inliers.iter().map(|&i| patch[i]).collect();
    let known = candidates.iter().any(|c| {
        c.surface.kind() == kind && seeds.iter().all(|i| c.support.binary_search(i).is_ok())
    });
    if known || search.is_known(kind, &seeds) {
        return;
    }
    if let Some(candidate) = search.grow(surface, &seeds)
        && is_worth_keeping(search, &candidate)
    {
        candidates.push(candidate);
    }
}

/// Whether a candidate explains enough that nothing else does, is a face rather than a curve, and
/// ends sharply.
pub(super) fn is_worth_keeping(search: &mut Search<'_>, candidate: &Candidate) -> bool {
    let size = candidate.support.len();
    if search.scale.is_clean() {
        let is_broad = size > SMALL || search.thickness(candidate) >= INSIDE;
        return is_broad && !search.is_row(candidate) && is_evident(search, candidate);
    }
    let smallest = Parameters::count(search.parameters.smallest);
    let redundant = NOISY * least_squares::degrees_of_freedom(candidate.surface.kind());
    size >= smallest.max(redundant)
        && search.own(candidate) >= smallest.max(redundant / 3)
        && search.thickness(candidate) >= INSIDE
}

/// Noisy points needed per degree of freedom: a few are on any surface by accident, in numbers that
/// grow with the share of space the tolerance takes up.
const NOISY: usize = 8;

/// Points below which a candidate must have an inside: two rows of them are on many surfaces.
const SMALL: usize = 20;
/// Mean number of own neighbours among the eight nearest: of a patch with an inside.
const INSIDE: f64 = 5.2;
