//! From surfaces to primitives: the connected patches that remain of each surface.

use super::boundary::Boundary;
use super::grid::Grid;
use super::mesh::Mesh;
use crate::cloud::Point;
use crate::disjoint::DisjointSets;
use crate::surface::Surface;

/// A surface and the points of one connected patch of it, ascending.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    pub surface: Surface,
    pub points: Vec<u32>,
}

/// Splits the points of each surface into connected patches: two neighbours belong together if the
/// face goes on half-way between them, or a tenth of the spacing aside, for edges are curved.
/// Free-form faces make none. O(n).
pub fn patches(boundary: &Boundary, mesh: &Mesh, spacing: f64) -> Vec<Patch> {
    let mut patches = Vec::new();
    for (carrier, members) in mesh.members.iter().enumerate() {
        let mut faces = boundary.faces.iter().filter(|face| face.carrier == carrier);
        let Some(surface) = faces.next().and_then(|face| face.surface) else {
            continue;
        };
        for points in components(boundary, carrier, mesh, members, spacing) {
            patches.push(Patch { surface, points });
        }
    }
    patches
}

fn components(
    boundary: &Boundary,
    carrier: usize,
    mesh: &Mesh,
    members: &[u32],
    spacing: f64,
) -> Vec<Vec<u32>> {
    let points: Vec<Point> = members
        .iter()
        .map(|&index| mesh.points[index as usize])
        .collect();
    let faces: Vec<usize> = (0..boundary.faces.len())
        .filter(|&face| boundary.faces[face].carrier == carrier)
        .collect();
    let goes_on = |middle: &Point| {
        faces.iter().any(|&face| {
            let chart = boundary.foot(face, middle).chart;
            boundary.remains_near(&boundary.faces[face], chart, 0.1 * spacing)
        })
    };
    let mut sets = DisjointSets::new(points.len());
    let mut grid = Grid::new(2.2 * spacing);
    for (index, point) in points.iter().enumerate() {
        grid.near(point, |other| {
            if sets.root(index) != sets.root(other)
                && goes_on(&nalgebra::center(point, &points[other]))
            {
                sets.join(index, other);
            }
        });
        grid.add(*point);
    }
    sets.groups(members.iter().copied())
}
