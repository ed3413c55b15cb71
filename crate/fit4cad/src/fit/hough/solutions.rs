//! Local solutions: what a small neighbourhood votes for.

use super::vote::Vote;
use crate::fit::Search;
use crate::fit::least_squares::degrees_of_freedom;
use crate::fit::local::{self, SHEETS, SPARE};
use crate::fit::pure::{flat, pure};
use crate::fit::thin::curve::is_curve;
use crate::surface::{Surface, SurfaceType};

/// Neighbours, besides the point itself, that a flat neighbourhood must have.
const FLAT: usize = 10;

/// The vote of a point whose nearest neighbours all lie in one plane. O(1).
pub fn flat_vote(search: &Search<'_>, index: u32) -> Option<Vote> {
    let mut patch = Vec::with_capacity(FLAT + 1);
    patch.push(*search.point(index));
    let neighbours = search.graph.of(index).iter().take(FLAT);
    patch.extend(neighbours.map(|&neighbour| *search.point(neighbour)));
    let plane = flat(&patch, search.scale.tolerance)?;
    Some(Vote {
        surface: plane,
        point: index,
    })
}

/// The vote of a neighbourhood all of whose points lie on one simple surface. None where they are on
/// one line or circle, through which too many surfaces pass.
pub fn pure_vote(search: &Search<'_>, index: u32, patch: &[u32]) -> Option<Vote> {
    if is_curve(&search.points(patch), search.scale.tolerance) {
        return None;
    }
    let surface = pure(search, patch)?;
    Some(Vote {
        surface,
        point: index,
    })
}

/// The votes of a neighbourhood that may reach over edges: of each family the surface that most of
/// its points agree with, as long as no other family sees more than `slack` points more. None where
/// all points, being exact, are on one line or circle.
pub fn mixed_votes(
    search: &Search<'_>,
    index: u32,
    patch: &[u32],
    kinds: &[SurfaceType],
    slack: usize,
    found: &mut Vec<Vote>,
) {
    let points = search.points(patch);
    if search.scale.is_clean() && is_curve(&points, search.scale.tolerance) {
        return;
    }
    let tolerance = search.scale.tolerance;
    let strongest = |found: &mut dyn Iterator<Item = (Surface, Vec<usize>)>| {
        found
            .filter(|(surface, _)| search.is_plausible(surface))
            .map(|(surface, agreeing)| (agreeing.len(), surface))
            .max_by_key(|(count, _)| *count)
    };
    let mut best: Vec<(usize, Surface)> = Vec::new();
    for &kind in kinds {
        let needed = (degrees_of_freedom(kind) + SPARE).max(points.len() / 2);
        let starts = local::starts(kind, &points);
        let polished = |start| local::polish(start, &points, tolerance, needed);
        best.extend(strongest(&mut starts.iter().filter_map(polished)));
    }
    if best.is_empty() && search.scale.is_clean() {
        for kind in SHEETS.into_iter().filter(|kind| kinds.contains(kind)) {
            best.extend(strongest(&mut local::through_sheet(
                kind, &points, tolerance, SPARE,
            )));
        }
    }
    let most = best.iter().map(|(count, _)| *count).max().unwrap_or(0);
    let voted = best.into_iter().filter(|(count, _)| count + slack >= most);
    found.extend(voted.map(|(_, surface)| Vote {
        surface,
        point: index,
    }));
}
