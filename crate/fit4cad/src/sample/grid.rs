//! Points in cells, to find those near a place.

use crate::cloud::Point;

/// A growing set of points, hashed by the cubic cells they lie in: a query looks at eight cells.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    reach: f64,
    points: Vec<Point>,
    /// First point of each bucket.
    heads: Vec<u32>,
    /// The point after each in its bucket.
    next: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl Grid {
    /// An empty grid for queries of one reach.
    pub fn new(reach: f64) -> Self {
        Self {
            reach,
            points: Vec::new(),
            heads: vec![NONE; 64],
            next: Vec::new(),
        }
    }

    /// Adds a point.
    pub fn add(&mut self, point: Point) {
        if self.points.len() >= self.heads.len() {
            self.heads = vec![NONE; 4 * self.heads.len()];
            self.next.clear();
            for index in 0..self.points.len() {
                self.link(index);
            }
        }
        self.points.push(point);
        self.link(self.points.len() - 1);
    }

    /// Adds a point unless another is within reach; tells whether it did.
    pub fn add_apart(&mut self, point: Point) -> bool {
        let mut free = true;
        self.near(&point, |_| free = false);
        if free {
            self.add(point);
        }
        free
    }

    /// Calls back with the index of every point within reach. Expected O(1 + number found).
    pub fn near(&self, point: &Point, mut found: impl FnMut(usize)) {
        let square = self.reach * self.reach;
        let low = self.cell(&point.map(|x| x - self.reach));
        let high = self.cell(&point.map(|x| x + self.reach));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let cell = [x, y, z];
                    let mut index = self.heads[self.bucket(cell)];
                    while index != NONE {
                        let other = &self.points[index as usize];
                        // Cells may share a bucket; a point counts in its own alone.
                        if (other - point).norm_squared() < square && self.cell(other) == cell {
                            found(index as usize);
                        }
                        index = self.next[index as usize];
                    }
                }
            }
        }
    }

    fn cell(&self, point: &Point) -> [i64; 3] {
        let size = 2.0 * self.reach;
        [point.x, point.y, point.z].map(|x| (x / size).floor() as i64)
    }

    /// The number of buckets is a power of two.
    fn bucket(&self, cell: [i64; 3]) -> usize {
        let [x, y, z] = cell.map(|c| c as u64);
        let mixed = x.wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f)
            ^ z.wrapping_mul(0x1656_67b1_9e37_79f9);
        ((mixed ^ (mixed >> 29)) as usize) & (self.heads.len() - 1)
    }

    fn link(&mut self, index: usize) {
        let bucket = self.bucket(self.cell(&self.points[index]));
        self.next.push(self.heads[bucket]);
        self.heads[bucket] = index as u32;
    }
}
