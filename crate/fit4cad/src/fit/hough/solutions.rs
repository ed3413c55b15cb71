//! Local solutions: what a small neighbourhood votes for.

use super::vote::Vote;
use crate::cloud::Point;
use crate::cloud::normals::Spread;
use crate::fit::Search;
use crate::fit::least_squares::{self, Loss, degrees_of_freedom};
use crate::fit::local;
use crate::fit::quadric::Quadric;
use crate::surface::{Plane, Surface, SurfaceType};

/// Points beyond its degrees of freedom that must agree with a local solution: with fewer, points
/// on two faces and their edge find something that passes through all of them.
const SPARE: usize = 3;

/// Tolerances from the surface that a few steps of polishing must come within: those towards a true
/// surface end far below one.
const HOPELESS: f64 = 4.0;

/// Neighbours, besides the point itself, that a flat neighbourhood must have.
const FLAT: usize = 10;

/// The vote of a point whose nearest neighbours all lie in one plane. O(1).
pub fn flat_vote(search: &Search<'_>, index: u32) -> Option<Vote> {
    let mut patch = Vec::with_capacity(FLAT + 1);
    patch.push(*search.point(index));
    let neighbours = search.graph.of(index).iter().take(FLAT);
    patch.extend(neighbours.map(|&neighbour| *search.point(neighbour)));
    let plane = flat(&patch, search.scale.tolerance)?;
    Some(vote(search, index, plane))
}

/// The plane through all points of a patch, unless they lie on a line, which is in many.
fn flat(patch: &[Point], tolerance: f64) -> Option<Surface> {
    let spread = Spread::of(patch.iter())?;
    let plane = Plane::new(spread.centroid, spread.normal().into_inner());
    let surface = Surface::Plane(plane);
    let broad = spread.variances[1] > 0.01 * spread.variances[2];
    (broad && agrees(&surface, patch, tolerance)).then_some(surface)
}

fn agrees(surface: &Surface, patch: &[Point], tolerance: f64) -> bool {
    patch
        .iter()
        .all(|point| surface.distance(point) <= tolerance)
}

/// A vote for a surface by the neighbourhood of a point.
pub fn vote(search: &Search<'_>, index: u32, surface: Surface) -> Vote {
    Vote {
        surface,
        point: index,
        foot: *search.point(index),
    }
}

/// The vote of a neighbourhood all of whose points lie on one quadric: the simplest of plane,
/// sphere, cylinder and cone that passes through all of them. One eigenvalue problem rules most
/// other neighbourhoods out.
pub fn pure_vote(search: &Search<'_>, index: u32, patch: &[u32]) -> Option<Vote> {
    let points = search.points(patch);
    let tolerance = search.scale.tolerance;
    if let Some(plane) = flat(&points, tolerance) {
        return Some(vote(search, index, plane));
    }
    let quadric = Quadric::of(&points)?;
    if quadric.error > 2.0 * tolerance {
        return None;
    }
    let bent = || match local::starts(SurfaceType::Cylinder, &points).pop() {
        Some(Surface::Cylinder(cylinder)) => Some(cylinder),
        _ => None,
    };
    let polished = |start: Surface| -> Option<Surface> {
        // Most starts on a free-form region are hopeless, which a few steps show.
        let near = least_squares::approximate(&start, &points, Loss::Squares)?;
        if near.error > HOPELESS * tolerance {
            return None;
        }
        let fitted = least_squares::fit(&near.surface, &points, Loss::Squares)?.surface;
        let good = search.is_plausible(&fitted) && agrees(&fitted, &points, tolerance);
        good.then_some(fitted)
    };
    let sphere = || local::starts(SurfaceType::Sphere, &points).pop();
    let surface = sphere()
        .and_then(polished)
        .or_else(|| quadric.cylinder().map(Surface::Cylinder).and_then(polished))
        .or_else(|| bent().map(Surface::Cylinder).and_then(polished))
        .or_else(|| quadric.cone().map(Surface::Cone).and_then(polished))
        .or_else(|| {
            let cone = least_squares::fit_cone_near(&bent()?, &points, Loss::Squares)?;
            polished(cone.surface)
        })?;
    Some(vote(search, index, surface))
}

/// The votes of a neighbourhood that may reach over edges: of each family the surface that most of
/// its points agree with, as long as no other family sees more than `slack` points more.
pub fn mixed_votes(
    search: &Search<'_>,
    index: u32,
    patch: &[u32],
    kinds: &[SurfaceType],
    slack: usize,
    found: &mut Vec<Vote>,
) {
    let points = search.points(patch);
    let mut best: Vec<(usize, Surface)> = Vec::new();
    for &kind in kinds {
        let needed = (degrees_of_freedom(kind) + SPARE).max(points.len() / 2);
        let most = local::starts(kind, &points)
            .iter()
            .filter_map(|start| local::polish(start, &points, search.scale.tolerance, needed))
            .filter(|(surface, _)| search.is_plausible(surface))
            .map(|(surface, agreeing)| (agreeing.len(), surface))
            .max_by_key(|(count, _)| *count);
        best.extend(most);
    }
    let most = best.iter().map(|(count, _)| *count).max().unwrap_or(0);
    let voted = best.into_iter().filter(|(count, _)| count + slack >= most);
    found.extend(voted.map(|(_, surface)| vote(search, index, surface)));
}
