//! Distances to surfaces, counted for a histogram.

use std::ops::RangeInclusive;

use crate::model::{Model, Primitive};

/// Orders of magnitude below the largest distance that a logarithmic histogram tells apart: below a
/// millionth of it is rounding.
const DECADES: f64 = 6.0;

/// How distances are sorted into intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bins {
    count: usize,
    limit: f64,
    logarithmic: bool,
}

impl Bins {
    /// Intervals of equal length from 0 to `limit`, or of equal ratio from a millionth of it. A
    /// limit that is not positive and finite is 1; there is at least one interval.
    pub fn new(count: usize, limit: f64, logarithmic: bool) -> Self {
        let usable = limit > 0.0 && limit.is_finite();
        Self {
            count: count.max(1),
            limit: if usable { limit } else { 1.0 },
            logarithmic,
        }
    }

    /// Bounds of the intervals, one more than there are. The first takes all that is smaller as
    /// well, the last all that is larger.
    pub fn edges(&self) -> impl Iterator<Item = f64> {
        let Self {
            count,
            limit,
            logarithmic,
        } = *self;
        (0..=count).map(move |at| {
            let share = at as f64 / count as f64;
            if logarithmic {
                limit * libm::pow(10.0, DECADES * (share - 1.0))
            } else {
                limit * share
            }
        })
    }

    /// The interval of a distance.
    pub fn of(&self, distance: f64) -> usize {
        let share = distance / self.limit;
        let share = if self.logarithmic {
            // Minus infinity for a distance of 0, which the conversion below brings to 0.
            1.0 + libm::log10(share) / DECADES
        } else {
            share
        };
        // A float below the range becomes 0, as does NaN.
        ((share * self.count as f64) as usize).min(self.count - 1)
    }

    /// How many of a primitive's points have a distance in each interval. Points of a primitive
    /// without surface have no distance.
    pub fn counts(&self, model: &Model, primitive: &Primitive) -> Vec<u32> {
        let mut counts = vec![0; self.count];
        for (_, distance) in distances(model, primitive) {
            if let Some(count) = counts.get_mut(self.of(distance)) {
                *count += 1;
            }
        }
        counts
    }

    /// Indices, ascending and each once, of the points that one of the primitives lists and whose
    /// distance to its surface is in one of the intervals. O(n).
    pub fn points_in<'a>(
        &self,
        model: &Model,
        primitives: impl IntoIterator<Item = &'a Primitive>,
        intervals: &RangeInclusive<usize>,
    ) -> Vec<u32> {
        let mut is_in = vec![false; model.cloud.len()];
        for primitive in primitives {
            for (index, distance) in distances(model, primitive) {
                if intervals.contains(&self.of(distance))
                    && let Some(is_in) = is_in.get_mut(index as usize)
                {
                    *is_in = true;
                }
            }
        }
        let found = (0_u32..).zip(is_in).filter(|(_, is_in)| *is_in);
        found.map(|(index, _)| index).collect()
    }
}

/// The largest distance of a listed point to the surface of its primitive, over some primitives of
/// a model; 0 where there is none.
pub fn farthest<'a>(model: &Model, primitives: impl IntoIterator<Item = &'a Primitive>) -> f64 {
    let all = primitives.into_iter();
    all.flat_map(|primitive| distances(model, primitive))
        .map(|(_, distance)| distance)
        .fold(0.0, f64::max)
}

/// Each listed point's index and its distance to the primitive's surface; none without a surface.
fn distances(model: &Model, primitive: &Primitive) -> impl Iterator<Item = (u32, f64)> {
    let surface = primitive.surface.as_ref();
    let points = model.cloud.points();
    let listed = primitive.points.iter();
    listed.filter_map(move |&index| {
        let point = points.get(index as usize)?;
        Some((index, surface?.distance(point)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Cloud, Point, Vector};
    use crate::surface::{Plane, Surface};

    #[test]
    fn the_limit_is_in_the_last_interval_and_nothing_is_lost() {
        let bins = Bins::new(4, 2.0, false);
        assert_eq!(bins.edges().collect::<Vec<_>>(), [0.0, 0.5, 1.0, 1.5, 2.0]);
        let found = [0.0, 0.49, 0.5, 1.99, 2.0, 9.0, -1.0].map(|distance| bins.of(distance));
        assert_eq!(found, [0, 0, 1, 3, 3, 3, 0]);
    }

    #[test]
    fn logarithmic_intervals_have_one_ratio_and_the_first_takes_zero() {
        let bins = Bins::new(6, 100.0, true);
        for (edge, expected) in bins.edges().zip([1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0]) {
            assert!((edge / expected - 1.0).abs() < 1e-12);
        }
        let found = [0.0, 1e-9, 5e-4, 5.0, 50.0, 100.0].map(|distance| bins.of(distance));
        assert_eq!(found, [0, 0, 0, 4, 5, 5]);
    }

    #[test]
    fn counts_are_of_points_that_have_a_distance() {
        let heights = [0.0, 0.0, 1.0, 3.0, 4.0];
        let points = heights.map(|z| Point::new(0.0, 0.0, z));
        let model = Model {
            cloud: Cloud::new(points.to_vec()),
            ..Model::default()
        };
        let floor = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
        let all = Primitive::on(floor, 1, vec![0, 1, 2, 3, 4, 99]);
        let bare = Primitive {
            points: vec![0, 1],
            ..Primitive::default()
        };
        assert_eq!(farthest(&model, [&all, &bare]), 4.0);
        assert_eq!(farthest(&model, [&bare]), 0.0);
        let bins = Bins::new(4, 4.0, false);
        assert_eq!(bins.counts(&model, &all), [2, 1, 0, 2]);
        assert_eq!(bins.counts(&model, &bare), [0; 4]);
        let chosen = |intervals| bins.points_in(&model, [&all, &all, &bare], &intervals);
        assert_eq!(chosen(1..=2), [2]);
        assert_eq!(chosen(0..=3), [0, 1, 2, 3, 4]);
        assert!(chosen(2..=2).is_empty());
        assert_eq!(chosen(3..=9), [3, 4]);
    }

    #[test]
    fn a_limit_that_is_none_is_one() {
        for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Bins::new(2, limit, false), Bins::new(2, 1.0, false));
        }
    }
}
