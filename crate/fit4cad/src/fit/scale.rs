//! The scale of a cloud: extent, spacing, noise, and how near a surface a point must lie.

mod noise;

use super::quantile::quantile;
use crate::cloud::neighbours::{KdTree, Neighbourhoods};
use crate::cloud::{Ball, Cloud, Point};

/// Lengths that everything else is relative to, in the units of the cloud. None changes when the
/// cloud is turned: a box along the axes would.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Diameter of the ball about the centroid.
    pub diameter: f64,
    /// Median distance of a point to its nearest neighbour.
    pub spacing: f64,
    /// Standard deviation σ of the points off their surfaces.
    pub noise: f64,
    /// Farthest a point may lie from a surface and still be on it.
    pub tolerance: f64,
    /// Step to which the coordinates of the points were rounded, so that they are off their surfaces; 0 where
    /// they were not.
    pub step: f64,
}

/// Least noise, in diameters. The benchmark's points lie on their surfaces to 1e-7 of the diameter or
/// better; up to this nothing changes, and accidents within it are rare.
const FLOOR: f64 = 7.5e-7;
/// Tolerance in standard deviations where the noise is small against the spacing: of Gaussian points
/// less than one in ten thousand lies beyond it, so that a face is found whole.
const SIGMAS: f64 = 4.0;
/// Tolerance, in spacings, up to which a handful of points on one surface are no accident.
const CLEAN: f64 = 0.1;
/// And up to which rows of points one spacing apart are told from each other and from a curve.
const ROWS: f64 = 0.01;
/// Tolerance in standard deviations where it is more, so that a wider one would take in points of other
/// faces: one in sixty lies beyond it.
const NOISY_SIGMAS: f64 = 2.4;

/// Error of a small face, in standard deviations: that of nine points exceeds it in one of a thousand.
const CHANCE: f64 = 1.5;
/// Distance from a surface, in diameters, at which it fades out: far below the rise of a fillet over a
/// spacing, far above the error of any clean cloud.
const FADE: f64 = 4e-5;
/// And in tolerances, where there is noise.
const FADING: f64 = 2.0;

/// Logarithm of the chance that a surface is an accident.
const ACCIDENT: f64 = -18.0;
/// [`Scale::redundancy`] where points are exact.
const EXACT_SPARE: usize = 3;

impl Scale {
    /// Measures a cloud with its tree and neighbours. `tolerance` in diagonals of the bounding box overrides the estimate where it
    /// is positive.
    pub fn measure(cloud: &Cloud, tree: &KdTree, graph: &Neighbourhoods, tolerance: f64) -> Self {
        let diameter = Ball::of(cloud.points()).diameter();
        let spacing = spacing(cloud.points(), graph);
        let (noise, step) = noise::noise(cloud.points(), tree, graph, spacing, FLOOR * diameter);
        Self {
            diameter,
            spacing,
            noise,
            tolerance: if tolerance > 0.0 {
                tolerance * cloud.bounds().diagonal()
            } else {
                enough_for(noise, spacing)
            },
            step,
        }
    }

    /// The scale of a cloud whose noise is told, before anything is searched; `tolerance` as in [`Scale::measure`]. A step that its
    /// coordinates were seen to be rounded to stays where rounding makes most of such noise.
    pub fn told(self, noise: f64, tolerance: f64) -> Self {
        let noise = noise.max(FLOOR * self.diameter);
        Self {
            noise,
            tolerance: if tolerance > 0.0 {
                self.tolerance
            } else {
                enough_for(noise, self.spacing)
            },
            step: if noise * noise < self.step * self.step / 6.0 {
                self.step
            } else {
                0.0
            },
            ..self
        }
    }

    /// The scale where the noise is known better; `tolerance` as in [`Scale::measure`]: where one was given the noise follows
    /// from it, unless that was told too.
    pub fn with_noise(self, noise: f64, tolerance: f64, is_told: bool) -> Self {
        if tolerance > 0.0 {
            let noise = if is_told {
                noise
            } else {
                self.tolerance / NOISY_SIGMAS
            };
            return Self { noise, ..self };
        }
        Self {
            noise,
            tolerance: NOISY_SIGMAS * noise,
            ..self
        }
    }

    /// Largest root mean square error of a face, where that of a cloud without noise is a share of the
    /// tolerance: an accidental fit fills the tolerance, and the points of a true face have the noise.
    pub fn largest_error(&self, share: f64) -> f64 {
        let exact = share * self.tolerance;
        if self.has_noise() {
            exact.max(CHANCE * self.noise)
        } else {
            exact
        }
    }

    /// Whether the points are measurably off their surfaces.
    pub fn has_noise(&self) -> bool {
        self.noise > FLOOR * self.diameter
    }

    /// Farthest that points just outside a patch may lie from its surface to say that it fades out.
    pub fn fade(&self) -> f64 {
        (FADE * self.diameter).max(FADING * self.tolerance)
    }

    /// Points beyond the degrees of freedom of a surface that show it to be no accident.
    ///
    /// A point of another surface is within the tolerance of this one with a chance p of about the
    /// share of the spacing that the tolerance takes up on both sides; the chance of n such points,
    /// pⁿ, is to be below a bound. Three do where points are exact.
    pub fn redundancy(&self) -> usize {
        if !self.has_noise() {
            return EXACT_SPARE;
        }
        let share = (2.0 * self.tolerance / self.spacing).clamp(1e-9, 0.5);
        // A small number: the logarithm is at least that of two.
        (ACCIDENT / libm::log(share)).ceil() as usize
    }

    /// Whether faces without an inside can be told: rows of points are distinct only where the
    /// tolerance is far below their distance.
    pub fn shows_rows(&self) -> bool {
        self.tolerance < ROWS * self.spacing
    }

    /// Whether the points are so exact that a handful of them on one surface is no accident.
    pub fn is_clean(&self) -> bool {
        self.tolerance < CLEAN * self.spacing
    }
}

/// The tolerance that goes with some noise.
fn enough_for(noise: f64, spacing: f64) -> f64 {
    (SIGMAS * noise).min((NOISY_SIGMAS * noise).max(CLEAN * spacing))
}

/// Median distance to the nearest neighbour, points that coincide left out.
fn spacing(points: &[Point], graph: &Neighbourhoods) -> f64 {
    let mut distances: Vec<f64> = (0u32..)
        .zip(points)
        .filter_map(|(index, point)| {
            let neighbours = graph.of(index).iter();
            neighbours
                .map(|&j| (points[j as usize] - point).norm())
                .find(|&d| d > 0.0)
        })
        .collect();
    quantile(&mut distances, 0.5)
}

#[cfg(test)]
mod tests;
