//! Halves: a curved face that was drawn in two, an offset apart that nobody sees, is one primitive.
//! The two arcs of a bend, one a hair above the other, are two tori to a tolerance that follows the
//! precision of their points, and one to the eye and to the benchmark. Planes a hair apart are left
//! alone: they are the two sides of a foil.

use super::super::least_squares::{self, Loss};
use super::super::search::Search;
use super::patches::Patch;
use crate::disjoint::DisjointSets;
use crate::surface::SurfaceType;

/// How far from a surface its other half may lie, in diameters of the cloud.
const HAIR: f64 = 5.6e-4;
/// Points that two halves share at least, along their seam.
const SEAM: usize = 3;

/// Joins curved patches of one type that share a seam and lie within a hair of each other's surface.
/// Their surface is fitted to the points of all. Noise has no hair to speak of: there nothing is
/// joined.
pub fn join_halves(search: &Search<'_>, patches: Vec<Patch>) -> Vec<Patch> {
    if !search.scale.is_clean() {
        return patches;
    }
    let mut sets = DisjointSets::new(patches.len());
    for (i, first) in patches.iter().enumerate() {
        for (j, second) in patches.iter().enumerate().skip(i + 1) {
            if are_halves(search, first, second) {
                sets.join(i, j);
            }
        }
    }
    sets.groups(patches)
        .into_iter()
        .filter_map(|halves| joined(search, halves))
        .collect()
}

fn are_halves(search: &Search<'_>, first: &Patch, second: &Patch) -> bool {
    let is_near = |a: &Patch, b: &Patch| {
        let hair = HAIR * search.scale.diameter;
        let mut distances = b
            .points
            .iter()
            .map(|&i| a.surface.distance(search.point(i)));
        distances.all(|distance| distance <= hair)
    };
    let shared = |a: &Patch, b: &Patch| {
        let shared = a
            .points
            .iter()
            .filter(|i| b.points.binary_search(i).is_ok());
        shared.count()
    };
    let kind = first.surface.kind();
    kind != SurfaceType::Plane
        && kind == second.surface.kind()
        && is_near(first, second)
        && is_near(second, first)
        && shared(first, second) >= SEAM
}

/// One patch of the points of several.
fn joined(search: &Search<'_>, mut halves: Vec<Patch>) -> Option<Patch> {
    if halves.len() == 1 {
        return halves.pop();
    }
    let largest = halves.iter().max_by_key(|half| half.points.len())?.surface;
    let mut points: Vec<u32> = halves.into_iter().flat_map(|half| half.points).collect();
    points.sort_unstable();
    points.dedup();
    let fitted = least_squares::fit(&largest, &search.points(&points), Loss::Squares);
    Some(Patch {
        surface: fitted.map_or(largest, |fitted| fitted.surface),
        points,
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::{Method, Parameters, fit};
    use super::*;
    use crate::cloud::{Cloud, Point};
    use crate::model::Primitive;
    use std::f64::consts::TAU;

    /// A ring of radius 20 with a tube of radius 5 whose upper half sits `offset` above the lower.
    fn ring(offset: f64) -> Vec<Primitive> {
        let half = |from: i32, centre: f64| {
            (from..=from + 14).flat_map(move |j| {
                let (height, width) = (TAU * f64::from(j) / 28.0).sin_cos();
                (0..120).map(move |i| {
                    let (sine, cosine) = (TAU * f64::from(i) / 120.0).sin_cos();
                    let reach = 20.0 + 5.0 * width;
                    Point::new(reach * cosine, reach * sine, centre + 5.0 * height)
                })
            })
        };
        let cloud = Cloud::new(half(14, 0.0).chain(half(0, offset)).collect());
        let found = fit(&cloud, Method::Hough, &Parameters::default(), 1, &mut ());
        found.unwrap().segmentation.primitives
    }

    #[test]
    fn a_ring_drawn_in_halves_a_hair_apart_is_one_torus() {
        let found = ring(0.01);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].kind, Some(SurfaceType::Torus));
        assert_eq!(found[0].points.len(), 2 * 15 * 120);
    }

    #[test]
    fn halves_that_can_be_told_apart_are_two() {
        // The strips between their rims are cylinders.
        let tori: Vec<Primitive> = ring(0.2)
            .into_iter()
            .filter(|p| p.kind == Some(SurfaceType::Torus))
            .collect();
        let sizes: Vec<usize> = tori.iter().map(|p| p.points.len()).collect();
        assert_eq!(sizes, [15 * 120; 2]);
    }
}
