//! Whether the points of a thin face are scattered over it, or in a few rows, through which too many
//! surfaces pass.

use std::f64::consts::TAU;

use super::axis::{KnownAxis, Profile};
use super::curve::is_curve;
use crate::cloud::Point;
use crate::cloud::normals::Spread;
use crate::fit::pure;
use crate::fit::quantile::quantile;
use crate::fit::{Candidate, Search};
use crate::surface::{Surface, across};

/// Equal parts of the range of a profile that are told apart: a row of points with some wobble is in one or two.
const PARTS: usize = 20;
/// Parts with points that a profile needs: three points make a circle, and as many again are no accident.
const FILLED: usize = 6;
/// Points about each of which it is asked whether they run along a curve.
const ALONG: usize = 5;
/// Distance, in spacings, within which these are on one curve: a wire of points is smooth, and points at random
/// on a strip are off by a third of its width.
const SMOOTH: f64 = 0.02;

/// Whether the points of a candidate are scattered, so that each says something about its surface.
/// O(points²) where they are few, which those of thin faces are.
pub fn is_scattered(search: &Search<'_>, face: &Candidate) -> bool {
    let points = search.points(&face.support);
    let tolerance = search.scale.tolerance;
    if is_curve(&points, 2.0 * tolerance) {
        return false;
    }
    let is_flat = pure::flat(&points, 2.0 * tolerance).is_some();
    match &face.surface {
        Surface::Plane(_) => {
            !is_wire(&points, SMOOTH * search.scale.spacing) && !is_seam(search, face)
        }
        // A plane meets them in a curve.
        _ if is_flat => false,
        Surface::Cylinder(cylinder) => {
            let Some(axis) = KnownAxis::of(&face.surface) else {
                return false;
            };
            let angles = points.iter().map(|point| around(&axis, point));
            is_bent(angles.collect(), cylinder.radius, tolerance)
        }
        Surface::Torus(torus) => {
            let Some(axis) = KnownAxis::of(&face.surface) else {
                return false;
            };
            let middle = axis.profile(&torus.centre).height;
            let tube = points.iter().map(|point| {
                let place = axis.profile(point);
                libm::atan2(place.height - middle, place.radius - torus.major_radius)
            });
            is_bent(tube.collect(), torus.minor_radius, tolerance)
        }
        Surface::Cone(_) => {
            let Some(axis) = KnownAxis::of(&face.surface) else {
                return false;
            };
            let places: Vec<Profile> = points.iter().map(|point| axis.profile(point)).collect();
            let heights = places.iter().map(|place| place.height);
            let low = heights.clone().fold(f64::INFINITY, f64::min);
            let high = heights.clone().fold(f64::NEG_INFINITY, f64::max);
            let radius = places.iter().map(|place| place.radius).sum::<f64>();
            let angles = points.iter().map(|point| around(&axis, point));
            filled(heights.map(|height| height - low), high - low) >= FILLED
                && is_bent(angles.collect(), radius / places.len() as f64, tolerance)
        }
        Surface::Sphere(_) => true,
    }
}

/// Whether at most points one accepted surface goes on on both sides of a plane: the plane of its seam.
fn is_seam(search: &Search<'_>, plane: &Candidate) -> bool {
    let is_crossed = |&&index: &&u32| {
        let beside = search.graph.of(index).iter().filter_map(|&other| {
            let side = plane.surface.signed_distance(search.point(other));
            let holder = search.holder(other)?;
            (side.abs() > search.scale.tolerance).then_some((holder, side > 0.0))
        });
        let beside: Vec<(&Candidate, bool)> = beside.collect();
        let is_both = |&(holder, side): &(&Candidate, bool)| {
            beside
                .iter()
                .any(|&(other, above)| above != side && std::ptr::eq(holder, other))
        };
        beside.iter().any(is_both)
    };
    2 * plane.support.iter().filter(is_crossed).count() > plane.support.len()
}

/// The angle of a point about an axis.
fn around(axis: &KnownAxis, point: &Point) -> f64 {
    let first = across(&axis.direction);
    let second = axis.direction.cross(&first);
    let offset = point - axis.point;
    libm::atan2(offset.dot(&second), offset.dot(&first))
}

/// Whether places around a circle show that it is one: in enough parts of an arc so long that another smooth
/// curve, which differs in the third order, rθ³/48, would leave the tolerance.
fn is_bent(mut angles: Vec<f64>, radius: f64, tolerance: f64) -> bool {
    angles.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (angles.first(), angles.last()) else {
        return false;
    };
    // The arc begins behind the widest gap.
    let closing = (first + TAU - last, *first);
    let gaps = angles.windows(2).map(|pair| (pair[1] - pair[0], pair[1]));
    let (gap, start) = gaps.fold(
        closing,
        |widest, gap| if gap.0 > widest.0 { gap } else { widest },
    );
    let arc = TAU - gap;
    radius * arc.powi(3) / 48.0 > tolerance
        && filled(
            angles.iter().map(|angle| (angle - start).rem_euclid(TAU)),
            arc,
        ) >= FILLED
}

/// How many of the equal parts of a range hold some of the places.
fn filled(places: impl Iterator<Item = f64>, range: f64) -> usize {
    let mut holds = [false; PARTS + 1];
    for place in places {
        // Between 0 and the number of parts: places are within the range.
        let part = (place / range * PARTS as f64).clamp(0.0, PARTS as f64) as usize;
        holds[part] = true;
    }
    holds.iter().filter(|&&is| is).count()
}

/// Whether points of a plane run along smooth curves, as those on a seam or an edge do.
fn is_wire(points: &[Point], limit: f64) -> bool {
    let mut off: Vec<f64> = points
        .iter()
        .filter_map(|point| {
            let mut near: Vec<&Point> = points.iter().collect();
            near.sort_by(|a, b| {
                let [a, b] = [a, b].map(|other| (*other - point).norm_squared());
                a.total_cmp(&b)
            });
            near.truncate(ALONG);
            off_curve(&near)
        })
        .collect();
    quantile(&mut off, 0.5) < limit
}

/// Root mean square distance of a few points of a plane from the parabola along them that fits best.
fn off_curve(points: &[&Point]) -> Option<f64> {
    let spread = Spread::of(points.iter().copied())?;
    let [_, across, along] = spread.directions;
    let scale = spread.variances[2].sqrt();
    let mut matrix = nalgebra::Matrix3::zeros();
    let mut right = nalgebra::Vector3::zeros();
    let places = points.iter().map(|point| {
        let offset = (*point - spread.centroid) / scale;
        (offset.dot(&along), offset.dot(&across))
    });
    let places: Vec<(f64, f64)> = places.collect();
    for &(x, y) in &places {
        let row = nalgebra::Vector3::new(1.0, x, x * x);
        matrix += row * row.transpose();
        right += row * y;
    }
    let parabola = matrix.cholesky()?.solve(&right);
    let squares = places
        .iter()
        .map(|&(x, y)| (y - parabola[0] - parabola[1] * x - parabola[2] * x * x).powi(2));
    let spare = points.len().checked_sub(3).filter(|&spare| spare > 0)?;
    Some((squares.sum::<f64>() / spare as f64).sqrt() * scale)
}
