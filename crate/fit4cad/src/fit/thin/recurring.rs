//! Directions that the accepted surfaces have in common.

use super::{RECURRING, SHARE};
use crate::cloud::Direction;
use crate::fit::axes::direction_of;
use crate::fit::{Candidate, Search};

/// Sine of the angle below which two directions are one.
const SAME: f64 = 1e-3;

/// Normals of planes and axes that the accepted surfaces have in common, those of most points first, each as
/// the largest surface has it. Thin faces run along one of them even where no neighbour tells which.
pub fn recurring(search: &Search<'_>) -> Vec<Direction> {
    let mut largest: Vec<&Candidate> = search.accepted().iter().collect();
    largest.sort_by_key(|candidate| std::cmp::Reverse(candidate.support.len()));
    let directions = shared(largest.into_iter());
    let most = directions.first().map_or(0, |(_, points)| *points);
    frequent(directions, most)
}

/// As [`recurring`], but each as the first accepted surface has it, and only those of so large a share of all points
/// on surfaces with a direction.
pub fn prevailing(search: &Search<'_>) -> Vec<Direction> {
    let directions = shared(search.accepted().iter());
    let all = directions.iter().map(|(_, points)| points).sum();
    frequent(directions, all)
}

/// The directions of some surfaces with how many points they have, those of most first.
fn shared<'c>(candidates: impl Iterator<Item = &'c Candidate>) -> Vec<(Direction, usize)> {
    let mut directions: Vec<(Direction, usize)> = Vec::new();
    for candidate in candidates {
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
    directions
}

/// Those that have at least a share of so many points, not more than are worth trying everywhere.
fn frequent(directions: Vec<(Direction, usize)>, points: usize) -> Vec<Direction> {
    let least = SHARE * points as f64;
    let frequent = directions
        .into_iter()
        .filter(|(_, own)| *own as f64 >= least);
    frequent
        .take(RECURRING)
        .map(|(direction, _)| direction)
        .collect()
}
