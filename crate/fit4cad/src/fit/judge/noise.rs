//! How far the points of a noisy cloud lie off their surfaces, from neighbourhoods of growing size.
//!
//! A quadratic height function over a neighbourhood leaves residuals of the noise where the neighbourhood
//! is within a face, and larger ones over an edge. Those within faces agree with each other and pile up at
//! σ; those over edges differ. So σ is where most residuals are: their half-sample mode (Bickel and
//! Frühwirth 2006). A ball about a point that holds few others is as thick as it is wide: it leaves out
//! what is far off the surface, and its residuals are too small. How much, hangs on the ratio of residual
//! and radius alone.

use super::height::residual;
use crate::cloud::Point;
use crate::cloud::neighbours::KdTree;
use crate::fit::quantile::quantile;
use crate::fit::scale::Scale;

/// Points of the neighbourhoods. Smaller ones are too thick at 1 % of noise, larger ones are over
/// edges in most parts; that of three which is between the others has been right within a tenth on training
/// models, from 0.05 % to 1 % of the diagonal.
const SIZES: [usize; 3] = [27, 40, 60];
/// Neighbourhoods looked at.
const LOOKED_AT: usize = 240;
/// Neighbourhoods that tell anything together.
const FEWEST: usize = 12;
/// Ratio of the ends of a window that holds most residuals of 34 degrees of freedom.
const WINDOW: f64 = 1.35;
/// Residual, in radii of the largest neighbourhoods, from which on most of them are no sheets. Of points
/// that fill space it is about 0.42; of parts with noise as wide as the spacing, 0.25.
const THICK: f64 = 0.34;
/// Ratio of what the sizes say down to which they agree.
const STEADY: f64 = 0.7;
/// Largest part of the variance that a ball may hide.
const MOST_HIDDEN: f64 = 0.65;

/// Noise, in spacings, up to which the nearest neighbours see nearly all of it: of noise of 0.3 spacings all, of 0.75
/// they see 0.53 to 0.58, of 1.5 no more.
const SEEN: f64 = 0.5;
/// How much larger than what they see it may be, up to there.
const LARGER: f64 = 1.5;

/// Standard deviation of the points off their surfaces, in the units of the cloud; `None` where they are
/// on none that can be told: a cloud of few points, or one that fills space.
///
/// Where sizes disagree the larger neighbourhoods are over edges, and the smallest residuals are nearest. On parts that
/// are small or thin all are, and agree on what is several times the noise; there the nearest neighbours, which `scale`
/// was measured by, know better.
pub fn measure(points: &[Point], tree: &KdTree, scale: &Scale) -> Option<f64> {
    let mut piles = piles(points, tree)?;
    let least = piles.iter().copied().fold(f64::INFINITY, f64::min);
    let middle = quantile(&mut piles, 0.5);
    // Rounding moves neighbours alike: they see too little of it.
    if scale.step > 0.0 {
        return Some(middle);
    }
    let noise = if least < STEADY * middle {
        least
    } else {
        middle
    };
    let is_seen = scale.has_noise() && scale.noise <= SEEN * scale.spacing;
    let is_off = is_seen && noise > LARGER * scale.noise;
    Some(if is_off { scale.noise } else { noise })
}

/// The same where neighbourhoods of all sizes agree. What a smooth surface that is none of the five leaves grows
/// with them, by three and more.
pub fn measure_plateau(points: &[Point], tree: &KdTree) -> Option<f64> {
    let mut piles = piles(points, tree)?;
    let least = piles.iter().copied().fold(f64::INFINITY, f64::min);
    let most = piles.iter().copied().fold(0.0, f64::max);
    (least >= STEADY * most).then(|| quantile(&mut piles, 0.5))
}

