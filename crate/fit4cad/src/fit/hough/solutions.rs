//! Local solutions: what a small neighbourhood votes for.

use super::vote::Vote;
use crate::cloud::Point;
use crate::cloud::normals::Spread;
use crate::fit::Search;
use crate::fit::least_squares::degrees_of_freedom;
use crate::fit::local;
use crate::surface::{Plane, Surface, SurfaceType};

/// Points beyond its degrees of freedom that must agree with a local solution: with fewer, points
/// on two faces and their edge find something that passes through all of them.
const SPARE: usize = 3;

/// Neighbours, besides the point itself, that a flat neighbourhood must have.
const FLAT: usize = 10;

/// The vote of a point whose nearest neighbours all lie in one plane. O(1).
pub fn flat_vote(search: &Search<'_>, index: u32) -> Option<Vote> {
    let patch = nearest(search, index, FLAT);
    let spread = Spread::of(patch.iter())?;
    let plane = Plane::new(spread.centroid, spread.normal().into_inner());
    let surface = Surface::Plane(plane);
    let flat = patch
        .iter()
        .all(|p| surface.distance(p) <= search.scale.tolerance);
    // Points on a line are in every plane through it.
    let broad = spread.variances[1] > 0.01 * spread.variances[2];
    (flat && broad).then(|| Vote {
        surface,
        point: index,
        foot: *search.point(index),
    })
}

fn nearest(search: &Search<'_>, index: u32, count: usize) -> Vec<Point> {
    let mut patch = Vec::with_capacity(count + 1);
    patch.push(*search.point(index));
    let neighbours = search.graph.of(index).iter().take(count);
    patch.extend(neighbours.map(|&neighbour| *search.point(neighbour)));
    patch
}

/// The votes of a neighbourhood: of each family the surface that most of its points agree with;
/// families that see fewer points than another drop out, and as soon as one sees them all no more
/// complicated one is asked.
pub fn votes(search: &Search<'_>, index: u32, patch: &[u32], found: &mut Vec<Vote>) {
    let points = search.points(patch);
    let mut best: Vec<(usize, Surface)> = Vec::new();
    for kind in [
        SurfaceType::Plane,
        SurfaceType::Sphere,
        SurfaceType::Cylinder,
        SurfaceType::Cone,
        SurfaceType::Torus,
    ] {
        let needed = (degrees_of_freedom(kind) + SPARE).max(points.len() / 2);
        let most = local::starts(kind, &points)
            .iter()
            .filter_map(|start| local::polish(start, &points, search.scale.tolerance, needed))
            .filter(|(surface, _)| search.is_plausible(surface))
            .map(|(surface, agreeing)| (agreeing.len(), surface))
            .max_by_key(|(count, _)| *count);
        let Some((count, surface)) = most else {
            continue;
        };
        best.push((count, surface));
        if count == points.len() {
            break;
        }
    }
    let most = best.iter().map(|(count, _)| *count).max().unwrap_or(0);
    found.extend(
        best.into_iter()
            .filter(|(count, _)| count + 1 >= most)
            .map(|(_, surface)| Vote {
                surface,
                point: index,
                foot: *search.point(index),
            }),
    );
}
