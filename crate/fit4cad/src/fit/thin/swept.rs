//! Surfaces of thin faces, from the directions and axes of the surfaces beside them.
//!
//! Three rulings lie on a cylinder, whatever they are, and three rings on a torus. Which of these
//! are faces, the borders tell: a face ends where its neighbours do.

use super::axis::KnownAxis;
use super::plan::Plan;
use super::profile::{self, Place};
use crate::cloud::{Direction, Point, Vector};
use crate::fit::Search;
use crate::fit::axes::axis_of;
use crate::surface::Surface;

/// Sine of the angle below which two directions are one.
const SAME: f64 = 1e-4;
/// Most surfaces beside a neighbourhood whose directions are tried.
const BESIDE: usize = 6;

/// The surfaces of a neighbourhood that are extruded along, or turned about, what the surfaces beside
/// it have in common, normals and axes, and the edges in which they meet, or along what recurs in the
/// whole cloud. O(surfaces² × points).
pub fn swept(search: &Search<'_>, recurring: &[Direction], patch: &[u32]) -> Vec<Surface> {
    let mut beside = search.surfaces_beside(patch);
    beside.truncate(BESIDE);
    let points = search.points(patch);
    let mut surfaces = Vec::new();
    for direction in directions(&beside, recurring) {
        extruded(&points, &direction, search.scale.tolerance, &mut surfaces);
    }
    let mut axes: Vec<KnownAxis> = Vec::new();
    let near = 20.0 * search.scale.tolerance;
    for axis in beside.iter().filter_map(KnownAxis::of) {
        if !axes.iter().any(|other| other.is_same(&axis, near)) {
            axes.push(axis);
        }
    }
    for axis in &axes {
        turned(&points, axis, search.scale.tolerance, &mut surfaces);
    }
    surfaces.retain(|surface| search.is_plausible(surface));
    surfaces
}

/// Directions along which a face between these surfaces may be extruded.
fn directions(beside: &[Surface], recurring: &[Direction]) -> Vec<Direction> {
    let mut found: Vec<Direction> = recurring.to_vec();
    let mut add = |direction: Vector| {
        if let Some(direction) = Direction::try_new(direction, SAME)
            && found
                .iter()
                .all(|other| other.cross(&direction).norm() >= SAME)
        {
            found.push(direction);
        }
    };
    let normals: Vec<Direction> = beside
        .iter()
        .filter_map(|surface| match surface {
            Surface::Plane(plane) => Some(plane.normal),
            _ => None,
        })
        .collect();
    for (_, axis) in beside.iter().filter_map(axis_of) {
        add(axis.into_inner());
    }
    for (j, normal) in normals.iter().enumerate() {
        add(normal.into_inner());
        for other in &normals[..j] {
            add(normal.cross(other));
        }
    }
    found
}

/// Planes and cylinders along a direction through the first of some points.
fn extruded(points: &[Point], direction: &Direction, tolerance: f64, found: &mut Vec<Surface>) {
    let Some(origin) = points.first() else {
        return;
    };
    let plan = Plan::new(*origin, *direction);
    let places: Vec<Place> = points.iter().map(|point| plan.place(point)).collect();
    let curves = profile::curves(&places, tolerance);
    found.extend(curves.iter().map(|curve| plan.surface(curve)));
}

/// Surfaces of revolution about an axis through the first of some points.
fn turned(points: &[Point], axis: &KnownAxis, tolerance: f64, found: &mut Vec<Surface>) {
    let places: Vec<Place> = points
        .iter()
        .map(|point| {
            let place = axis.profile(point);
            [place.radius, place.height]
        })
        .collect();
    let curves = profile::curves(&places, tolerance);
    found.extend(
        curves
            .into_iter()
            .map(|curve| axis.turned(&curve, tolerance)),
    );
}
