//! The profiles along one direction, and what is known of them.

use super::face::Face;
use super::rulings::{Ruling, rulings};
use crate::cloud::Direction;
use crate::fit::thin::chains::{Chain, chains};
use crate::fit::thin::plan::Plan;
use crate::fit::thin::profile::Place;
use crate::fit::{Candidate, Search};
use crate::surface::Surface;

/// Longest step from one ruling of a profile to the next, in spacings.
const REACH: f64 = 6.0;
/// Sine of the angle below which two directions are one.
const SAME: f64 = 1e-4;
/// Share of a surface's points on rulings from which on it has nothing else.
const ROWS_ONLY: f64 = 0.9;

/// The profiles of a cloud along a direction.
pub struct Section {
    pub(super) plan: Plan,
    pub(super) rulings: Vec<Ruling>,
    /// The ruling of each point of the cloud.
    ruling: Vec<u32>,
    /// How many sides of each ruling belong to accepted faces that are more than rulings: none, one
    /// where such a face ends, two within.
    pub(super) known: Vec<u8>,
    /// The accepted faces that end at each ruling, by their positions.
    beside: Vec<Vec<usize>>,
    /// How many accepted faces each point of the cloud is on.
    pub(super) held: Vec<u8>,
    /// Whether each point of the cloud is on an accepted face across the rulings.
    pub(super) across: Vec<bool>,
    pub(super) chains: Vec<Chain>,
}

impl Section {
    /// Looks for rulings along a direction. O(n log n).
    pub fn of(search: &Search<'_>, direction: Direction) -> Self {
        let plan = Plan::new(search.cloud.bounds().min, direction);
        let rulings = rulings(search, &plan);
        let mut ruling = vec![u32::MAX; search.cloud.len()];
        for (number, row) in (0u32..).zip(&rulings) {
            for &index in &row.points {
                ruling[index as usize] = number;
            }
        }
        Self {
            plan,
            known: vec![0; rulings.len()],
            beside: vec![Vec::new(); rulings.len()],
            rulings,
            ruling,
            held: vec![0; search.cloud.len()],
            across: vec![false; search.cloud.len()],
            chains: Vec::new(),
        }
    }

    /// How many points are on rulings.
    pub fn size(&self) -> usize {
        self.rulings.iter().map(|row| row.points.len()).sum()
    }

    /// Links the rulings of which something is still to be told.
    pub fn link(&mut self, search: &Search<'_>, told: &[bool]) {
        self.look_up(search, told);
        let capacity: Vec<u8> = self.known.iter().map(|&known| 2 - known.min(2)).collect();
        let reach = REACH * search.scale.spacing;
        // A face does not go on in its own plane beyond its border, across a slot for instance.
        let allows = |from: usize, to: usize| {
            let to = self.plan.point(self.rulings[to].place);
            self.beside[from]
                .iter()
                .all(|&face| search.accepted()[face].surface.distance(&to) > search.scale.tolerance)
        };
        let places: Vec<Place> = self.rulings.iter().map(|it| it.place).collect();
        let beside = |a: usize, b: usize| self.rulings[a].is_beside(&self.rulings[b]);
        self.chains = chains(&places, &capacity, reach, beside, allows);
    }

    /// Whether a surface is extruded along the direction.
    pub(super) fn is_along(&self, surface: &Surface) -> bool {
        match surface {
            Surface::Plane(plane) => plane.normal.dot(&self.plan.direction).abs() < SAME,
            Surface::Cylinder(cylinder) => cylinder.axis.cross(&self.plan.direction).norm() < SAME,
            _ => false,
        }
    }

    /// How many points of a candidate are on each ruling that has any.
    pub(super) fn rows(&self, candidate: &Candidate) -> Vec<(usize, usize)> {
        let mut rows: Vec<u32> = candidate
            .support
            .iter()
            .map(|&index| self.ruling[index as usize])
            .filter(|&row| row != u32::MAX)
            .collect();
        rows.sort_unstable();
        rows.chunk_by(|a, b| a == b)
            .map(|run| (run[0] as usize, run.len()))
            .collect()
    }

    /// Whether all of a candidate is rulings.
    pub(super) fn is_rows_only(candidate: &Candidate, rows: &[(usize, usize)]) -> bool {
        let on: usize = rows.iter().map(|(_, count)| count).sum();
        on as f64 >= ROWS_ONLY * candidate.support.len() as f64
    }

