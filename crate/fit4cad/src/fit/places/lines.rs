//! Scan lines: points far nearer each other along lines than the lines are to each other.
//!
//! The nearest neighbours of a point are then those before and behind it on its line. They span no surface, no
//! graph of them leads to the next line, and distances along a line say nothing of how finely the surface is
//! sampled. So of such a cloud only so many points are kept as make it as fine along its lines as it is across.

use super::{AROUND, LOOKED_AT};
use crate::cloud::neighbours::KdTree;
use crate::cloud::{Point, Vector};
use crate::fit::quantile::quantile;

/// Sine of the angle to the line from which on a neighbour is beside it.
const BESIDE: f64 = 0.35;
/// Neighbours on its own line that a point has before the first beside it, from which on points are left out: of
/// lines four times as far apart as their points. Up to there the nearest sixteen are on the next lines too. On a foil
/// only one comes before, the nearest on the other side.
const ALONG: usize = 7;
/// Points nearer each other than this share of the distance of the lines are left out, so that none of the next
/// line is.
const CLOSER: f64 = 0.7;

/// The distance that parts the points along scan lines so that they are as far apart as the lines, where most points
/// are on such lines.
pub(super) fn reach_along_lines(points: &[Point], tree: &KdTree) -> Option<f64> {
    let stride = points.len().div_ceil(LOOKED_AT).max(1);
    let looked_at = points.iter().step_by(stride);
    let count = looked_at.len();
    let mut found = Vec::new();
    let mut reaches: Vec<f64> = looked_at
        .filter_map(|point| {
            // The nearest of all is the point itself.
            tree.nearest(point, AROUND + 1, f64::INFINITY, |_| true, &mut found);
            let ways = found.iter().skip(1);
            let ways: Vec<Vector> = ways.map(|it| points[it.index as usize] - point).collect();
            let along = ways.first()?.try_normalize(0.0)?;
            let is_beside = |way: &Vector| way.cross(&along).norm() > BESIDE * way.norm();
            let first = ways.iter().position(is_beside)?;
            (first >= ALONG).then(|| ways[first].norm())
        })
        .collect();
    (2 * reaches.len() > count).then(|| CLOSER * quantile(&mut reaches, 0.5))
}
