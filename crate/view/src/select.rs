//! Which points lie inside a region drawn on the screen. Pure geometry.

use glam::{Mat4, Vec2, Vec3};

/// A region of the viewport, in pixels, y up.
#[derive(Debug, Clone, PartialEq)]
pub enum Region {
    /// A brush.
    Circle {
        /// Its middle.
        centre: Vec2,
        /// Its radius.
        radius: f32,
    },
    /// A lasso, closed from the last corner to the first. Where it crosses itself, what it runs
    /// around an even number of times is outside.
    Polygon(Vec<Vec2>),
}

impl Region {
    /// Whether a position lies inside.
    pub fn contains(&self, position: Vec2) -> bool {
        match self {
            Self::Circle { centre, radius } => {
                position.distance_squared(*centre) <= radius * radius
            }
            Self::Polygon(corners) => {
                let previous = corners.iter().cycle().skip(corners.len().saturating_sub(1));
                let crossings = corners.iter().zip(previous).filter(|(a, b)| {
                    (a.y > position.y) != (b.y > position.y)
                        && position.x < (b.x - a.x) * (position.y - a.y) / (b.y - a.y) + a.x
                });
                crossings.count() % 2 == 1
            }
        }
    }

    /// The same region seen from another origin.
    pub fn moved(mut self, by: Vec2) -> Self {
        match &mut self {
            Self::Circle { centre, .. } => *centre += by,
            Self::Polygon(corners) => corners.iter_mut().for_each(|corner| *corner += by),
        }
        self
    }

    /// Least and greatest corner of the box around it; `None` where it is empty or not finite.
    pub fn extent(&self) -> Option<(Vec2, Vec2)> {
        let (min, max) = match self {
            Self::Circle { centre, radius } => (*centre - *radius, *centre + *radius),
            Self::Polygon(corners) => corners.iter().fold(
                (Vec2::INFINITY, Vec2::NEG_INFINITY),
                |(min, max), corner| (min.min(*corner), max.max(*corner)),
            ),
        };
        let usable = min.is_finite() && max.is_finite() && min.cmple(max).all();
        usable.then_some((min, max))
    }

    /// The places of the points that fall inside, seen or not. O(points × corners) at worst; most
    /// points are settled by the box.
    pub fn select(&self, points: &[Vec3], view_projection: &Mat4, viewport: Vec2) -> Vec<u32> {
        let Some((min, max)) = self.extent() else {
            return Vec::new();
        };
        (0_u32..)
            .zip(points)
            .filter(|(_, point)| {
                let clip = *view_projection * point.extend(1.0);
                let position = (Vec2::new(clip.x, clip.y) / clip.w * 0.5 + 0.5) * viewport;
                // Behind the eye, or NaN, is never inside.
                clip.w > 0.0
                    && position.cmpge(min).all()
                    && position.cmple(max).all()
                    && self.contains(position)
            })
            .map(|(place, _)| place)
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn square() -> Region {
        Region::Polygon(vec![
            Vec2::new(10.0, 10.0),
            Vec2::new(20.0, 10.0),
            Vec2::new(20.0, 20.0),
            Vec2::new(10.0, 20.0),
        ])
    }

    #[test]
    fn a_square_contains_its_middle_and_not_its_surroundings() {
        assert!(square().contains(Vec2::new(15.0, 15.0)));
        for outside in [(5.0, 15.0), (25.0, 15.0), (15.0, 5.0), (15.0, 25.0)] {
            assert!(!square().contains(outside.into()), "{outside:?}");
        }
    }

    #[test]
    fn what_a_lasso_runs_around_twice_is_outside() {
        let mut corners = match square() {
            Region::Polygon(corners) => corners,
            Region::Circle { .. } => unreachable!(),
        };
        corners.extend(corners.clone());
        assert!(!Region::Polygon(corners).contains(Vec2::new(15.0, 15.0)));
    }

    #[test]
    fn degenerate_regions_hold_nothing() {
        for corners in [vec![], vec![Vec2::ONE], vec![Vec2::ONE, Vec2::NAN]] {
            let region = Region::Polygon(corners);
            assert!(
                region
                    .select(&[Vec3::ZERO], &Mat4::IDENTITY, Vec2::splat(2.0))
                    .is_empty()
            );
        }
    }

    #[test]
    fn points_are_selected_where_they_are_drawn() {
        let points = [Vec3::ZERO, Vec3::new(0.9, 0.0, 0.0), Vec3::splat(f32::NAN)];
        let brush = Region::Circle {
            centre: Vec2::new(95.0, 50.0),
            radius: 3.0,
        };
        assert_eq!(
            brush.select(&points, &Mat4::IDENTITY, Vec2::splat(100.0)),
            [1]
        );
    }

    #[test]
    fn points_behind_the_eye_are_not_selected() {
        let matrix = Mat4::perspective_rh_gl(1.0, 1.0, 0.1, 10.0);
        let points = [Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.0, 0.0, -1.0)];
        let everywhere = Region::Circle {
            centre: Vec2::splat(50.0),
            radius: 1e3,
        };
        assert_eq!(everywhere.select(&points, &matrix, Vec2::splat(100.0)), [1]);
    }

    proptest! {
        #[test]
        fn a_polygon_around_a_circle_holds_all_that_the_circle_holds(x in -9.0_f32..9.0, y in -9.0_f32..9.0) {
            let corners = (0..24).map(|k| Vec2::from_angle(k as f32 * 0.261_8) * 10.2).collect();
            let circle = Region::Circle { centre: Vec2::ZERO, radius: 10.0 };
            let position = Vec2::new(x, y);
            if circle.contains(position) {
                prop_assert!(Region::Polygon(corners).contains(position));
            }
        }
    }
}