    /// Finds what is known at each ruling.
    fn look_up(&mut self, search: &Search<'_>, told: &[bool]) {
        // How many sides of each point are explained.
        let mut sides: Vec<u8> = told.iter().map(|&told| if told { 2 } else { 0 }).collect();
        for (number, candidate) in search.accepted().iter().enumerate() {
            let rows = self.rows(candidate);
            let is_along = self.is_along(&candidate.surface);
            for &index in &candidate.support {
                let held = &mut self.held[index as usize];
                *held = held.saturating_add(1);
                self.across[index as usize] |= !is_along;
            }
            if is_along && Self::is_rows_only(candidate, &rows) {
                continue;
            }
            let is_on = |index: &u32| candidate.support.binary_search(index).is_ok();
            let on_rows = |index: &&u32| self.ruling[**index as usize] != u32::MAX;
            for &index in candidate.support.iter().filter(on_rows) {
                let is_within = search.graph.of(index).iter().take(8).all(is_on);
                let side = &mut sides[index as usize];
                *side = side.saturating_add(if is_within { 2 } else { 1 });
            }
            for (row, count) in rows {
                if is_along && 2 * count > self.rulings[row].points.len() {
                    self.beside[row].push(number);
                }
            }
        }
        for (row, known) in self.rulings.iter().zip(&mut self.known) {
            let mut sides: Vec<u8> = row.points.iter().map(|&it| sides[it as usize]).collect();
            sides.sort_unstable();
            *known = sides[sides.len() / 2];
        }
    }

    /// Accepts faces and takes back what was accepted across them.
    pub fn settle(
        &self,
        search: &mut Search<'_>,
        faces: Vec<Face>,
        told: &mut [bool],
        tell: &mut dyn FnMut(&Candidate),
    ) {
        // How many sides of each ruling are explained.
        let mut sides = self.known.clone();
        let mut is_new = vec![false; self.rulings.len()];
        for face in &faces {
            for (position, &row) in face.rulings.iter().enumerate() {
                is_new[row] = true;
                let is_end = position == 0 || position + 1 == face.rulings.len();
                sides[row] = sides[row].saturating_add(if is_end { 1 } else { 2 });
            }
        }
        for (number, row) in self.rulings.iter().enumerate() {
            if !is_new[number] || sides[number] < 2 {
                continue;
            }
            // At the ends of a ruling yet other faces begin.
            let within = row.points.len().saturating_sub(1);
            for &index in row.points.get(1..within).unwrap_or_default() {
                told[index as usize] = true;
            }
        }
        let mut is_found = vec![false; faces.len()];
        let mut keep = vec![true; search.accepted().len()];
        for (place, candidate) in search.accepted().iter().enumerate() {
            if !self.is_along(&candidate.surface) {
                continue;
            }
            let rows = self.rows(candidate);
            let is_told = rows.iter().all(|&(row, _)| sides[row] >= 2);
            let same: Vec<bool> = faces
                .iter()
                .map(|face| is_same(search, candidate, &face.candidate))
                .collect();
            let is_within = |index: &&u32| {
                let mut pieces = faces.iter().zip(&same).filter(|(_, is_same)| **is_same);
                pieces.any(|(face, _)| face.candidate.support.binary_search(index).is_ok())
            };
            if is_told && Self::is_rows_only(candidate, &rows) {
                let within = candidate.support.iter().filter(is_within).count();
                if (within as f64) < ROWS_ONLY * candidate.support.len() as f64 {
                    // If it is part of one of the faces, that has its points and none across its border.
                    keep[place] = false;
                    continue;
                }
            }
            for (is_found, is_same) in is_found.iter_mut().zip(same) {
                *is_found |= is_same;
            }
        }
        search.retain(|place, _| keep[place]);
        for (face, is_found) in faces.into_iter().zip(is_found) {
            if !is_found {
                tell(&face.candidate);
                search.accept(face.candidate);
            }
        }
    }
}

/// Whether a candidate is on the surface of a face and holds nearly all of it.
fn is_same(search: &Search<'_>, candidate: &Candidate, face: &Candidate) -> bool {
    if candidate.surface.kind() != face.surface.kind() {
        return false;
    }
    let held = face.support.iter().filter(|&index| {
        candidate.support.binary_search(index).is_ok()
            && candidate.surface.distance(search.point(*index)) <= search.scale.tolerance
    });
    held.count() as f64 >= ROWS_ONLY * face.support.len() as f64
}
