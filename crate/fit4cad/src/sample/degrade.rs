//! What scanning does to a cloud: missing regions, uneven density, noise, outliers.

use super::SampleError;
use super::ranges::{DENSITY, MISSING, NOISE, OUTLIERS};
use crate::cloud::{Bounds, Point, Vector};
use crate::random::Random;

/// How much worse a cloud becomes. The default changes nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Degradation {
    /// Standard deviation of the normal noise added to each coordinate, 0 to 0.1 of the diagonal
    /// of the cloud's bounding box.
    pub noise: f64,
    /// Outliers per point that is left, 0 to 1: evenly distributed points of no primitive.
    pub outliers: f64,
    /// Fraction of the points cut away by balls and half-spaces, 0 to 0.95.
    pub missing: f64,
    /// How many times as dense the points are left at one end of the cloud as at the other, 1 to 1000.
    /// A point at a share t of the cloud's way along a random direction is kept with a probability of
    /// density^−t: all at the one end, one in so many at the other, and in between by the same factor
    /// over the same length. What is left is a share of (1 − 1/density) / ln density where points are
    /// spread evenly along the way, 39 % for 10 to 1.
    pub density: f64,
}

impl Default for Degradation {
    fn default() -> Self {
        Self {
            noise: 0.0,
            outliers: 0.0,
            missing: 0.0,
            density: DENSITY.default,
        }
    }
}

impl Degradation {
    /// Whether every value is in its range.
    ///
    /// # Errors
    /// [`SampleError::OutOfRange`] names the first value that is not a number in its range.
    pub fn check(&self) -> Result<(), SampleError> {
        NOISE.check(self.noise)?;
        OUTLIERS.check(self.outliers)?;
        MISSING.check(self.missing)?;
        DENSITY.check(self.density)
    }
}

/// A cloud after degradation.
pub struct Worn {
    /// The points left, moved by noise, then the outliers.
    pub points: Vec<Point>,
    /// Where each of the points before is now.
    place: Vec<Option<u32>>,
}

impl Worn {
    /// The points that are kept, in their order.
    pub fn keeping(points: &[Point], kept: &[bool]) -> Self {
        let mut number = 0;
        let place = kept.iter().map(|&kept| {
            number += u32::from(kept);
            kept.then(|| number - 1)
        });
        let place = place.collect();
        let left = points.iter().zip(kept).filter(|(_, kept)| **kept);
        Self {
            points: left.map(|(point, _)| *point).collect(),
            place,
        }
    }

    /// What is left of a list of points, by their new indices.
    pub fn list(&self, points: &[u32]) -> Vec<u32> {
        let place = |&index: &u32| self.place.get(index as usize).copied().flatten();
        points.iter().filter_map(place).collect()
    }
}

/// Cuts away, thins, shakes and strews, in this order. The same seed gives the same cloud. O(n log n).
pub fn degrade(points: &[Point], diagonal: f64, by: &Degradation, seed: u64) -> Worn {
    // Streams below the number of faces serve the faces of generated parts.
    let stream = |number: u64| Random::new(seed, u64::MAX - number);
    let mut kept = if by.missing > 0.0 {
        keep(points, by.missing, &mut stream(0))
    } else {
        vec![true; points.len()]
    };
    if by.density > 1.0 {
        // The third stream is that of imperfect submissions.
        thin(points, &mut kept, by.density, &mut stream(4));
    }
    let mut worn = Worn::keeping(points, &kept);
    if by.noise > 0.0 {
        shake(&mut worn.points, by.noise * diagonal, &mut stream(1));
    }
    let outliers = (by.outliers * worn.points.len() as f64).round() as usize;
    let strays = stray(&worn.points, outliers, &mut stream(2));
    worn.points.extend(strays);
    worn
}

