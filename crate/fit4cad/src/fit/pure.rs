//! The surface of a small neighbourhood that lies within one face. Such neighbourhoods cannot be
//! wrong about their family, as those that reach over edges can.

use super::Search;
use super::least_squares::{self, Loss};
use super::local;
use super::quadric::Quadric;
use crate::cloud::Point;
use crate::cloud::normals::Spread;
use crate::surface::{Plane, Surface, SurfaceType};

/// Tolerances from the surface that a few steps of polishing must come within: those towards a true
/// surface end far below one.
const HOPELESS: f64 = 4.0;

/// The plane through all points of a patch, unless they lie on a line, which is in many.
pub fn flat(patch: &[Point], tolerance: f64) -> Option<Surface> {
    let spread = Spread::of(patch.iter())?;
    let plane = Plane::new(spread.centroid, spread.normal().into_inner());
    let surface = Surface::Plane(plane);
    let broad = spread.variances[1] > 0.01 * spread.variances[2];
    (broad && agrees(&surface, patch, tolerance)).then_some(surface)
}

/// Whether all points of a patch lie on a surface.
pub fn agrees(surface: &Surface, patch: &[Point], tolerance: f64) -> bool {
    patch
        .iter()
        .all(|point| surface.distance(point) <= tolerance)
}

/// The simplest of plane, sphere, cylinder and cone that passes through all points of a
/// neighbourhood. One eigenvalue problem rules most neighbourhoods of other surfaces out.
pub fn pure(search: &Search<'_>, patch: &[u32]) -> Option<Surface> {
    let points = search.points(patch);
    let tolerance = search.scale.tolerance;
    if let Some(plane) = flat(&points, tolerance) {
        return Some(plane);
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
    sphere()
        .and_then(polished)
        .or_else(|| quadric.cylinder().map(Surface::Cylinder).and_then(polished))
        .or_else(|| bent().map(Surface::Cylinder).and_then(polished))
        .or_else(|| quadric.cone().map(Surface::Cone).and_then(polished))
        .or_else(|| {
            let cone = least_squares::fit_cone_near(&bent()?, &points, Loss::Squares)?;
            polished(cone.surface)
        })
}
