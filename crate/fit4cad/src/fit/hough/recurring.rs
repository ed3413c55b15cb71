//! Directions that the accepted surfaces have in common.

use super::accumulator::{Accumulator, Ballot};
use super::directions::DirectionSpace;
use crate::cloud::Direction;
use crate::fit::Search;
use crate::fit::axes::direction_of;
use crate::fit::thin::{RECURRING, SHARE};

/// The directions that normals and axes of the accepted surfaces have in common: maxima of their
/// accumulator on the Gauss sphere, where a surface has as many votes as points. Narrow faces run
/// along one of them, even where no neighbour tells which.
pub fn recurring_directions(search: &Search<'_>, space: &DirectionSpace) -> Vec<Direction> {
    let accepted = search.accepted();
    let ballots = (0_u32..).zip(accepted).filter_map(|(voter, candidate)| {
        let direction = direction_of(&candidate.surface)?;
        Some(Ballot {
            cell: space.cell(&direction)?,
            voter,
            weight: candidate.support.len() as f32,
        })
    });
    let accumulator = Accumulator::count(ballots.collect());
    let diagram = accumulator.maxima(space);
    diagram
        .significant(SHARE)
        .take(RECURRING)
        .filter_map(|peak| {
            let voters = accumulator.voters_of(space, &diagram, peak);
            // The largest surface knows its direction best.
            let best = voters
                .into_iter()
                .max_by_key(|&voter| accepted[voter as usize].support.len())?;
            direction_of(&accepted[best as usize].surface)
        })
        .collect()
}
