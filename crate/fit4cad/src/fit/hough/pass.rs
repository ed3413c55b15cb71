//! Passes: rounds of votes by one kind of neighbourhood, over all points that are free.

use super::rounds::{Work, round};
use super::vote::Vote;
use crate::fit::contest::Evidence;
use crate::fit::{Cancelled, Search, Stage};

/// Rounds, in batches of votes, over which votes that no winner explained are counted again.
const HEARD: usize = 4;
/// Points blocked around a seed of a mixed neighbourhood that leads nowhere.
const BLOCK: usize = 8;

/// What a seed votes for; may also block points from being seeds.
pub type Voter<'v> = dyn FnMut(&Search<'_>, u32, &mut Vec<Vote>, &mut [bool]) + 'v;

/// How long a pass goes on.
#[derive(Debug, Clone, Copy)]
pub struct Pass {
    /// Seeds without a vote after which it ends.
    pub failures: usize,
    /// Neighbourhoods that vote in one round.
    pub batch: usize,
    /// Share of the search done when it starts and when it ends.
    pub progress: [f64; 2],
}

impl Pass {
    /// Rounds of votes by unexplained points until each has been a seed, was blocked or is
    /// explained, or too many seeds have led nowhere.
    ///
    /// # Errors
    /// If the observer stops the fit.
    pub fn run(
        self,
        search: &mut Search<'_>,
        work: &mut Work<'_>,
        voter: &mut Voter<'_>,
    ) -> Result<(), Cancelled> {
        let order = search.shuffled_unexplained();
        let mut blocked = vec![false; search.cloud.len()];
        let mut votes = Vec::new();
        let (mut fresh, mut failures) = (0, 0);
        for (turn, &seed) in order.iter().enumerate() {
            if search.is_explained(seed) || blocked[seed as usize] {
                continue;
            }
            let before = votes.len();
            voter(search, seed, &mut votes, &mut blocked);
            if votes.len() == before {
                failures += 1;
                if failures > self.failures {
                    break;
                }
                continue;
            }
            fresh += 1;
            if fresh == self.batch {
                // Votes that no winner explained stay and are counted again with the next.
                let accepted = round(search, work, &votes, &mut Evidence::Own);
                // Within noise every neighbourhood of a free-form region has a surface to vote for.
                if accepted == 0 && search.scale.has_noise() {
                    for vote in &votes {
                        block(search.graph.of(vote.point), &mut blocked);
                    }
                }
                votes.retain(|vote| !search.is_explained(vote.point));
                let oldest = votes.len().saturating_sub(HEARD * self.batch);
                votes.drain(..oldest);
                fresh = 0;
                let [from, to] = self.progress;
                let share = turn as f64 / order.len() as f64;
                work.recorder
                    .progress(Stage::Find, from + (to - from) * share)?;
            }
        }
        while round(search, work, &votes, &mut Evidence::Own) > 0 {
            votes.retain(|vote| !search.is_explained(vote.point));
        }
        Ok(())
    }
}

/// Keeps the first points of a patch from being seeds.
pub fn block(patch: &[u32], blocked: &mut [bool]) {
    for &index in patch.iter().take(BLOCK) {
        blocked[index as usize] = true;
    }
}
