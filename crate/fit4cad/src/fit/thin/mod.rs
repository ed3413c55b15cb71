//! Thin faces: faces that show few points inside or none, such as fillets of three rulings, chamfers
//! and countersinks. No neighbourhood of theirs alone tells what they are; the faces beside them do.
//!
//! ```text
//! axis, plan             the half-plane of a known axis, and the plane across a direction
//! profile, curve         faces as curves of these planes
//! chains                 places → the order in which a curve runs through them
//! coaxial, swept         surfaces through few points, about or along what is known beside them
//! rows                   what the rows of points on a thin face prove
//! recurring              directions that much of the cloud has in common
//! borders                where accepted surfaces end and nothing yet begins
//! scattered              thin faces of points that are in no rows
//! ```
//!
//! Every fitter shares these; they differ in how they choose among the surfaces proposed.

pub mod axis;
pub mod borders;
pub mod chains;
pub mod coaxial;
pub mod curve;
pub mod plan;
pub mod profile;
pub mod recurring;
pub mod rows;
mod scatter;
pub mod scattered;
pub mod swept;

use super::Search;
use super::pure::pure;
use crate::cloud::Direction;
use crate::surface::{Surface, SurfaceType};
use axis::known_axes;
use borders::Borders;

/// Free points of the neighbourhoods that surfaces are proposed for.
pub const SIZES: [usize; 3] = [10, 16, 28];
/// Passes over the open borders: what one settles may be the border of a next.
pub const PASSES: usize = 3;
/// Most directions of the whole cloud along which thin faces are sought everywhere.
pub const RECURRING: usize = 6;
/// Share of the points of the most frequent direction that makes one recurring.
pub const SHARE: f64 = 0.02;
/// Radius within which a neighbourhood lies, in spacings.
const REACH: f64 = 4.0;

/// Proposes surfaces for thin faces, pass after pass.
#[derive(Debug, Clone, Default)]
pub struct Proposer {
    /// Directions along which faces of the cloud are extruded, wherever they are.
    pub directions: Vec<Direction>,
    /// How many surfaces had been accepted when neighbourhoods of each size were looked at last.
    looked: [Option<usize>; SIZES.len()],
}

impl Proposer {
    /// Surfaces through neighbourhoods of free points, those on open borders and on no surface, of
    /// one of the [`SIZES`], each with the point in the middle of its neighbourhood. O(free points).
    ///
    /// Where no surface has been accepted since the last call for the size, nothing is new, and
    /// nothing is proposed: clouds with large free-form regions have thousands of free points.
    pub fn proposals(
        &mut self,
        search: &Search<'_>,
        borders: &Borders,
        size: usize,
    ) -> Vec<(u32, Surface)> {
        let axes = known_axes(search);
        let before = self.looked[size].replace(search.accepted().len());
        let is_old = |points: &[u32]| before.is_some_and(|before| !borders.is_new(points, before));
        let radius = REACH * search.scale.spacing;
        let mut proposals = Vec::new();
        let mut near = Vec::new();
        let seeds = (0..search.cloud.len() as u32).filter(|&index| borders.is_free(index));
        for seed in seeds {
            if is_old(search.graph.of(seed)) {
                continue;
            }
            let mut propose = |surface| proposals.push((seed, surface));
            let is_free = |index| borders.is_free(index);
            let point = search.point(seed);
            search
                .tree
                .nearest(point, SIZES[size], radius, is_free, &mut near);
            let patch: Vec<u32> = near.iter().map(|neighbour| neighbour.index).collect();
            if !search.is_explained(seed) && size == 0 {
                // A few points may be all that a small face has of its own.
                let around = search.graph.of(seed).iter().copied();
                let around: Vec<u32> = std::iter::once(seed).chain(around).collect();
                if around.iter().any(|&i| search.is_explained(i)) {
                    swept::swept(search, &self.directions, &around)
                        .into_iter()
                        .for_each(&mut propose);
                }
            }
            // Away from all borders nothing is new since the passes before.
            if patch.len() < 6 || !patch.iter().any(|&i| search.is_explained(i)) {
                continue;
            }
            let rings = coaxial::rings(search, borders, &axes, &patch);
            let swept = swept::swept(search, &self.directions, &patch);
            if rings.is_empty()
                && swept.is_empty()
                && let Some(surface) = pure(search, &patch)
            {
                // Two rows of border points are in a plane and in any number of quadrics.
                let inside = patch.iter().filter(|&&i| !search.is_explained(i)).count();
                if 10 * inside >= patch.len() || surface.kind() == SurfaceType::Plane {
                    propose(surface);
                }
            }
            rings.into_iter().chain(swept).for_each(propose);
        }
        proposals
    }
}
