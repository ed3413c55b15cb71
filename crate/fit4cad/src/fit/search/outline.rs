//! Where a patch ends: how sharply, and how wide it is there.

use std::f64::consts::TAU;

use super::Search;
use crate::cloud::normals::Spread;
use crate::cloud::{Direction, Point};
use crate::fit::Candidate;
use crate::surface::across;

/// Error, in tolerances, of a face of CAD: an accidental fit fills the tolerance.
pub const EXACT: f64 = 0.05;

/// The widest angle between points around a middle, seen from it along the normal; a full turn where
/// there are none.
pub fn widest_gap<'p>(
    middle: &Point,
    normal: &Direction,
    around: impl Iterator<Item = &'p Point>,
) -> f64 {
    let first = across(normal);
    let second = normal.cross(&first);
    let mut angles: Vec<f64> = around
        .map(|point| {
            let step = point - middle;
            libm::atan2(step.dot(&second), step.dot(&first))
        })
        .collect();
    angles.sort_by(f64::total_cmp);
    let Some(last) = angles.last() else {
        return TAU;
    };
    let mut before = last - TAU;
    let mut widest = 0f64;
    for &angle in &angles {
        widest = widest.max(angle - before);
        before = angle;
    }
    widest
}

impl Search<'_> {
    /// Mean number of the eight nearest neighbours of a candidate's points that are its points too:
    /// near 8 for a wide patch, 5 for two rows, 2 for a single curve.
    pub fn thickness(&mut self, candidate: &Candidate) -> f64 {
        self.marks.clear();
        for &index in &candidate.support {
            self.marks.insert(index);
        }
        let near = |&i: &u32| {
            self.graph
                .of(i)
                .iter()
                .take(8)
                .filter(|&&j| self.marks.contains(j))
        };
        let links: usize = candidate.support.iter().map(|i| near(i).count()).sum();
        links as f64 / candidate.support.len().max(1) as f64
    }

    /// Whether a patch is hardly more than a straight row of points, through which too many surfaces
    /// pass: less than a fourth of its points lie off its middle line.
    pub fn is_row(&self, candidate: &Candidate) -> bool {
        /// Distance from the middle line, in spacings.
        const BESIDE: f64 = 0.3;
        let points = self.points(&candidate.support);
        let Some(spread) = Spread::of(points.iter()) else {
            return true;
        };
        let beside = |point: &&Point| {
            let offset = *point - spread.centroid;
            offset.cross(&spread.directions[2]).norm() >= BESIDE * self.scale.spacing
        };
        4 * points.iter().filter(beside).count() < points.len()
    }

    /// The fuzzy-border test: whether the points just outside a patch nearly lie on its surface,
    /// as they do around an accidental fit, which fades out, and not around a true face, which
    /// ends sharply even where it runs on tangentially into a fillet.
    pub fn has_fuzzy_border(&mut self, candidate: &Candidate) -> bool {
        // So many exact points on one surface are no accident.
        const BEYOND_DOUBT: usize = 400;
        const GOOD: f64 = 0.2;
        // A face much more exact than an accident is none, even where the next face goes on from
        // it within the tolerance.
        let is_exact = candidate.error < EXACT * self.scale.tolerance
            || candidate.support.len() >= BEYOND_DOUBT
                && candidate.error < self.scale.largest_error(GOOD);
        if is_exact || !self.scale.is_clean() {
            return false;
        }
        let limit = self.scale.fade();
        self.marks.clear();
        for &index in &candidate.support {
            self.marks.insert(index);
        }
        let (mut outside, mut near) = (0u32, 0u32);
        for &index in &candidate.support {
            for &neighbour in self.graph.of(index).iter().take(8) {
                if self.marks.insert(neighbour) {
                    outside += 1;
                    if candidate.surface.distance(self.point(neighbour)) <= limit {
                        near += 1;
                    }
                }
            }
        }
        f64::from(near) > self.parameters.fuzzy_border * f64::from(outside)
    }
}
