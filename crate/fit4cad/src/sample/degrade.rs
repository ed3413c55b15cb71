//! What scanning does to a cloud: missing regions, noise, outliers.

use super::random::Random;
use crate::cloud::{Bounds, Point, Vector};

/// Which points are left after regions are cut away: balls about points and half-spaces, as a
/// person would with a lasso, until the given fraction is gone. O(n log n).
pub fn keep(points: &[Point], fraction: f64, random: &mut Random) -> Vec<bool> {
    const CUTS: usize = 4;
    let mut kept = vec![true; points.len()];
    let goal = (fraction * points.len() as f64).round() as usize;
    let mut gone = 0;
    for cut in 0..CUTS {
        let mut left: Vec<usize> = (0..points.len()).filter(|&index| kept[index]).collect();
        // The last cut takes what the others, of random size, have left of the goal.
        let share = if cut + 1 == CUTS {
            1.0
        } else {
            0.2 + 0.3 * random.unit()
        };
        let count = (((goal - gone) as f64 * share).round() as usize).min(left.len());
        let direction = direction(random);
        let centre = left
            .get(random.below(left.len()))
            .map(|&index| points[index]);
        let (Some(centre), true) = (centre, count > 0) else {
            continue;
        };
        let measure = |index: usize| {
            if cut % 2 == 0 {
                (points[index] - centre).norm_squared()
            } else {
                points[index].coords.dot(&direction)
            }
        };
        let order = |a: &usize, b: &usize| measure(*a).total_cmp(&measure(*b)).then(a.cmp(b));
        left.select_nth_unstable_by(count - 1, order);
        for &index in &left[..count] {
            kept[index] = false;
        }
        gone += count;
    }
    kept
}

/// Moves every point by independent normal numbers of one standard deviation in x, y and z.
pub fn shake(points: &mut [Point], deviation: f64, random: &mut Random) {
    for point in points {
        *point += Vector::from_fn(|_, _| random.normal()) * deviation;
    }
}

/// Points evenly distributed in the box of the others, a tenth longer each way.
pub fn stray(points: &[Point], count: usize, random: &mut Random) -> Vec<Point> {
    let bounds = Bounds::of(points);
    let (centre, size) = (bounds.centre(), bounds.size());
    let mut draw = || {
        let place = Vector::from_fn(|_, _| 0.55 * random.signed());
        centre + size.component_mul(&place)
    };
    (0..count).map(|_| draw()).collect()
}

fn direction(random: &mut Random) -> Vector {
    loop {
        let vector = Vector::from_fn(|_, _| random.signed());
        if vector.norm_squared() > 0.01 && vector.norm_squared() < 1.0 {
            return vector.normalize();
        }
    }
}
