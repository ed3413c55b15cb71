//! The search of HT: vote, pick persistent peaks, polish, let them compete, remove what the winners
//! explain, and vote again until nothing is left to find.

use super::family::Region;
use super::noisy;
use super::pass::{Pass, block};
use super::recorder::Recorder;
use super::recurring::recurring_directions;
use super::rounds::{Work, round};
use super::solutions;
use super::vote::{Spaces, Vote};
use crate::fit::contest::Evidence;
use crate::fit::thin::axis::known_axes;
use crate::fit::thin::borders::Borders;
use crate::fit::thin::{self, Proposer, coaxial};
use crate::fit::{Cancelled, Observer, Search, Stage, profile};
use crate::surface::SurfaceType;

/// Width of a direction cell in radians.
const ANGLE_STEP: f64 = 0.03;
/// Cells of lengths where narrow faces are looked for, in spacings.
const FINE: f64 = 0.05;
/// Points that vote in the first round over a large cloud.
const FIRST_VOTERS: u32 = 6000;
/// Neighbourhoods that vote in one round. A face of a good size gets several votes, and a small
/// batch wastes few on what the round's winners explain.
const BATCH: usize = 48;
/// The families that closed forms start well; a torus costs far more to try.
const QUICK: [SurfaceType; 4] = [
    SurfaceType::Plane,
    SurfaceType::Sphere,
    SurfaceType::Cylinder,
    SurfaceType::Cone,
];

/// Finds the surfaces of a cloud; they are the search's accepted candidates afterwards.
///
/// O(n log n) for a fixed number of surfaces.
///
/// # Errors
/// If the observer stops the fit.
pub fn find(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    if search.cloud.is_empty() {
        return Ok(());
    }
    let region = Region {
        bounds: search.cloud.bounds(),
        length_step: search.scale.spacing.max(4.0 * search.scale.tolerance),
        angle_step: ANGLE_STEP,
        is_far: false,
    };
    // Narrow faces are narrower than the spacing, and so near each other.
    let fine = (FINE * search.scale.spacing).max(4.0 * search.scale.tolerance);
    let spaces = Spaces::new(region);
    let mut work = Work {
        fine: spaces.with_length_step(fine),
        spaces,
        recorder: Recorder::new(observer),
    };
    if search.scale.is_clean() {
        work.exact(search)
    } else {
        noisy::find(search, &mut work)
    }
}

