//! How far points reach in the parameters of a surface.

use std::f64::consts::{PI, TAU};

use crate::cloud::{Direction, Point};

/// A gap between neighbouring angles narrower than this is no gap, however many points there are.
const NARROWEST_GAP: f64 = PI / 6.0;

/// A range of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    /// Its start.
    pub low: f64,
    /// Its end, not less than the start.
    pub high: f64,
    /// Whether it is a full turn: the end is the start again.
    pub closed: bool,
}

impl Range {
    /// From the least to the greatest value; 0 to 0 for none.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let empty = low > high;
        Self {
            low: if empty { 0.0 } else { low },
            high: if empty { 0.0 } else { high },
            closed: false,
        }
    }

    /// Middle.
    pub fn middle(&self) -> f64 {
        f64::midpoint(self.low, self.high)
    }

    /// Length.
    pub fn length(&self) -> f64 {
        self.high - self.low
    }

    /// The part between two limits.
    pub fn clamped(self, low: f64, high: f64) -> Self {
        Self {
            low: self.low.clamp(low, high),
            high: self.high.clamp(low, high),
            ..self
        }
    }
}

/// Range of the heights of points along an axis.
pub(super) fn heights(points: &[Point], origin: &Point, axis: &Direction) -> Range {
    Range::of(points.iter().map(|point| (point - origin).dot(axis)))
}

/// The range of angles that leaves out the widest gap between neighbours; the full turn where no
/// gap is wide, measured by what is usual between so many points. O(n log n).
pub(super) fn angles(values: impl Iterator<Item = Option<f64>>) -> Range {
    let mut values: Vec<f64> = values.flatten().collect();
    values.sort_unstable_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (values.first(), values.last()) else {
        return Range {
            low: -PI,
            high: PI,
            closed: true,
        };
    };
    let mut widest = (first + TAU - last, first, last);
    for pair in values.windows(2) {
        if let &[before, after] = pair
            && after - before > widest.0
        {
            // The range starts behind the gap and ends, a turn later, before it.
            widest = (after - before, after, before + TAU);
        }
    }
    let (gap, low, high) = widest;
    let usual = TAU / values.len() as f64;
    if values.len() > 2 && gap < NARROWEST_GAP.max(3.0 * usual).min(PI) {
        return Range {
            low,
            high: low + TAU,
            closed: true,
        };
    }
    Range {
        low,
        high,
        closed: false,
    }
}

/// Corners of the convex hull, counter-clockwise (monotone chain, Andrew 1979). O(n log n).
pub(super) fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let chain = |points: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for &point in points {
            while let &[.., before, last] = chain.as_slice()
                && turn(before, last, point) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        // The last corner is the first of the other chain.
        chain.pop();
        chain
    };
    let mut corners = chain(&mut points.iter());
    corners.extend(chain(&mut points.iter().rev()));
    corners
}

/// Positive where a → b → c turns left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn degrees(values: &[f64]) -> Range {
        angles(values.iter().map(|value| Some(value.to_radians())))
    }

    #[test]
    fn a_quarter_turn_across_the_seam_is_one_range() {
        let range = degrees(&[-170.0, -160.0, -150.0, 150.0, 160.0, 170.0, 180.0]);
        assert!(!range.closed);
        assert!((range.length().to_degrees() - 60.0).abs() < 1e-9);
        assert!((range.low.to_degrees() - 150.0).abs() < 1e-9);
    }

    #[test]
    fn points_all_around_make_a_full_turn() {
        let all: Vec<f64> = (0..36).map(|k| f64::from(k) * 10.0 - 180.0).collect();
        assert!(degrees(&all).closed);
    }

    #[test]
    fn three_quarters_are_not_a_full_turn() {
        let most: Vec<f64> = (0..28).map(|k| f64::from(k) * 10.0 - 180.0).collect();
        let range = degrees(&most);
        assert!(!range.closed && (range.length().to_degrees() - 270.0).abs() < 1e-9);
    }

    #[test]
    fn no_angle_at_all_is_a_full_turn() {
        assert!(angles([None, None].into_iter()).closed);
    }

    #[test]
    fn the_hull_of_a_square_with_points_inside_and_on_its_edges_is_its_corners() {
        let mut points = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        points.extend([[1.0, 1.0], [1.0, 0.0], [2.0, 1.0], [0.5, 0.7], [0.0, 0.0]]);
        assert_eq!(
            hull(points),
            [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
        );
    }

    #[test]
    fn points_in_a_row_have_a_hull_without_area() {
        assert_eq!(hull(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).len(), 2);
        assert!(hull(vec![]).is_empty());
        assert_eq!(hull(vec![[3.0, 4.0]; 5]), [[3.0, 4.0]]);
    }

    proptest! {
        #[test]
        fn every_point_lies_left_of_every_edge_of_the_hull(
            points in prop::collection::vec(prop::array::uniform2(-100.0_f64..100.0), 3..60),
        ) {
            let corners = hull(points.clone());
            for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                for point in &points {
                    prop_assert!(turn(*a, *b, *point) >= -1e-7);
                }
            }
        }

        #[test]
        fn every_angle_lies_in_the_range(values in prop::collection::vec(-PI..PI, 1..50)) {
            let range = angles(values.iter().copied().map(Some));
            prop_assert!(range.length() <= TAU + 1e-12);
            for value in values {
                let inside = [value, value + TAU]
                    .into_iter()
                    .any(|value| (range.low..=range.high).contains(&value));
                prop_assert!(inside || range.closed);
            }
        }
    }
}
