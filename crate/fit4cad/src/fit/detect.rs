//! Greedy detection from local hypotheses: wherever points are unexplained, surfaces through small
//! neighbourhoods are grown and the best one is kept, until nothing is left to find.

use super::least_squares::{self, Loss};
use super::local::{polish, starts};
use super::progress::{Cancelled, Observer, Stage};
use super::search::Search;
use super::trace::Event;
use super::{Candidate, Parameters};
use crate::surface::{Surface, SurfaceType};

/// Sizes of the neighbourhoods that hypotheses are made from: the small ones fit into fillets and
/// thin faces, the large one says more about slightly curved surfaces.
const SIZES: [usize; 3] = [10, 16, 28];
/// A plane that grew to so many unexplained points needs no rival.
const CLEAR: usize = 60;

/// Finds surfaces through unexplained points until no seed leads to another.
///
/// Seeds are visited in random order. Where a seed leads nowhere, as in free-form regions, its
/// neighbours are not tried in the same round: most of the time would go there.
pub fn greedy(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    let count = search.cloud.len();
    let mut order: Vec<u32> = (0u32..).take(count).collect();
    search.random.shuffle(&mut order);
    let mut remaining = count.max(1);
    let mut blocked = vec![0u8; count];
    for round in 0..2u8 {
        let block = if round == 0 { 16 } else { 6 };
        let mut failures = 0;
        for &seed in &order {
            if search.is_explained(seed) || blocked[seed as usize] > round {
                continue;
            }
            match at(search, seed) {
                Some(candidate) => {
                    remaining -= search.own(&candidate).min(remaining);
                    keep(search, candidate, observer);
                    let done = 1.0 - remaining as f64 / count as f64;
                    observer.progress(Stage::Find, 0.9 * done)?;
                }
                None => {
                    blocked[seed as usize] = round + 1;
                    for index in search.unexplained_near(seed, block) {
                        blocked[index as usize] = round + 1;
                    }
                    failures += 1;
                    if failures % 64 == 0 {
                        let done = 1.0 - remaining as f64 / count as f64;
                        observer.progress(Stage::Find, 0.9 * done)?;
                    }
                    if failures > MOST_FAILURES {
                        break;
                    }
                }
            }
        }
    }
    Ok(())
}

/// Failed seeds after which a round ends.
const MOST_FAILURES: usize = 1500;

fn keep(search: &mut Search<'_>, candidate: Candidate, observer: &mut dyn Observer) {
    if observer.wants_trace() {
        observer.trace(Event::Accepted {
            surface: candidate.surface,
            support: candidate.support.clone(),
        });
    }
    search.accept(candidate);
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
    }
    search.best(candidates)
}

/// Grows the hypotheses of one family through a patch and adds those worth keeping.
fn hypotheses(
    search: &mut Search<'_>,
    kind: SurfaceType,
    patch: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let points = search.points(patch);
    let needed = points.len() / 2;
    let mut surfaces = starts(kind, &points);
    if kind == SurfaceType::Cone {
        // A cylinder that almost fits may be a cone.
        for start in starts(SurfaceType::Cylinder, &points) {
            if let Surface::Cylinder(cylinder) = start
                && let Some(cone) = least_squares::fit_cone_near(&cylinder, &points, Loss::Squares)
            {
                surfaces.push(cone.surface);
            }
        }
    }
    for start in surfaces {
        let Some((surface, inliers)) = polish(&start, &points, search.scale.tolerance, needed)
        else {
            continue;
        };
        if !search.is_plausible(&surface) {
            continue;
        }
        let seeds: Vec<u32> = inliers.iter().map(|&i| patch[i]).collect();
        let known = candidates.iter().any(|c| {
            c.surface.kind() == kind && seeds.iter().all(|i| c.support.binary_search(i).is_ok())
        });
        if known {
            continue;
        }
        if let Some(candidate) = search.grow(&surface, &seeds)
            && is_worth_keeping(search, &candidate)
        {
            candidates.push(candidate);
        }
    }
}

/// Whether a candidate explains enough that nothing else does, and ends sharply.
fn is_worth_keeping(search: &mut Search<'_>, candidate: &Candidate) -> bool {
    let smallest = Parameters::count(search.parameters.smallest);
    let redundant = least_squares::degrees_of_freedom(candidate.surface.kind()) + 3;
    candidate.support.len() >= smallest.max(redundant)
        && search.own(candidate) >= smallest.max(3)
        && !search.has_fuzzy_border(candidate)
}
