//! Points in cells, to find those near a place.

use super::Point;

const NONE: u32 = u32::MAX;

/// A growing set of points, hashed by the cubic cells they lie in. Memory is O(points), whatever the extent.
#[derive(Debug, Clone)]
pub struct Cells {
    origin: Point,
    /// The side of a cell.
    size: f64,
    points: Vec<Point>,
    /// First point of each bucket.
    heads: Vec<u32>,
    /// The point after each in its bucket.
    next: Vec<u32>,
}

impl Cells {
    /// No points yet. A query looks at few cells where their side is twice the distance it asks for.
    pub fn new(origin: Point, size: f64) -> Self {
        Self {
            origin,
            size,
            points: Vec::new(),
            heads: vec![NONE; 64],
            next: Vec::new(),
        }
    }

    /// Adds a point; its index is the number of points before it. Expected O(1).
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

    /// Asks for the index of every point nearer than a distance until the answer is yes; whether it was.
    /// Expected O(1 + number asked) for distances up to the side of a cell.
    pub fn any_within(
        &self,
        point: &Point,
        distance: f64,
        mut ask: impl FnMut(usize) -> bool,
    ) -> bool {
        let square = distance * distance;
        let low = self.cell(&point.map(|x| x - distance));
        let high = self.cell(&point.map(|x| x + distance));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let cell = [x, y, z];
                    let mut index = self.heads[self.bucket(cell)];
                    while index != NONE {
                        let other = &self.points[index as usize];
                        // Cells may share a bucket; a point counts in its own alone.
                        if (other - point).norm_squared() < square
                            && self.cell(other) == cell
                            && ask(index as usize)
                        {
                            return true;
                        }
                        index = self.next[index as usize];
                    }
                }
            }
        }
        false
    }

    fn cell(&self, point: &Point) -> [i64; 3] {
        let offset = (point - self.origin) / self.size;
        [offset.x, offset.y, offset.z].map(|it| it.floor() as i64)
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
