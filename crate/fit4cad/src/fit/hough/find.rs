//! The search of HT: vote, pick persistent peaks, polish, let them compete, remove what the winners
//! explain, and vote again until nothing is left to find.

use super::family::Region;
use super::solutions;
use super::vote::{Spaces, Summit, Vote};
use crate::fit::least_squares::{self, Loss};
use crate::fit::{Cancelled, Candidate, Observer, Search, Stage};
use crate::surface::{Surface, SurfaceType};

/// Width of a direction cell in radians.
const ANGLE_STEP: f64 = 0.03;
/// Points that vote in the first round over a large cloud.
const FIRST_VOTERS: usize = 6000;
/// Neighbourhoods solved per round of curved votes.
const SEEDS: usize = 400;
/// Neighbourhood sizes, tried in turn.
const SIZES: [usize; 3] = [16, 28, 10];

/// Finds the surfaces of a cloud; they are the search's accepted candidates afterwards.
///
/// O(n log n) for a fixed number of surfaces.
pub fn find(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    if search.cloud.is_empty() {
        return Ok(());
    }
    let spaces = Spaces::new(region(search));
    planes(search, &spaces);
    observer.progress(Stage::Find, 0.3)?;
    let count = search.cloud.len();
    let mut blocked = vec![false; count];
    for (turn, size) in SIZES.into_iter().enumerate() {
        blocked.fill(false);
        let mut least = 2;
        loop {
            let seeds = seeds(search, &blocked);
            if seeds.is_empty() {
                break;
            }
            let mut votes = Vec::new();
            for &seed in &seeds {
                let patch = search.unexplained_near(seed, size);
                if patch.len() >= 8 {
                    solutions::votes(search, seed, &patch, &mut votes);
                }
                blocked[seed as usize] = true;
            }
            let accepted = round(search, &spaces, &votes, least);
            if accepted > 0 {
                least = 2;
            } else {
                least = 1;
            }
            let left = (0..count as u32)
                .filter(|&i| !search.is_explained(i))
                .count();
            let done = 1.0 - left as f64 / count as f64;
            observer.progress(Stage::Find, 0.3 + 0.7 * (turn as f64 + done) / 3.0)?;
        }
    }
    Ok(())
}

/// The region of parameter space, from the cloud's box and spacing.
fn region(search: &Search<'_>) -> Region {
    Region {
        bounds: search.cloud.bounds(),
        length_step: search.scale.spacing.max(4.0 * search.scale.tolerance),
        angle_step: ANGLE_STEP,
    }
}

/// Planes first: their votes cost least and explain most.
fn planes(search: &mut Search<'_>, spaces: &Spaces) {
    let count = search.cloud.len() as u32;
    let mut stride = count.div_ceil(FIRST_VOTERS as u32).max(1);
    loop {
        let votes: Vec<Vote> = (0..count)
            .step_by(stride as usize)
            .filter(|&index| !search.is_explained(index))
            .filter_map(|index| solutions::flat_vote(search, index))
            .collect();
        let accepted = round(search, spaces, &votes, 1);
        if accepted == 0 && stride == 1 {
            return;
        }
        stride = (stride / 4).max(1);
    }
}

/// An even sample of the points that nothing explains yet and that were not tried.
fn seeds(search: &mut Search<'_>, blocked: &[bool]) -> Vec<u32> {
    let mut free: Vec<u32> = (0..search.cloud.len() as u32)
        .filter(|&index| !search.is_explained(index) && !blocked[index as usize])
        .collect();
    let stride = free.len().div_ceil(SEEDS).max(1);
    search.random.shuffle(&mut free);
    free.into_iter().step_by(stride).collect()
}

/// Counts the votes, grows a candidate from every summit and accepts the winners. Returns how many.
fn round(search: &mut Search<'_>, spaces: &Spaces, votes: &[Vote], least: usize) -> usize {
    let share = search.parameters.persistence;
    let mut summits: Vec<Summit> = Vec::new();
    for kind in SurfaceType::ALL {
        summits.extend(spaces.climb(kind, votes, share, least, &mut |_| {}));
    }
    let mut candidates = Vec::new();
    for summit in &summits {
        let seeds: Vec<u32> = summit
            .voters
            .iter()
            .map(|&v| votes[v as usize].point)
            .collect();
        candidates.extend(grow(search, &summit.surface, &seeds));
    }
    accept_winners(search, candidates)
}

/// Grows a surface from its voters. A cylinder is also tried as a cone.
fn grow(search: &mut Search<'_>, surface: &Surface, seeds: &[u32]) -> Vec<Candidate> {
    let mut grown: Vec<Candidate> = search.grow(surface, seeds).into_iter().collect();
    if let Some(Candidate {
        surface: Surface::Cylinder(cylinder),
        support,
        ..
    }) = grown.first()
    {
        let stride = support.len().div_ceil(200);
        let points: Vec<_> = support
            .iter()
            .step_by(stride)
            .map(|&i| *search.point(i))
            .collect();
        let cone = least_squares::fit_cone_near(cylinder, &points, Loss::Squares);
        if let Some(cone) = cone {
            let support = support.clone();
            grown.extend(search.grow(&cone.surface, &support));
        }
    }
    grown
}

/// Accepts candidates, the one worth most first, as long as one is worth anything.
fn accept_winners(search: &mut Search<'_>, mut candidates: Vec<Candidate>) -> usize {
    let mut accepted = 0;
    loop {
        let smallest = search.parameters.smallest as usize;
        candidates.retain(|candidate| search.own(candidate) >= smallest);
        let Some(winner) = search.best(candidates.clone()) else {
            return accepted;
        };
        candidates.retain(|candidate| candidate != &winner);
        if !search.has_fuzzy_border(&winner) {
            search.accept(winner);
            accepted += 1;
        }
    }
}
