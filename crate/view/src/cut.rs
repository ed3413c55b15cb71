//! A plane that what lies on one side of it is hidden by.

use glam::{Vec3, Vec4};

use crate::cloud::Bounds;

/// A plane across one axis of the cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// The axis it is across: 0, 1 or 2.
    pub axis: usize,
    /// Where it is, from 0 at the cloud's least coordinate to 1 at its greatest.
    pub share: f32,
    /// Whether what lies below it is hidden, instead of what lies above.
    pub below: bool,
}

impl Cut {
    /// The plane as a normal and an offset: a point is hidden where its product with the normal is
    /// more than the offset.
    pub fn plane(&self, bounds: &Bounds) -> Vec4 {
        let axis = self.axis.min(2);
        let sign = if self.below { -1.0 } else { 1.0 };
        // Where there are no points there is nothing to hide; NaN, too, hides nothing.
        let share = if self.share.is_finite() {
            self.share.clamp(0.0, 1.0)
        } else {
            return NONE;
        };
        let [low, .., high] = bounds.corners().map(|corner| corner[axis]);
        // Rounding must not hide the outermost points.
        let at = if share < 1.0 {
            low + (high - low) * share
        } else {
            high
        };
        if !at.is_finite() {
            return NONE;
        }
        (Vec3::AXES[axis] * sign).extend(at * sign)
    }
}

/// A plane that hides nothing.
pub const NONE: Vec4 = Vec4::ZERO;

/// Whether a plane hides a point.
pub fn hides(plane: &Vec4, point: &Vec3) -> bool {
    plane.truncate().dot(*point) > plane.w
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(share: f32, below: bool) -> Vec4 {
        let bounds = Bounds::new(Vec3::ZERO, Vec3::splat(4.0));
        let cut = Cut {
            axis: 1,
            share,
            below,
        };
        cut.plane(&bounds)
    }

    #[test]
    fn a_cut_hides_what_is_above_it_or_below_it() {
        let (low, high) = (Vec3::new(9.0, 0.9, 9.0), Vec3::new(-9.0, 1.1, 0.0));
        let (above, below) = (cut(0.25, false), cut(0.25, true));
        assert!(!hides(&above, &low) && hides(&above, &high));
        assert!(hides(&below, &low) && !hides(&below, &high));
    }

    #[test]
    fn at_its_ends_a_cut_hides_nothing_or_all_but_the_rim() {
        for coordinate in [0.0, 2.0, 4.0] {
            let point = Vec3::splat(coordinate);
            assert!(!hides(&cut(1.0, false), &point));
            assert!(!hides(&cut(0.0, true), &point));
        }
    }

    #[test]
    fn what_is_no_place_hides_nothing() {
        let point = Vec3::splat(3.0);
        assert!(!hides(&cut(f32::NAN, false), &point));
        let nowhere = Cut {
            axis: 7,
            share: 0.5,
            below: false,
        };
        assert!(!hides(
            &nowhere.plane(&Bounds::of(std::iter::empty())),
            &point
        ));
        assert!(!hides(&NONE, &point));
    }
}