/// Which points are left after regions are cut away: balls about points and half-spaces, as a
/// person would with a lasso, until the given fraction is gone. O(n log n).
fn keep(points: &[Point], fraction: f64, random: &mut Random) -> Vec<bool> {
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

/// Leaves points with a probability that falls along a random direction, from 1 to 1 over `contrast`.
fn thin(points: &[Point], kept: &mut [bool], contrast: f64, random: &mut Random) {
    let direction = direction(random);
    let along = |point: &Point| point.coords.dot(&direction);
    let ways = || points.iter().map(along);
    let (first, last) = ways().fold((f64::INFINITY, f64::NEG_INFINITY), |(first, last), way| {
        (first.min(way), last.max(way))
    });
    let length = last - first;
    for (kept, way) in kept.iter_mut().zip(ways()) {
        // Drawn for each point, so that what is cut away beside it does not change whether it stays.
        let drawn = random.unit();
        let share = if length > 0.0 {
            (way - first) / length
        } else {
            0.0
        };
        *kept = *kept && drawn < libm::pow(contrast, -share);
    }
}

/// Moves every point by independent normal numbers of one standard deviation in x, y and z.
fn shake(points: &mut [Point], deviation: f64, random: &mut Random) {
    for point in points {
        *point += Vector::from_fn(|_, _| random.normal()) * deviation;
    }
}

/// Points evenly distributed in the box of the others, a tenth longer each way.
fn stray(points: &[Point], count: usize, random: &mut Random) -> Vec<Point> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Options, degraded, farthest_off, generate};

    const COARSE: Options = Options {
        seed: 3,
        spacing: 0.03,
        noise: 0.0,
        outliers: 0.0,
        missing: 0.0,
    };

    #[test]
    fn a_degraded_model_keeps_its_truth_on_the_points_that_are_left() {
        let model = generate("housing", &COARSE).unwrap();
        let cut = Degradation {
            missing: 0.2,
            ..Degradation::default()
        };
        let worse = degraded(&model, &cut, 5).unwrap();
        let gone = (0.2 * model.cloud.len() as f64).round() as usize;
        assert_eq!(worse.cloud.len(), model.cloud.len() - gone);
        assert!(farthest_off(&worse).unwrap() < 1e-9);
    }

    #[test]
    fn density_falls_along_the_cloud_by_what_was_asked_for() {
        // A rod in which places along any direction are spread evenly.
        let rod = (0..40_000).map(|k| Point::new(f64::from(k), f64::from(k), f64::from(k)));
        let rod: Vec<Point> = rod.collect();
        let by = Degradation {
            density: 10.0,
            ..Degradation::default()
        };
        let worn = degrade(&rod, 1.0, &by, 4);
        let all = worn.points.len() as f64 / 40_000.0;
        assert!((all - 0.9 / libm::log(10.0)).abs() < 0.01, "{all}");
        let among = |from: f64, to: f64| {
            let inside = worn.points.iter().filter(|it| (from..to).contains(&it.x));
            inside.count() as f64 / 4_000.0
        };
        let ends = [among(0.0, 4_000.0), among(36_000.0, 40_000.0)];
        let (dense, sparse) = (ends[0].max(ends[1]), ends[0].min(ends[1]));
        // The means of 10^−t over the first and the last tenth.
        assert!(
            (dense - 0.893).abs() < 0.02 && (sparse - 0.112).abs() < 0.02,
            "{ends:?}"
        );
        assert_eq!(degrade(&rod, 1.0, &by, 4).points, worn.points);
        assert_ne!(degrade(&rod, 1.0, &by, 5).points, worn.points);
        let heap = [Point::origin(); 7];
        assert_eq!(degrade(&heap, 0.0, &by, 4).points, heap);
    }

    #[test]
    fn noise_has_the_deviation_asked_for_and_outliers_belong_to_nothing() {
        let model = generate("housing", &COARSE).unwrap();
        let by = Degradation {
            noise: 0.002,
            outliers: 0.05,
            ..Degradation::default()
        };
        let worse = degraded(&model, &by, 5).unwrap();
        let count = model.cloud.len();
        let strays = (0.05 * count as f64).round() as usize;
        assert_eq!(worse.cloud.len(), count + strays);
        let moved = model.cloud.points().iter().zip(worse.cloud.points());
        let square: f64 = moved.map(|(a, b)| (a - b).norm_squared()).sum();
        let deviation = (square / (3 * count) as f64).sqrt() / model.cloud.bounds().diagonal();
        assert!((deviation - 0.002).abs() < 0.0001, "{deviation}");
        let listed = worse.truth.unwrap().primitives;
        let last = listed.iter().filter_map(|each| each.points.last()).max();
        assert!((*last.unwrap() as usize) < count);
    }

    #[test]
    fn nothing_asked_for_changes_nothing_and_a_wrong_number_is_named() {
        let model = generate("housing", &COARSE).unwrap();
        assert_eq!(degraded(&model, &Degradation::default(), 1).unwrap(), model);
        let by = Degradation {
            missing: 1.0,
            ..Degradation::default()
        };
        let error = degraded(&model, &by, 1).unwrap_err();
        let sparse = Degradation {
            density: 0.5,
            ..Degradation::default()
        };
        let other = degraded(&model, &sparse, 1).unwrap_err();
        assert!(other.to_string().starts_with("density must be"));
        assert!(error.to_string().starts_with("missing must be"));
    }
}
