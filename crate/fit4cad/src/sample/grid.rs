//! Points in cells, for queries of one reach.

use crate::cloud::{Cells, Point};

/// A growing set of points, hashed by the cubic cells they lie in: a query looks at eight cells.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    reach: f64,
    cells: Cells,
}

impl Grid {
    /// An empty grid for queries of one reach.
    pub fn new(reach: f64) -> Self {
        Self {
            reach,
            cells: Cells::new(Point::origin(), 2.0 * reach),
        }
    }

    /// Adds a point.
    pub fn add(&mut self, point: Point) {
        self.cells.add(point);
    }

    /// Adds a point unless another is within reach; tells whether it did.
    pub fn add_apart(&mut self, point: Point) -> bool {
        let is_free = !self.cells.any_within(&point, self.reach, |_| true);
        if is_free {
            self.add(point);
        }
        is_free
    }

    /// Calls back with the index of every point within reach. Expected O(1 + number found).
    pub fn near(&self, point: &Point, mut found: impl FnMut(usize)) {
        self.cells.any_within(point, self.reach, |index| {
            found(index);
            false
        });
    }
}