/// What most neighbourhoods of each size say.
fn piles(points: &[Point], tree: &KdTree) -> Option<Vec<f64>> {
    let stride = points.len().div_ceil(LOOKED_AT).max(1);
    let mut found = Vec::new();
    let mut residuals = [const { Vec::new() }; SIZES.len()];
    let most = SIZES[SIZES.len() - 1];
    let mut thickness = Vec::new();
    for point in points.iter().step_by(stride) {
        tree.nearest(point, most, f64::INFINITY, |_| true, &mut found);
        let patch: Vec<Point> = found.iter().map(|it| points[it.index as usize]).collect();
        for (size, residuals) in SIZES.into_iter().zip(&mut residuals) {
            if let Some((patch, last)) = patch.get(..size).zip(found.get(size - 1))
                && let Some(residual) = residual(patch)
            {
                if size == most {
                    thickness.push(residual / last.distance_squared.sqrt());
                }
                residuals.push(unhidden(residual, last.distance_squared));
            }
        }
    }
    if quantile(&mut thickness, 0.5) > THICK {
        return None;
    }
    let piles = residuals.iter_mut().filter_map(|it| mode(it));
    let piles: Vec<f64> = piles.collect();
    (!piles.is_empty()).then_some(piles)
}

/// The residual that a ball of the given squared radius would leave if it hid nothing. To first order in
/// the ratio q of the squares it hides 2q of the variance: about a point at height z₀ the chance of a
/// point at height z to be inside falls as its disc does, by (z - z₀)²/r². The second order is fitted to
/// sheets of noise up to a third of the radius.
fn unhidden(residual: f64, radius_squared: f64) -> f64 {
    let ratio = residual * residual / radius_squared;
    let hidden = (2.0 * ratio + 45.0 * ratio * ratio).min(MOST_HIDDEN);
    residual / (1.0 - hidden).sqrt()
}

/// Where most values are; `None` of few.
fn mode(values: &mut [f64]) -> Option<f64> {
    if values.len() < FEWEST {
        return None;
    }
    values.sort_unstable_by(f64::total_cmp);
    let mut best = (0, 0);
    for (start, &value) in values.iter().enumerate() {
        let count = values.partition_point(|&it| it <= WINDOW * value) - start;
        if count > best.1 {
            best = (start, count);
        }
    }
    values.get(best.0 + best.1 / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Cloud;
    use crate::fit::{Parameters, Search};
    use crate::random::Random;

    /// The noise of a cloud by its own tree and scale.
    fn measured(points: &[Point]) -> Option<f64> {
        let cloud = Cloud::new(points.to_vec());
        let search = Search::new(&cloud, &Parameters::default(), 1);
        measure(points, &search.tree, &search.scale)
    }

    /// A square sheet of 4,000 points with spacing one, whose noise is given in spacings.
    fn sheet(noise: f64) -> Vec<Point> {
        let mut random = Random::new(3, 0);
        (0..4000)
            .map(|_| {
                let side = 4000f64.sqrt();
                let (x, y) = (side * random.unit(), side * random.unit());
                Point::new(x, y, 0.01 * x * y / side + noise * random.normal())
            })
            .collect()
    }

    #[test]
    fn noise_is_measured_from_a_tenth_of_the_spacing_to_its_whole() {
        for noise in [0.1, 0.3, 0.6, 1.0] {
            let points = sheet(noise);
            let found = measured(&points).unwrap();
            assert!((found / noise - 1.0).abs() < 0.12, "{noise}: {found}");
        }
    }

    #[test]
    fn where_the_nearest_neighbours_see_far_less_they_are_believed() {
        // As over a part all of whose larger neighbourhoods reach over edges.
        let cloud = Cloud::new(sheet(0.3));
        let search = Search::new(&cloud, &Parameters::default(), 1);
        let seen = |share: f64| Scale {
            noise: share * search.scale.spacing,
            ..search.scale
        };
        let measured = |scale| measure(cloud.points(), &search.tree, &scale).unwrap();
        assert_eq!(measured(seen(0.2)), seen(0.2).noise);
        assert!(measured(seen(0.5)) > 0.25);
    }

    #[test]
    fn points_that_fill_space_are_on_no_surface() {
        let mut random = Random::new(8, 0);
        let points: Vec<Point> = (0..3000)
            .map(|_| Point::new(random.unit(), random.unit(), random.unit()))
            .collect();
        assert_eq!(measured(&points), None);
    }

    #[test]
    fn few_points_tell_nothing() {
        let points = &sheet(0.1)[..20];
        assert_eq!(measured(points), None);
    }
}