impl Work<'_> {
    /// The search of a cloud whose points are on their surfaces: a handful that agree are no
    /// accident, so votes are trusted the more points they explain, the fewer the later.
    fn exact(&mut self, search: &mut Search<'_>) -> Result<(), Cancelled> {
        self.planes(search)?;
        // Neighbourhoods within one face: cheap, and wrong ones give no vote at all.
        for (size, progress) in [(16, [0.2, 0.4]), (28, [0.4, 0.5]), (10, [0.5, 0.6])] {
            let pass = Pass {
                failures: 4000,
                batch: BATCH,
                progress,
            };
            pass.run(search, self, &mut |search, seed, votes, _| {
                let patch = search.unexplained_near(seed, size);
                if patch.len() >= 10 {
                    votes.extend(solutions::pure_vote(search, seed, &patch));
                }
            })?;
        }
        let axes = known_axes(search);
        for (size, progress) in coaxial::SIZES.into_iter().zip([[0.6, 0.65], [0.65, 0.7]]) {
            let pass = Pass {
                failures: coaxial::VAIN,
                batch: BATCH,
                progress,
            };
            pass.run(search, self, &mut |search, seed, votes, _| {
                let patch = search.unexplained_near(seed, size);
                if patch.len() >= coaxial::FEWEST {
                    let found = coaxial::coaxial(search, &axes, &patch).into_iter();
                    votes.extend(found.map(|surface| Vote {
                        surface,
                        point: seed,
                    }));
                }
            })?;
        }
        let pass = Pass {
            failures: 300,
            batch: BATCH,
            progress: [0.7, 0.72],
        };
        pass.run(search, self, &mut |search, seed, votes, blocked| {
            let patch = search.unexplained_near(seed, 16);
            let before = votes.len();
            if patch.len() >= 8 {
                let found = coaxial::mixed_coaxial(search, &axes, &patch).into_iter();
                votes.extend(found.map(|surface| Vote {
                    surface,
                    point: seed,
                }));
            }
            if votes.len() == before {
                block(&patch, blocked);
            }
        })?;
        let pass = Pass {
            failures: 60,
            batch: BATCH,
            progress: [0.72, 0.8],
        };
        pass.run(search, self, &mut |search, seed, votes, blocked| {
            let patch = search.unexplained_near(seed, 28);
            if patch.len() >= 12 {
                mixed(search, seed, &patch, &[SurfaceType::Torus], votes, blocked);
            }
        })?;
        // What is left is small, thin or free-form.
        for (size, progress) in [(10, [0.8, 0.85]), (16, [0.85, 0.9]), (28, [0.9, 0.95])] {
            let pass = Pass {
                failures: 200,
                batch: BATCH,
                progress,
            };
            pass.run(search, self, &mut |search, seed, votes, blocked| {
                let patch = search.unexplained_near(seed, size);
                if patch.len() >= 6 {
                    mixed(search, seed, &patch, &QUICK, votes, blocked);
                }
            })?;
        }
        if !search.scale.shows_rows() {
            return self.recorder.progress(Stage::Find, 1.0);
        }
        self.recorder.progress(Stage::Find, 0.95)?;
        let directions = recurring_directions(search, self.spaces.directions());
        let recorder = &mut self.recorder;
        let told = profile::extruded(search, &directions, &mut |face| recorder.accepted(face));
        let mut borders = Borders::of(search);
        borders.close(&told);
        let mut proposer = Proposer::default();
        for _ in 0..thin::PASSES {
            if self.borders(search, &mut borders, &mut proposer)? == 0 {
                break;
            }
        }
        self.recorder.progress(Stage::Find, 1.0)
    }

    /// Planes first: their votes cost least and explain most.
    fn planes(&mut self, search: &mut Search<'_>) -> Result<(), Cancelled> {
        let count = search.cloud.len() as u32;
        let mut stride = count.div_ceil(FIRST_VOTERS).max(1);
        loop {
            let votes: Vec<Vote> = (0..count)
                .step_by(stride as usize)
                .filter(|&index| !search.is_explained(index))
                .filter_map(|index| solutions::flat_vote(search, index))
                .collect();
            let accepted = round(search, self, &votes, &mut Evidence::Own);
            if accepted == 0 && stride == 1 {
                return Ok(());
            }
            self.recorder.progress(Stage::Find, 0.1)?;
            stride = (stride / 4).max(1);
        }
    }

    /// Rounds of votes by points on open borders and those still unexplained. Returns how many
    /// surfaces were accepted. O(free points).
    fn borders(
        &mut self,
        search: &mut Search<'_>,
        borders: &mut Borders,
        proposer: &mut Proposer,
    ) -> Result<usize, Cancelled> {
        proposer.directions = recurring_directions(search, self.spaces.directions());
        let mut accepted = 0;
        for size in 0..thin::SIZES.len() {
            self.recorder.progress(Stage::Find, 0.95)?;
            let proposals = proposer.proposals(search, borders, size).into_iter();
            let votes: Vec<Vote> = proposals
                .map(|(point, surface)| Vote { surface, point })
                .collect();
            std::mem::swap(&mut self.spaces, &mut self.fine);
            accepted += round(search, self, &votes, &mut Evidence::Borders(borders));
            std::mem::swap(&mut self.spaces, &mut self.fine);
        }
        Ok(accepted)
    }
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
    solutions::mixed_votes(search, seed, patch, kinds, 1, votes);
    if votes.len() == before {
        block(patch, blocked);
    }
}
