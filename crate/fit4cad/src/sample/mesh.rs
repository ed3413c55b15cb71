//! Even points on the boundary of a part, as a surface mesher would place its vertices: corners,
//! then edges, then faces, all at about one distance.

use super::SampleError;
use super::boundary::{Boundary, Domain, EdgePoint, Face, edge_points};
use super::grid::Grid;
use crate::cloud::Point;
use crate::random::Random;

/// Points of a part and the carriers they lie on.
#[derive(Debug, Clone, Default)]
pub struct Mesh {
    pub points: Vec<Point>,
    /// For every carrier its points, ascending.
    pub members: Vec<Vec<u32>>,
}

/// Edge of the lattice of triangles over the median nearest-neighbour distance it comes to.
const LATTICE: f64 = 1.24;
/// How far a lattice point strays, over the edge of the lattice.
const STRAY: f64 = 0.2;
/// The least distance between points of one surface, over the edge of the lattice.
const APART: f64 = 0.58;

/// Places points whose median nearest-neighbour distance is about the spacing. O(n).
///
/// Each face carries rows of points, shifted by half a step from one to the next, each point
/// strayed at random; those too near an edge or another point are left out.
///
/// # Errors
/// [`SampleError::TooManyPoints`] as soon as there are more than the limit, and
/// [`SampleError::TooLarge`] where far more places than that would have to be tried.
pub fn mesh(
    boundary: &Boundary,
    spacing: f64,
    seed: u64,
    limit: usize,
) -> Result<Mesh, SampleError> {
    let step = spacing * LATTICE;
    check_places(boundary, step, limit)?;
    let mut mesh = Mesh {
        points: Vec::new(),
        members: vec![Vec::new(); boundary.carriers],
    };
    for EdgePoint { point, carriers } in edge_points(boundary, step) {
        for carrier in carriers {
            mesh.members[carrier].push(mesh.points.len() as u32);
        }
        mesh.points.push(point);
    }
    for carrier in 0..boundary.carriers {
        let edge = mesh.members[carrier]
            .iter()
            .map(|&index| mesh.points[index as usize]);
        let mut grid = Grid::new(APART * step);
        for point in edge {
            grid.add(point);
        }
        for (index, face) in boundary.faces.iter().enumerate() {
            if face.carrier != carrier {
                continue;
            }
            let mut random = Random::new(seed, index as u64);
            let mut place = |chart| {
                let point = face.point(&boundary.solids[face.solid], chart);
                if boundary.remains(face, chart) && grid.add_apart(point) {
                    mesh.members[carrier].push(mesh.points.len() as u32);
                    mesh.points.push(point);
                }
                mesh.points.len() <= limit
            };
            if !lattice(boundary, face, step, &mut random, &mut place) {
                return Err(SampleError::TooManyPoints { limit });
            }
        }
    }
    Ok(mesh)
}

/// Places tried for each point there may be: blocks that cut are tried whole, however little of them
/// borders on what is left.
const PLACES: f64 = 8.0;
/// Most lattice points along a face in either direction.
const ALONG: f64 = 1e5;

/// Refuses faces that are far larger than the part: the spacing is that of what is left of it.
fn check_places(boundary: &Boundary, step: f64, limit: usize) -> Result<(), SampleError> {
    let mut places = 0.0;
    for face in &boundary.faces {
        let solid = &boundary.solids[face.solid];
        let Domain { low, high, .. } = face.domain(solid);
        let rows = (high[0] - low[0]) / step + 1.0;
        let pace = [low[0], (low[0] + high[0]) / 2.0, high[0]]
            .map(|across| face.pace(solid, across))
            .into_iter()
            .fold(0.0, f64::max);
        let count = pace * (high[1] - low[1]) / step + 1.0;
        places += rows * count;
        let is_small = rows.max(count) <= ALONG && places <= PLACES * limit as f64;
        if !is_small {
            return Err(SampleError::TooLarge);
        }
    }
    Ok(())
}

/// Offers the strayed lattice points of a face, until one is refused.
fn lattice(
    boundary: &Boundary,
    face: &Face,
    step: f64,
    random: &mut Random,
    place: &mut impl FnMut([f64; 2]) -> bool,
) -> bool {
    let solid = &boundary.solids[face.solid];
    let Domain { low, high, closed } = face.domain(solid);
    let rows = ((high[0] - low[0]) / (step * 0.75f64.sqrt()))
        .round()
        .max(1.0);
    let last_row = rows as usize - usize::from(closed[0]);
    // On the very rim it is for the edges to say what remains.
    let rim = 1e-5 * boundary.diagonal;
    for row in 0..=last_row {
        let across = low[0] + (high[0] - low[0]) * row as f64 / rows;
        let pace = face.pace(solid, across);
        let count = (pace * (high[1] - low[1]) / step).round().max(1.0);
        let shift = if row % 2 == 1 { 0.5 } else { 0.0 };
        for k in 0..=count as usize {
            let stray = [random.signed(), random.signed()].map(|x| x * STRAY);
            let u = across + stray[0] * step;
            let v = low[1] + (high[1] - low[1]) * (k as f64 + shift + stray[1]) / count;
            let inset = [rim, rim / pace.max(rim)];
            let clamp = |k: usize, x: f64| {
                if closed[k] {
                    x
                } else {
                    x.max(low[k] + inset[k]).min(high[k] - inset[k])
                }
            };
            if !place([clamp(0, u), clamp(1, v)]) {
                return false;
            }
        }
    }
    true
}
