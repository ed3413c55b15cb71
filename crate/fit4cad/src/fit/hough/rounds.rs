//! One round of the transform: count the votes, pick the summits, polish, and let the candidates
//! compete.

use super::recorder::Recorder;
use super::vote::{Spaces, Summit, Vote};
use crate::fit::contest::{Evidence, accept_winners};
use crate::fit::least_squares::{self, Loss};
use crate::fit::local;
use crate::fit::{Candidate, Search};
use crate::surface::{Surface, SurfaceType};

/// Points of a candidate from which a rival is fitted.
const SAMPLE: usize = 200;

/// The spaces of a search and who follows it.
pub struct Work<'o> {
    /// The parameter spaces.
    pub spaces: Spaces,
    /// As `spaces`, with finer cells of lengths, for votes of exact rows of points.
    pub fine: Spaces,
    /// Follows the search.
    pub recorder: Recorder<'o>,
}

/// Counts the votes of all families and accepts the winners. Returns how many there were.
pub fn round(
    search: &mut Search<'_>,
    work: &mut Work<'_>,
    votes: &[Vote],
    evidence: &mut Evidence<'_>,
) -> usize {
    let share = match evidence {
        Evidence::Own => search.parameters.persistence,
        // The neighbourhoods of a narrow face are few, and next to a large one theirs are not heard.
        Evidence::Borders(_) => 0.0,
    };
    let mut summits: Vec<Summit> = Vec::new();
    let points = search.cloud.points();
    let far = work.spaces.far();
    for (spaces, kind) in [&work.spaces, &far]
        .into_iter()
        .flat_map(|spaces| SurfaceType::ALL.map(|kind| (spaces, kind)))
    {
        summits.extend(spaces.climb(kind, votes, points, share, 1, &mut work.recorder));
    }
    summits.sort_by_key(|summit| std::cmp::Reverse(summit.voters.len()));
    let mut candidates: Vec<Candidate> = Vec::new();
    for summit in &summits {
        work.recorder.summit(&summit.surface, summit.voters.len());
        let seeds: Vec<u32> = summit
            .voters
            .iter()
            .map(|&voter| votes[voter as usize].point)
            .filter(|&point| !is_grown(&candidates, &summit.surface, point))
            .collect();
        if !seeds.is_empty() {
            grow(search, &summit.surface, &seeds, &mut candidates);
        }
    }
    accept_winners(search, candidates, evidence, &mut |winner| {
        work.recorder.accepted(winner);
    })
}

/// Whether a candidate of the same family has already grown over a point.
fn is_grown(candidates: &[Candidate], surface: &Surface, point: u32) -> bool {
    candidates.iter().any(|candidate| {
        candidate.surface.kind() == surface.kind()
            && candidate.support.binary_search(&point).is_ok()
    })
}

/// Grows a surface from its voters, and its rivals from an even sample of its patch. A cylinder is
/// also tried as a cone: a small patch of a cone fits a cylinder well, but not over the whole face.
/// Within noise every surface is also tried as the simpler ones.
fn grow(
    search: &mut Search<'_>,
    surface: &Surface,
    seeds: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let Some(candidate) = search.grow(surface, seeds) else {
        return;
    };
    let stride = candidate.support.len().div_ceil(SAMPLE).max(1);
    let sample: Vec<u32> = candidate.support.iter().copied().step_by(stride).collect();
    let points = search.points(&sample);
    let mut rivals: Vec<Surface> = Vec::new();
    if let Surface::Cylinder(cylinder) = &candidate.surface {
        let cone = least_squares::fit_cone_near(cylinder, &points, Loss::Squares);
        rivals.extend(cone.map(|fitted| fitted.surface));
    }
    if !search.scale.is_clean() {
        let simpler: &[SurfaceType] = match candidate.surface.kind() {
            SurfaceType::Plane => &[],
            SurfaceType::Cylinder => &[SurfaceType::Plane],
            SurfaceType::Sphere => &[SurfaceType::Plane, SurfaceType::Cylinder],
            SurfaceType::Cone | SurfaceType::Torus => &[
                SurfaceType::Plane,
                SurfaceType::Cylinder,
                SurfaceType::Sphere,
            ],
        };
        rivals.extend(
            simpler
                .iter()
                .flat_map(|&kind| local::starts(kind, &points)),
        );
    }
    for rival in rivals {
        candidates.extend(search.grow(&rival, &sample));
    }
    candidates.push(candidate);
}
