//! Pruning: surfaces found twice become one, and surfaces that others explain are dropped.

use super::super::Candidate;
use super::super::least_squares::{self, Loss, degrees_of_freedom};
use super::super::search::{EXACT, Search};
use crate::surface::Surface;

/// Share of the points of two patches on one surface from which on it is the surface of both.
const SAME: f64 = 0.9;
/// Distance, in tolerances, at which two surfaces may turn out to be one: as far as one fitted to a
/// narrow patch strays across the cloud.
const ROUGHLY: f64 = 30.0;
/// Points of either patch that their common surface is fitted to.
const UNION_SAMPLE: usize = 400;
/// Share of a surface's points in the interior of others above which it is dropped.
const EXPLAINED: f64 = 0.5;

/// Merges equal surfaces and drops those most of whose points lie inside the patch of another,
/// smallest first. O(surfaces × points) in the worst case, but supports are mostly disjoint.
pub fn prune(search: &Search<'_>, mut candidates: Vec<Candidate>) -> Vec<Candidate> {
    candidates.sort_by_key(|candidate| std::cmp::Reverse(candidate.support.len()));
    let candidates = merge_equal(search, candidates);
    let candidates = drop_explained(search, candidates);
    drop_adrift(search, candidates)
}

/// Drops small patches most of whose surroundings lie on no surface: on a free-form region some
/// dozen points always fit something, while a true face is surrounded by other faces. Smallest
/// first, each drop leaving its neighbours more adrift, until nothing changes.
fn drop_adrift(search: &Search<'_>, mut candidates: Vec<Candidate>) -> Vec<Candidate> {
    let is_doubtful = |place: &usize| {
        let candidate = &candidates[*place];
        candidate.support.len() < SMALL && !is_exact(search, candidate)
    };
    let order: Vec<usize> = (0..candidates.len()).rev().filter(is_doubtful).collect();
    let mut is_held = held(search, &candidates, &order, ADRIFT).into_iter();
    candidates.retain(|_| is_held.next().unwrap_or(true));
    candidates
}

/// Which of some patches are held by what lies around them. Of the doubtful ones, given in the order in which they
/// are looked at, one goes as soon as more than a share of its surroundings lies on no patch, and leaves its
/// neighbours more adrift. O(doubtful² × points of one).
pub fn held(
    search: &Search<'_>,
    candidates: &[Candidate],
    doubtful: &[usize],
    most_adrift: f64,
) -> Vec<bool> {
    let mut claims = vec![0u32; search.cloud.len()];
    for &index in candidates.iter().flat_map(|c| &c.support) {
        claims[index as usize] += 1;
    }
    let mut is_held = vec![true; candidates.len()];
    while let Some(&place) = doubtful.iter().find(|&&place| {
        is_held[place] && share_adrift(search, &candidates[place], &claims) > most_adrift
    }) {
        is_held[place] = false;
        for &index in &candidates[place].support {
            claims[index as usize] -= 1;
        }
    }
    is_held
}

/// Whether so many points are so near a surface that it is no accident. A row of points, which lies
/// on many surfaces exactly, says nothing.
fn is_exact(search: &Search<'_>, candidate: &Candidate) -> bool {
    let freedom = degrees_of_freedom(candidate.surface.kind());
    let spare = candidate.support.len().saturating_sub(freedom);
    if !search.scale.is_clean()
        || spare < SPARE
        || candidate.error >= EXACT * search.scale.tolerance
    {
        return false;
    }
    !search.is_row(candidate)
}

/// Points beyond those that any surface of the family passes through.
const SPARE: usize = 2;

/// Share of the points around a patch that no patch holds.
fn share_adrift(search: &Search<'_>, candidate: &Candidate, claims: &[u32]) -> f64 {
    let (mut outside, mut unheld) = (0u32, 0u32);
    for &index in &candidate.support {
        for &neighbour in search.graph.of(index).iter().take(8) {
            if candidate.support.binary_search(&neighbour).is_err() {
                outside += 1;
                unheld += u32::from(claims[neighbour as usize] == 0);
            }
        }
    }
    f64::from(unheld) / f64::from(outside.max(1))
}

