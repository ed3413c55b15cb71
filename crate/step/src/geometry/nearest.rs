//! The parameter of a curve nearest to a place.

use fit4cad::cloud::{Point, Vector};

/// Steps of Newton's method: the places asked for lie on the curve or nearly, where it doubles its
/// digits with each.
const STEPS: usize = 24;

/// The parameter in `range` of the point nearest to `place`, of a curve that is sampled at so many
/// places first. O(samples).
pub(crate) fn nearest(
    at: impl Fn(f64) -> (Point, Vector),
    [from, to]: [f64; 2],
    samples: usize,
    place: &Point,
) -> f64 {
    let parameter = |k: usize| from + (to - from) * k as f64 / samples as f64;
    let distance = |t: f64| (at(t).0 - place).norm_squared();
    let mut scan: Vec<(f64, usize)> = (0..=samples).map(|k| (distance(parameter(k)), k)).collect();
    scan.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut best = (f64::INFINITY, from);
    // A curve that comes near the place more than once: the coarse scan may rank them wrongly.
    for &(_, k) in scan.iter().take(3) {
        let (low, high) = (
            parameter(k.saturating_sub(1)),
            parameter((k + 1).min(samples)),
        );
        let t = refine(&at, [low, high], parameter(k), place);
        let found = (distance(t), t);
        if found.0 < best.0 {
            best = found;
        }
    }
    best.1
}

/// The parameter near `start`, within `low` to `high`, of the point nearest to `place`.
pub(crate) fn refine(
    at: &impl Fn(f64) -> (Point, Vector),
    [low, high]: [f64; 2],
    start: f64,
    place: &Point,
) -> f64 {
    let mut t = start;
    let (mut point, mut tangent) = at(t);
    for _ in 0..STEPS {
        let offset = place - point;
        let square = tangent.norm_squared();
        if square <= 0.0 {
            break;
        }
        let mut step = offset.dot(&tangent) / square;
        let before = offset.norm_squared();
        let mut moved = false;
        for _ in 0..8 {
            let next = (t + step).clamp(low, high);
            let (there, slope) = at(next);
            if next != t && (there - place).norm_squared() < before {
                (t, point, tangent) = (next, there, slope);
                moved = true;
                break;
            }
            step *= 0.5;
        }
        if !moved {
            break;
        }
    }
    t
}
