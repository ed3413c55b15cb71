//! What is cut away from the cloud: all that lies outside a box with its sides across the axes. A
//! cut by one plane is a box with one side.

use glam::Vec3;

use crate::cloud::Bounds;

/// A box given as shares of the cloud's extent: 0 at the least coordinate, 1 at the greatest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClipBox {
    /// Shares at which it begins.
    pub low: Vec3,
    /// Shares at which it ends.
    pub high: Vec3,
}

impl Default for ClipBox {
    /// The whole cloud.
    fn default() -> Self {
        Self {
            low: Vec3::ZERO,
            high: Vec3::ONE,
        }
    }
}

impl ClipBox {
    /// The part of space that is shown. A side that is at the end of the cloud, or at no number,
    /// hides nothing; nor does any where there are no points.
    pub fn clip(&self, bounds: &Bounds) -> Clip {
        let [least, .., greatest] = bounds.corners();
        let size = greatest - least;
        let mut clip = Clip::ALL;
        for axis in 0..3 {
            let at = |share: f32| least[axis] + size[axis] * share;
            let (low, high) = (at(self.low[axis]), at(self.high[axis]));
            if self.low[axis] > 0.0 && low.is_finite() {
                clip.low[axis] = low.min(greatest[axis]);
            }
            if self.high[axis] < 1.0 && high.is_finite() {
                clip.high[axis] = high.max(least[axis]);
            }
        }
        clip
    }
}

/// The part of space that is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clip {
    /// Least coordinates that are shown.
    pub low: Vec3,
    /// Greatest coordinates that are shown.
    pub high: Vec3,
}

impl Clip {
    /// Hides nothing. Not infinite, for shaders need not know infinity.
    pub const ALL: Self = Self {
        low: Vec3::MIN,
        high: Vec3::MAX,
    };

    /// Whether a point is hidden. One that is no number is not.
    pub fn hides(&self, point: &Vec3) -> bool {
        point.cmplt(self.low).any() || point.cmpgt(self.high).any()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a cloud from 0 to 4 along each axis.
    fn clip(low: [f32; 3], high: [f32; 3]) -> Clip {
        let bounds = Bounds::new(Vec3::ZERO, Vec3::splat(4.0));
        ClipBox {
            low: low.into(),
            high: high.into(),
        }
        .clip(&bounds)
    }

    #[test]
    fn a_box_hides_what_lies_outside_on_any_of_its_six_sides() {
        let clip = clip([0.25, 0.0, 0.0], [0.75, 1.0, 0.5]);
        for shown in [[1.0, 0.0, 0.0], [3.0, 4.0, 2.0], [2.0, 2.0, 1.0]] {
            assert!(!clip.hides(&shown.into()), "{shown:?}");
        }
        for hidden in [[0.9, 2.0, 1.0], [3.1, 2.0, 1.0], [2.0, 2.0, 2.1]] {
            assert!(clip.hides(&hidden.into()), "{hidden:?}");
        }
    }

    #[test]
    fn one_side_is_a_cut_that_hides_what_is_above_it_or_below_it() {
        let (low, high) = (Vec3::new(9.0, 0.9, 9.0), Vec3::new(-9.0, 1.1, 0.0));
        let below = clip([0.0; 3], [1.0, 0.25, 1.0]);
        let above = clip([0.0, 0.25, 0.0], [1.0; 3]);
        assert!(!below.hides(&low) && below.hides(&high));
        assert!(above.hides(&low) && !above.hides(&high));
    }

    #[test]
    fn beyond_the_ends_of_the_cloud_its_rim_is_left() {
        let rim = Vec3::new(2.0, 4.0, 2.0);
        assert!(!clip([0.0, 7.0, 0.0], [1.0; 3]).hides(&rim));
        assert!(!clip([0.0; 3], [1.0, -7.0, 1.0]).hides(&Vec3::ZERO));
        assert_eq!(clip([-1.0; 3], [2.0; 3]), Clip::ALL);
    }

    #[test]
    fn what_is_no_place_hides_nothing() {
        assert_eq!(clip([f32::NAN; 3], [f32::NEG_INFINITY; 3]), Clip::ALL);
        let half = ClipBox {
            low: Vec3::splat(0.5),
            ..ClipBox::default()
        };
        assert_eq!(half.clip(&Bounds::of(std::iter::empty())), Clip::ALL);
        assert!(!clip([0.5; 3], [0.6; 3]).hides(&Vec3::NAN));
    }
}
