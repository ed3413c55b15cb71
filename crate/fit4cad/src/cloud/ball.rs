//! The ball about the centroid: an extent that does not change when points are turned, as that of
//! the axis-aligned box does by up to a factor of √3.

use super::{Point, Vector};

/// The smallest ball about the centroid of some points that holds them all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// The mean of the points; the origin for none.
    pub centre: Point,
    /// Distance of the farthest point from it; 0 for none.
    pub radius: f64,
}

impl Ball {
    /// The ball of the points; those whose coordinates are not finite are left out. O(n).
    pub fn of<'a, I>(points: I) -> Self
    where
        I: IntoIterator<Item = &'a Point>,
        I::IntoIter: Clone,
    {
        let finite = |point: &&Point| point.iter().all(|x| x.is_finite());
        let points = points.into_iter().filter(finite);
        let (mut sum, mut count) = (Vector::zeros(), 0.0);
        for point in points.clone() {
            sum += point.coords;
            count += 1.0;
        }
        let centre = Point::from(sum / f64::max(count, 1.0));
        let squared = points.map(|point| (point - centre).norm_squared());
        Self {
            centre,
            radius: squared.fold(0.0, f64::max).sqrt(),
        }
    }

    /// Twice the radius: of the points of a box, about the length of its diagonal.
    pub fn diameter(&self) -> f64 {
        2.0 * self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_ball_of_the_corners_of_a_unit_cube_has_the_diameter_root_three() {
        let corners: Vec<Point> = (0..8)
            .map(|i| Point::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))
            .collect();
        let ball = Ball::of(&corners);
        assert_eq!(ball.centre, Point::new(0.5, 0.5, 0.5));
        assert!((ball.diameter() - 3f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn no_points_and_broken_ones_have_no_extent() {
        let broken = [
            Point::new(f64::NAN, 0.0, 0.0),
            Point::new(0.0, f64::INFINITY, 0.0),
        ];
        for points in [&[][..], &broken] {
            assert_eq!(
                (Ball::of(points).centre, Ball::of(points).radius),
                (Point::origin(), 0.0)
            );
        }
    }

    proptest! {
        #[test]
        fn turning_changes_nothing(
            points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 1..50),
            turn in prop::array::uniform3(-3.0..3.0f64),
        ) {
            let points: Vec<Point> = points.into_iter().map(Point::from).collect();
            let turn = nalgebra::Rotation3::new(Vector::from(turn));
            let turned: Vec<Point> = points.iter().map(|point| turn * point).collect();
            let (still, turned) = (Ball::of(&points), Ball::of(&turned));
            prop_assert!((still.radius - turned.radius).abs() < 1e-14);
            prop_assert!((turn * still.centre - turned.centre).norm() < 1e-14);
        }
    }
}
