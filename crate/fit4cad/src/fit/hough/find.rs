//! The search of HT: vote, pick persistent peaks, polish, let them compete, remove what the winners
//! explain, and vote again until nothing is left to find.

use super::borders::Borders;
use super::coaxial::{coaxial_votes, known_axes, ring_votes};
use super::family::Region;
use super::rounds::{Evidence, round};
use super::solutions;
use super::vote::{Spaces, Vote};
use crate::fit::{Cancelled, Observer, Search, Stage};
use crate::surface::SurfaceType;

/// Width of a direction cell in radians.
const ANGLE_STEP: f64 = 0.03;
/// Points that vote in the first round over a large cloud.
const FIRST_VOTERS: usize = 6000;
/// Neighbourhoods that vote in one round. A face of a good size gets several votes, and a small
/// batch wastes few on what the round's winners explain.
const BATCH: usize = 48;

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
    // Neighbourhoods within one face: cheap, and wrong ones give no vote at all.
    for size in [16, 28, 10] {
        search_with(search, &spaces, observer, &mut |search, seed, votes, _| {
            let patch = search.unexplained_near(seed, size);
            if patch.len() >= 10 {
                votes.extend(solutions::pure_vote(search, seed, &patch));
            }
        })?;
    }
    let axes = known_axes(search);
    for size in [16, 8] {
        search_with(search, &spaces, observer, &mut |search, seed, votes, _| {
            let patch = search.unexplained_near(seed, size);
            if patch.len() >= 6 {
                coaxial_votes(search, &axes, seed, &patch, votes);
            }
        })?;
    }
    search_with(
        search,
        &spaces,
        observer,
        &mut |search, seed, votes, blocked| {
            let patch = search.unexplained_near(seed, 28);
            if patch.len() >= 12 {
                mixed(search, seed, &patch, &[SurfaceType::Torus], votes, blocked);
            }
        },
    )?;
    // What is left is small, thin or free-form.
    for size in [10, 16, 28] {
        search_with(
            search,
            &spaces,
            observer,
            &mut |search, seed, votes, blocked| {
                const KINDS: [SurfaceType; 4] = [
                    SurfaceType::Plane,
                    SurfaceType::Sphere,
                    SurfaceType::Cylinder,
                    SurfaceType::Cone,
                ];
                let patch = search.unexplained_near(seed, size);
                if patch.len() >= 6 {
                    mixed(search, seed, &patch, &KINDS, votes, blocked);
                }
            },
        )?;
    }
    for _ in 0..BORDER_PASSES {
        if borders(search, &spaces) == 0 {
            break;
        }
    }
    Ok(())
}

/// Passes over the open borders: what one settles may be the border of a next.
const BORDER_PASSES: usize = 3;

/// Rounds of votes by points on open borders and those still unexplained. Returns how many surfaces
/// were accepted.
fn borders(search: &mut Search<'_>, spaces: &Spaces) -> usize {
    let mut borders = Borders::of(search);
    let axes = known_axes(search);
    let radius = 4.0 * search.scale.spacing;
    let mut accepted = 0;
    for size in [10, 16] {
        let seeds = (0..search.cloud.len() as u32).filter(|&index| borders.is_free(index));
        let mut votes = Vec::new();
        let mut near = Vec::new();
        for seed in seeds {
            let point = search.point(seed);
            search
                .tree
                .nearest(point, size, radius, |i| borders.is_free(i), &mut near);
            let patch: Vec<u32> = near.iter().map(|neighbour| neighbour.index).collect();
            if patch.len() < 6 {
                continue;
            }
            let before = votes.len();
            ring_votes(search, &borders, &axes, seed, &patch, &mut votes);
            if votes.len() == before {
                votes.extend(solutions::pure_vote(search, seed, &patch));
            }
        }
        accepted += round(
            search,
            spaces,
            &votes,
            &mut Evidence::Borders(&mut borders),
            &mut |_| {},
        );
    }
    accepted
}

/// Votes of a neighbourhood that may be mixed. Where there are none its points are blocked: in a
/// free-form region nearly all the time would go into seeds that lead nowhere.
fn mixed(
    search: &Search<'_>,
    seed: u32,
    patch: &[u32],
    kinds: &[SurfaceType],
    votes: &mut Vec<Vote>,
    blocked: &mut [bool],
) {
    let before = votes.len();
    solutions::mixed_votes(search, seed, patch, kinds, votes);
    if votes.len() == before {
        for &index in patch.iter().take(BLOCK) {
            blocked[index as usize] = true;
        }
    }
}

/// Points blocked around a seed that leads nowhere.
const BLOCK: usize = 8;

/// What a seed votes for; may also block points from being seeds.
type Voter<'v> = dyn FnMut(&Search<'_>, u32, &mut Vec<Vote>, &mut [bool]) + 'v;

/// Rounds of votes by unexplained points until each has been a seed, was blocked or is explained.
fn search_with(
    search: &mut Search<'_>,
    spaces: &Spaces,
    observer: &mut dyn Observer,
    voter: &mut Voter<'_>,
) -> Result<(), Cancelled> {
    let count = search.cloud.len();
    let mut order: Vec<u32> = (0..count as u32)
        .filter(|&i| !search.is_explained(i))
        .collect();
    search.random.shuffle(&mut order);
    let mut blocked = vec![false; count];
    let mut votes = Vec::new();
    let mut fresh = 0;
    for (turn, &seed) in order.iter().enumerate() {
        if search.is_explained(seed) || blocked[seed as usize] {
            continue;
        }
        let before = votes.len();
        voter(search, seed, &mut votes, &mut blocked);
        fresh += usize::from(votes.len() > before);
        if fresh == BATCH {
            // Votes that no winner explained stay and are counted again with the next.
            round(search, spaces, &votes, &mut Evidence::Own, &mut |_| {});
            votes.retain(|vote| !search.is_explained(vote.point));
            fresh = 0;
            let share = turn as f64 / order.len() as f64;
            observer.progress(Stage::Find, 0.3 + 0.6 * share)?;
        }
    }
    while round(search, spaces, &votes, &mut Evidence::Own, &mut |_| {}) > 0 {
        votes.retain(|vote| !search.is_explained(vote.point));
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
        let accepted = round(search, spaces, &votes, &mut Evidence::Own, &mut |_| {});
        if accepted == 0 && stride == 1 {
            return;
        }
        stride = (stride / 4).max(1);
    }
}
