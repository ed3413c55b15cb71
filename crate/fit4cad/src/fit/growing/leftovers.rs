//! Step 5: what regions leave over. Thin faces lie on the borders of others, so that no region is
//! theirs alone: their surfaces are proposed from what lies beside them, grown to connected support
//! as those of any minimal set, and compete for the points that are still free.

use super::super::Candidate;
use super::super::axes::direction_of;
use super::super::contest::{Evidence, accept_winners};
use super::super::progress::{Cancelled, Observer, Stage};
use super::super::search::Search;
use super::super::thin::borders::Borders;
use super::super::thin::{self, Proposer};
use super::super::trace::Event;
use crate::cloud::Direction;
use crate::surface::Surface;

/// Most directions of the whole cloud that are tried everywhere.
const RECURRING: usize = 6;
/// Share of the points of the most frequent direction that makes one recurring.
const SHARE: f64 = 0.02;
/// Sine of the angle below which two directions are one.
const SAME: f64 = 1e-3;

/// Finds thin faces until no pass over the free points finds another.
pub fn thin_faces(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    let mut borders = Borders::of(search);
    let mut proposer = Proposer::default();
    for pass in 0..thin::PASSES {
        proposer.directions = recurring(search);
        let mut accepted = 0;
        for size in 0..thin::SIZES.len() {
            let done = (pass * thin::SIZES.len() + size) as f64;
            let all = (thin::PASSES * thin::SIZES.len()) as f64;
            observer.progress(Stage::Find, 0.8 + 0.2 * done / all)?;
            let proposals = proposer.proposals(search, &borders, size);
            let candidates = grown(search, &proposals);
            let wants_trace = observer.wants_trace();
            let mut show = |winner: &Candidate| {
                if wants_trace {
                    observer.trace(Event::Accepted {
                        surface: winner.surface,
                        support: winner.support.clone(),
                    });
                }
            };
            let evidence = &mut Evidence::Borders(&mut borders);
            accepted += accept_winners(search, candidates, evidence, &mut show);
        }
        if accepted == 0 {
            break;
        }
    }
    Ok(())
}

/// Normals of planes and axes that the accepted surfaces have in common, by how many points they
/// have. Thin faces run along one of them even where no neighbour tells which.
fn recurring(search: &Search<'_>) -> Vec<Direction> {
    let mut largest: Vec<&Candidate> = search.accepted().iter().collect();
    largest.sort_by_key(|candidate| std::cmp::Reverse(candidate.support.len()));
    let mut directions: Vec<(Direction, usize)> = Vec::new();
    for candidate in largest {
        let Some(direction) = direction_of(&candidate.surface) else {
            continue;
        };
        let points = candidate.support.len();
        let same = |(other, _): &&mut (Direction, usize)| other.cross(&direction).norm() < SAME;
        match directions.iter_mut().find(same) {
            Some((_, count)) => *count += points,
            None => directions.push((direction, points)),
        }
    }
    directions.sort_by_key(|(_, points)| std::cmp::Reverse(*points));
    let most = directions.first().map_or(0, |(_, points)| *points);
    directions.retain(|(_, points)| *points as f64 >= SHARE * most as f64);
    directions.truncate(RECURRING);
    directions
        .into_iter()
        .map(|(direction, _)| direction)
        .collect()
}

/// Grows the proposed surfaces, unless what is on one around its point is on another of its family
/// that has grown already. O(proposals × points of a thin face).
fn grown(search: &mut Search<'_>, proposals: &[(u32, Surface)]) -> Vec<Candidate> {
    let mut candidates: Vec<Candidate> = Vec::new();
    // The candidates through each point, ascending.
    let mut through: Vec<Vec<u32>> = vec![Vec::new(); search.cloud.len()];
    for (seed, surface) in proposals {
        let on = |index: &&u32| surface.distance(search.point(**index)) <= search.scale.tolerance;
        let around: Vec<u32> = search.graph.of(*seed).iter().filter(on).copied().collect();
        let is_grown = |&place: &u32| {
            candidates[place as usize].surface.kind() == surface.kind()
                && around
                    .iter()
                    .all(|&index| through[index as usize].binary_search(&place).is_ok())
        };
        if through[*seed as usize].iter().any(is_grown) {
            continue;
        }
        if let Some(candidate) = search.grow(surface, &[*seed]) {
            for &index in &candidate.support {
                through[index as usize].push(candidates.len() as u32);
            }
            candidates.push(candidate);
        }
    }
    candidates
}