/// Patches of fewer points may be accidents.
const SMALL: usize = 150;
/// Share of surrounding points on no surface that makes a small patch an accident.
const ADRIFT: f64 = 0.5;

/// Makes one of candidates that are on one surface, fitted to all of them: a narrow patch does not
/// say precisely how its surface goes on to the next.
fn merge_equal(search: &Search<'_>, candidates: Vec<Candidate>) -> Vec<Candidate> {
    let mut merged: Vec<Candidate> = Vec::with_capacity(candidates.len());
    for candidate in candidates {
        let union = merged
            .iter()
            .enumerate()
            .find_map(|(place, other)| Some((place, union(search, other, &candidate)?)));
        match union {
            Some((place, union)) => merged[place] = union,
            None => merged.push(candidate),
        }
    }
    merged
}

/// The one surface of two candidates, the first being the larger, if there is one.
fn union(search: &Search<'_>, large: &Candidate, small: &Candidate) -> Option<Candidate> {
    let tolerance = search.scale.tolerance;
    let is_near = large.surface.kind() == small.surface.kind()
        && share_on(search, &small.support, &large.surface, ROUGHLY * tolerance) >= SAME;
    if !is_near {
        return None;
    }
    let sample = |candidate: &Candidate| {
        let stride = candidate.support.len().div_ceil(UNION_SAMPLE).max(1);
        let support = candidate.support.iter().copied();
        search.points(&support.step_by(stride).collect::<Vec<u32>>())
    };
    let points = [sample(large), sample(small)].concat();
    let fitted = least_squares::fit(&large.surface, &points, Loss::Squares)?;
    let is_on = |candidate: &Candidate| {
        share_on(search, &candidate.support, &fitted.surface, tolerance) >= SAME
    };
    if !(is_on(large) && is_on(small)) {
        return None;
    }
    let mut support = [large.support.as_slice(), &small.support].concat();
    support.sort_unstable();
    support.dedup();
    Some(Candidate {
        surface: fitted.surface,
        support,
        error: fitted.error,
    })
}

/// Share of the points (a sample of them) within a distance of a surface.
fn share_on(search: &Search<'_>, points: &[u32], surface: &Surface, limit: f64) -> f64 {
    let stride = points.len().div_ceil(64).max(1);
    let (mut on, mut all) = (0u32, 0u32);
    for &index in points.iter().step_by(stride) {
        all += 1;
        on += u32::from(surface.distance(search.point(index)) <= limit);
    }
    f64::from(on) / f64::from(all.max(1))
}

/// A point is interior to a patch when its eight nearest neighbours belong to it as well.
fn drop_explained(search: &Search<'_>, candidates: Vec<Candidate>) -> Vec<Candidate> {
    // How many patches each point is interior to.
    let mut interior = vec![0u32; search.cloud.len()];
    let mut member = vec![false; search.cloud.len()];
    let mut insides: Vec<Vec<u32>> = Vec::with_capacity(candidates.len());
    for candidate in &candidates {
        for &index in &candidate.support {
            member[index as usize] = true;
        }
        let is_inside = |&i: &u32| {
            let mut near = search.graph.of(i).iter().take(8);
            near.all(|&j| member[j as usize])
        };
        insides.push(
            candidate
                .support
                .iter()
                .copied()
                .filter(is_inside)
                .collect(),
        );
        for &index in &candidate.support {
            member[index as usize] = false;
        }
    }
    for &index in insides.iter().flatten() {
        interior[index as usize] += 1;
    }
    let mut kept = vec![true; candidates.len()];
    for (place, candidate) in candidates.iter().enumerate().rev() {
        let own = &insides[place];
        let mut of_others = 0;
        for &index in &candidate.support {
            let here = u32::from(own.binary_search(&index).is_ok());
            of_others += usize::from(interior[index as usize] > here);
        }
        if of_others as f64 > EXPLAINED * candidate.support.len() as f64 {
            kept[place] = false;
            for &index in own {
                interior[index as usize] -= 1;
            }
        }
    }
    let mut kept = kept.into_iter();
    candidates
        .into_iter()
        .filter(|_| kept.next().unwrap_or(true))
        .collect()
}
