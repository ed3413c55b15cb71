//! Pruning: surfaces found twice become one, and surfaces that others explain are dropped.

use super::super::Candidate;
use super::super::search::Search;
use super::membership;

/// Share of a surface's points on another of its type, both ways, above which they are one.
const SAME: f64 = 0.9;
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
    let mut claims = vec![0u32; search.cloud.len()];
    for &index in candidates.iter().flat_map(|c| &c.support) {
        claims[index as usize] += 1;
    }
    loop {
        let adrift = candidates.iter().rposition(|candidate| {
            candidate.support.len() < SMALL && share_adrift(search, candidate, &claims) > ADRIFT
        });
        let Some(place) = adrift else {
            return candidates;
        };
        for index in candidates.remove(place).support {
            claims[index as usize] -= 1;
        }
    }
}

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

fn merge_equal(search: &Search<'_>, candidates: Vec<Candidate>) -> Vec<Candidate> {
    let mut merged: Vec<Candidate> = Vec::with_capacity(candidates.len());
    for candidate in candidates {
        let same = merged.iter_mut().find(|other| {
            other.surface.kind() == candidate.surface.kind()
                && share_on(search, &candidate.support, other) >= SAME
                && share_on(search, &other.support, &candidate) >= SAME
        });
        match same {
            // The larger patch determines the surface better.
            Some(other) => {
                other.support.extend(&candidate.support);
                other.support.sort_unstable();
                other.support.dedup();
            }
            None => merged.push(candidate),
        }
    }
    merged
}

/// Share of the points (a sample of them) that lie on a surface.
fn share_on(search: &Search<'_>, points: &[u32], other: &Candidate) -> f64 {
    let stride = points.len().div_ceil(64).max(1);
    let (mut on, mut all) = (0u32, 0u32);
    for &index in points.iter().step_by(stride) {
        all += 1;
        let distance = other.surface.distance(search.point(index));
        on += u32::from(distance <= 2.0 * search.scale.tolerance);
    }
    f64::from(on) / f64::from(all.max(1))
}

/// A point is interior to a patch when its eight nearest neighbours belong to it as well.
fn drop_explained(search: &Search<'_>, candidates: Vec<Candidate>) -> Vec<Candidate> {
    // How many patches each point is interior to.
    let mut interior = vec![0u32; search.cloud.len()];
    let insides: Vec<Vec<u32>> = candidates
        .iter()
        .map(|candidate| {
            let member = membership(search.cloud.len(), candidate);
            let inside = |&i: &u32| {
                search
                    .graph
                    .of(i)
                    .iter()
                    .take(8)
                    .all(|&j| member[j as usize])
            };
            candidate.support.iter().copied().filter(inside).collect()
        })
        .collect();
    for &index in insides.iter().flatten() {
        interior[index as usize] += 1;
    }
    let mut kept = vec![true; candidates.len()];
    for (place, candidate) in candidates.iter().enumerate().rev() {
        let own: Vec<u32> = insides[place].clone();
        let mut of_others = 0;
        for &index in &candidate.support {
            let here = u32::from(own.binary_search(&index).is_ok());
            of_others += usize::from(interior[index as usize] > here);
        }
        if of_others as f64 > EXPLAINED * candidate.support.len() as f64 {
            kept[place] = false;
            for &index in &own {
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
