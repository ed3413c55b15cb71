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
    }

    #[test]
    fn an_empty_box_has_no_extent() {
        assert!(Bounds::EMPTY.is_empty());
        assert_eq!(Bounds::EMPTY.diagonal(), 0.0);
    }
}
