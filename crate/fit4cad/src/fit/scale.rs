//! The scale of a cloud: extent, spacing, noise, and how near a surface a point must lie.

use super::local;
use crate::cloud::neighbours::Neighbourhoods;
use crate::cloud::{Cloud, Point};
use crate::surface::SurfaceType;

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

/// Tolerances of clouds with no noise to speak of, in diagonals, tried in turn. The benchmark's
/// points lie on their surfaces to 1e-7 of the diagonal; between 1e-6 and 1e-5 results do not change,
/// above they get worse. The larger ones serve clouds whose coordinates were rounded.
const LEVELS: [f64; 3] = [3e-6, 1e-5, 4e-5];
/// Share of small patches with an exact surface through half their points that makes a cloud exact.
/// Noise leaves none; free-form regions, edges and thin walls leave fewer.
const EXACT_SHARE: f64 = 0.1;
/// Tolerance in standard deviations: 0.5 % of Gaussian points lie beyond it.
const SIGMAS: f64 = 2.8;
/// Local patches measured to estimate the noise.
const SAMPLES: usize = 400;

impl Scale {
    /// Measures a cloud. `tolerance` in diagonals overrides the estimate where it is positive.
    pub fn measure(cloud: &Cloud, graph: &Neighbourhoods, tolerance: f64) -> Self {
        let diagonal = cloud.bounds().diagonal();
        let spacing = spacing(cloud.points(), graph);
        let exact = LEVELS
            .into_iter()
            .map(|level| level * diagonal)
            .find(|&level| {
                let is_finest = level <= LEVELS[0] * diagonal;
                share_of_exact_patches(cloud.points(), graph, level, is_finest) >= EXACT_SHARE
            });
        let (noise, estimated) = match exact {
            Some(level) => (level / SIGMAS, level),
            None => {
                let noise = noise(cloud.points(), graph);
                (noise, SIGMAS * noise)
            }
        };
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

/// Share of sampled neighbourhoods at least half of which lie on one surface to the tolerance.
fn share_of_exact_patches(
    points: &[Point],
    graph: &Neighbourhoods,
    tolerance: f64,
    is_finest: bool,
) -> f64 {
    // Cones and tori take longer to try; at the finest level a cloud may be nothing else.
    let kinds: &[SurfaceType] = if is_finest {
        &SurfaceType::ALL
    } else {
        &[
            SurfaceType::Plane,
            SurfaceType::Cylinder,
            SurfaceType::Sphere,
        ]
    };
    let stride = points.len().div_ceil(SAMPLES / 4).max(1);
    let (mut exact, mut all) = (0u32, 0u32);
    for index in (0u32..).take(points.len()).step_by(stride) {
        let patch = patch(points, graph, index);
        all += 1;
        let is_exact = |patch: &[Point], needed: usize| {
            kinds.iter().any(|&kind| {
                local::starts(kind, patch)
                    .iter()
                    .any(|start| local::polish(start, patch, tolerance, needed).is_some())
            })
        };
        // The few nearest points are on one sheet where the sheets of a thin wall are close.
        let few = &patch[..patch.len().min(10)];
        // At the finest level noise leaves no accidents. At the others, robust fits through half a
        // patch and planes through three points find some, so all points of a patch must agree.
        let found = is_exact(few, few.len())
            || is_finest
                && (is_exact(&patch, patch.len().div_ceil(2))
                    || local::plane_through_seed(&patch, tolerance).is_some_and(|(_, on)| on >= 6));
        exact += u32::from(found);
    }
    f64::from(exact) / f64::from(all.max(1))
}

/// A point and its neighbours.
fn patch(points: &[Point], graph: &Neighbourhoods, index: u32) -> Vec<Point> {
    let neighbours = graph.of(index).iter();
    std::iter::once(index)
        .chain(neighbours.copied())
        .map(|i| points[i as usize])
        .collect()
}

/// Standard deviation off the surfaces: the residual of the best simple surface through small
/// neighbourhoods. Edges and free-form regions have larger residuals for other reasons, so a low
/// quantile over the cloud is taken.
fn noise(points: &[Point], graph: &Neighbourhoods) -> f64 {
    let stride = points.len().div_ceil(SAMPLES).max(1);
    let mut residuals: Vec<f64> = (0u32..)
        .take(points.len())
        .step_by(stride)
        .filter_map(|index| local::residual(&patch(points, graph, index)))
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

#[cfg(test)]
mod tests;
