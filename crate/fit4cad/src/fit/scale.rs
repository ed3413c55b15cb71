//! The scale of a cloud: extent, spacing, noise, and how near a surface a point must lie.

use super::local;
use crate::cloud::neighbours::Neighbourhoods;
use crate::cloud::{Cloud, Point};

/// Lengths that everything else is relative to, in the units of the cloud. None depends on the
/// orientation of the axes beyond what the bounding box does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Diagonal of the bounding box.
    pub diagonal: f64,
    /// Median distance of a point to its nearest neighbour.
    pub spacing: f64,
    /// Standard deviation σ of the points off their surfaces.
    pub noise: f64,
    /// Farthest a point may lie from a surface and still be on it.
    pub tolerance: f64,
}

/// Tolerance of a cloud without noise, in diagonals. The benchmark's points lie on their surfaces
/// to 1e-7 of the diagonal; between 1e-6 and 1e-5 results do not change, above they get worse.
const CLEAN: f64 = 3e-6;
/// Tolerance in standard deviations: 0.5 % of Gaussian points lie beyond it.
const SIGMAS: f64 = 2.8;
/// Local patches measured to estimate the noise.
const SAMPLES: usize = 400;

impl Scale {
    /// Measures a cloud. `tolerance` in diagonals overrides the estimate where it is positive.
    pub fn measure(cloud: &Cloud, graph: &Neighbourhoods, tolerance: f64) -> Self {
        let diagonal = cloud.bounds().diagonal();
        let spacing = spacing(cloud.points(), graph);
        let noise = noise(cloud.points(), graph);
        let estimated = (CLEAN * diagonal).max(SIGMAS * noise);
        Self {
            diagonal,
            spacing,
            noise,
            tolerance: if tolerance > 0.0 {
                tolerance * diagonal
            } else {
                estimated
            },
        }
    }

    /// Whether the points are so exact that a handful of them on one surface is no accident.
    pub fn is_clean(&self) -> bool {
        self.tolerance < 0.01 * self.spacing
    }
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

/// Standard deviation off the surfaces: the residual of the best simple surface through small
/// neighbourhoods. Edges and free-form regions have larger residuals for other reasons, so a low
/// quantile over the cloud is taken.
fn noise(points: &[Point], graph: &Neighbourhoods) -> f64 {
    let stride = points.len().div_ceil(SAMPLES).max(1);
    let mut patch = Vec::new();
    let mut residuals: Vec<f64> = (0u32..)
        .zip(points)
        .step_by(stride)
        .filter_map(|(index, point)| {
            patch.clear();
            patch.push(*point);
            patch.extend(graph.of(index).iter().map(|&j| points[j as usize]));
            local::residual(&patch)
        })
        .collect();
    quantile(&mut residuals, 0.3)
}

/// The value below which the given share of the values lie; 0 for none.
pub(crate) fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let place = ((values.len() - 1) as f64 * share.clamp(0.0, 1.0)).round() as usize;
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}
