//! What regions leave over, which the paper does not look for. Thin faces lie on the borders of others, so that no region is
//! theirs alone: their surfaces are proposed from what lies beside them, grown to connected support
//! as those of any minimal set, and compete for the points that are still free.

use super::super::Candidate;
use super::super::contest::{Evidence, accept_winners};
use super::super::detect;
use super::super::holders::Holders;
use super::super::profile;
use super::super::progress::{Cancelled, Observer, Stage};
use super::super::search::Search;
use super::super::thin::axis::known_axes;
use super::super::thin::borders::Borders;
use super::super::thin::recurring::recurring;
use super::super::thin::{self, Proposer, coaxial};
use crate::surface::Surface;

/// Finds surfaces about the axes of those found so far: with the axis known, patches suffice that are
/// too small or too flat to have one of their own.
///
/// # Errors
/// If the observer stops the fit.
pub fn about_known_axes(
    search: &mut Search<'_>,
    observer: &mut dyn Observer,
) -> Result<(), Cancelled> {
    for size in coaxial::SIZES {
        observer.progress(Stage::Find, 0.9)?;
        let axes = known_axes(search);
        let order = search.shuffled_unexplained();
        let mut proposals = Vec::new();
        let mut vain = 0;
        for seed in order {
            let patch = search.unexplained_near(seed, size);
            if patch.len() < coaxial::FEWEST {
                continue;
            }
            let found = coaxial::coaxial(search, &axes, &patch);
            vain += usize::from(found.is_empty());
            if vain > coaxial::VAIN {
                break;
            }
            proposals.extend(found.into_iter().map(|surface| (seed, surface)));
        }
        let candidates = grown(search, &proposals);
        accept(search, candidates, &mut Evidence::Own, observer);
    }
    Ok(())
}

/// Finds thin faces until no pass over the free points finds another.
///
/// # Errors
/// If the observer stops the fit.
pub fn thin_faces(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    // Rows of narrow extruded faces first: of these the profile as a whole tells more than any few rows.
    let told = rows_of_faces(search, observer);
    let mut borders = Borders::of(search);
    borders.close(&told);
    let mut proposer = Proposer::default();
    for pass in 0..thin::PASSES {
        proposer.directions = recurring(search);
        let mut accepted = 0;
        for size in 0..thin::SIZES.len() {
            let done = (pass * thin::SIZES.len() + size) as f64;
            let all = (thin::PASSES * thin::SIZES.len()) as f64;
            observer.progress(Stage::Find, 0.92 + 0.08 * done / all)?;
            let proposals = proposer.proposals(search, &borders, size);
            let candidates = grown(search, &proposals);
            let evidence = &mut Evidence::Borders(&mut borders);
            accepted += accept(search, candidates, evidence, observer);
        }
        if accepted == 0 {
            break;
        }
    }
    Ok(())
}

/// Accepts those of some candidates that win, and tells so. Returns how many.
fn accept(
    search: &mut Search<'_>,
    candidates: Vec<Candidate>,
    evidence: &mut Evidence<'_>,
    observer: &mut dyn Observer,
) -> usize {
    accept_winners(search, candidates, evidence, &mut |winner| {
        detect::tell(winner, observer);
    })
}

/// Decides the extruded faces along the recurring directions by their profiles. Returns of each point
/// whether all faces it is on are known from one.
fn rows_of_faces(search: &mut Search<'_>, observer: &mut dyn Observer) -> Vec<bool> {
    let directions = recurring(search);
    profile::extruded(search, &directions, &mut |face| {
        detect::tell(face, observer)
    })
}

/// Grows the proposed surfaces, unless what is on one around its point is on another of its family
/// that has grown already. Those that fade out are dropped, and no other of the family is tried at
/// their points: on free-form regions every neighbourhood proposes a surface a little different from
/// the next. O(proposals × points of a thin face).
fn grown(search: &mut Search<'_>, proposals: &[(u32, Surface)]) -> Vec<Candidate> {
    let mut tried: Vec<(Candidate, bool)> = Vec::new();
    let mut through = Holders::with_room(search.cloud.len(), 0);
    for (seed, surface) in proposals {
        let on = |index: &&u32| surface.distance(search.point(**index)) <= search.scale.tolerance;
        let around: Vec<u32> = search.graph.of(*seed).iter().filter(on).copied().collect();
        let is_grown = |place: u32| {
            let (other, is_fuzzy) = &tried[place as usize];
            let holds = |index: &u32| other.support.binary_search(index).is_ok();
            other.surface.kind() == surface.kind() && (*is_fuzzy || around.iter().all(holds))
        };
        if through.of(*seed).any(is_grown) {
            continue;
        }
        if let Some(candidate) = search.grow(surface, &[*seed]) {
            through.add(tried.len() as u32, &candidate.support);
            let is_fuzzy = search.has_fuzzy_border(&candidate);
            tried.push((candidate, is_fuzzy));
        }
    }
    let sharp = tried.into_iter().filter(|(_, is_fuzzy)| !is_fuzzy);
    sharp.map(|(candidate, _)| candidate).collect()
}
