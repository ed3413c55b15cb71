//! The axis-aligned bounding box.

use super::{Point, Vector};

/// An axis-aligned box; empty until a point is added.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates; `+∞` while empty.
    pub min: Point,
    /// Largest coordinates; `-∞` while empty.
    pub max: Point,
}

impl Default for Bounds {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Bounds {
    /// The box of nothing.
    pub const EMPTY: Self = Self {
        min: Point::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        max: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The smallest box around the points.
    pub fn of<'a>(points: impl IntoIterator<Item = &'a Point>) -> Self {
        let mut bounds = Self::EMPTY;
        for point in points {
            bounds.add(point);
        }
        bounds
    }

    /// Grows the box to hold the point.
    pub fn add(&mut self, point: &Point) {
        self.min = self.min.inf(point);
        self.max = self.max.sup(point);
    }

    /// Whether no point has been added.
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x
    }

    /// Edge lengths; zero for an empty box.
    pub fn size(&self) -> Vector {
        if self.is_empty() {
            Vector::zeros()
        } else {
            self.max - self.min
        }
    }

    /// Length of the space diagonal: the paper's `l` when taken over the points of one primitive
    /// (section "Approximation accuracy").
    pub fn diagonal(&self) -> f64 {
        self.size().norm()
    }

    /// Length of the longest edge; zero for an empty box.
    pub fn longest_side(&self) -> f64 {
        self.size().max()
    }

    /// Whether a point is in the box or on its sides.
    #[must_use]
    pub fn contains(&self, point: &Point) -> bool {
        (0..3).all(|k| self.min[k] <= point[k] && point[k] <= self.max[k])
    }

    /// Squared distance of a point to the nearest of the box; 0 within.
    pub fn distance_squared_to(&self, point: &Point) -> f64 {
        let mut sum = 0.0;
        for axis in 0..3 {
            let below = self.min[axis] - point[axis];
            let above = point[axis] - self.max[axis];
            // No `max`: that also asks what to do with what is no number.
            let outside = if below > above { below } else { above };
            let outside = if outside > 0.0 { outside } else { 0.0 };
            sum += outside * outside;
        }
        sum
    }

    /// Distance to another box: 0 where they meet, infinite for an empty one.
    pub fn gap_to(&self, other: &Self) -> f64 {
        let apart = |axis: usize| {
            let below = other.min[axis] - self.max[axis];
            let above = self.min[axis] - other.max[axis];
            below.max(above).max(0.0)
        };
        Vector::new(apart(0), apart(1), apart(2)).norm()
    }

    /// The middle of the box; the origin for an empty box.
    pub fn centre(&self) -> Point {
        if self.is_empty() {
            Point::origin()
        } else {
            nalgebra::center(&self.min, &self.max)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_diagonal_of_a_unit_cube_is_the_root_of_three() {
        let bounds = Bounds::of(&[Point::new(0.0, 0.0, 0.0), Point::new(1.0, 1.0, 1.0)]);
        assert_eq!(bounds.diagonal(), 3f64.sqrt());
        assert_eq!(bounds.centre(), Point::new(0.5, 0.5, 0.5));
        assert_eq!(bounds.longest_side(), 1.0);
        let distance = |x, y, z| bounds.distance_squared_to(&Point::new(x, y, z));
        assert_eq!(distance(0.2, 0.4, 1.0), 0.0);
        assert_eq!(distance(-3.0, 0.5, 5.0), 25.0);
        let other = Bounds::of(&[Point::new(4.0, 0.5, 5.0), Point::new(9.0, 3.0, 6.0)]);
        assert_eq!((bounds.gap_to(&other), other.gap_to(&bounds)), (5.0, 5.0));
        assert_eq!(bounds.gap_to(&bounds), 0.0);
    }

    #[test]
    fn an_empty_box_has_no_extent() {
        assert!(Bounds::EMPTY.is_empty());
        assert_eq!(Bounds::EMPTY.diagonal(), 0.0);
    }
}
