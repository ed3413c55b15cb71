//! Closed polygons, and which places are within.

use crate::fit::thin::profile::Place;

/// A closed polygon. Its edges are sorted into rows as high as they are on average, so that a place is
/// compared with the few beside it: the rims of large faces have thousands, and their points are many
/// more.
pub struct Polygon {
    edges: Vec<[Place; 2]>,
    /// Heights at which the rows begin and end.
    range: [f64; 2],
    /// The edges that reach into each row; there is at least one.
    rows: Vec<Vec<u32>>,
}

impl Polygon {
    /// The polygon of some corners, the first of which comes last again. O(edges).
    pub fn new(corners: &[Place]) -> Self {
        let heights = || corners.iter().map(|corner| corner[1]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(f64::NEG_INFINITY, f64::max);
        let edges: Vec<[Place; 2]> = corners.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let rise: f64 = edges.iter().map(|[a, b]| (a[1] - b[1]).abs()).sum();
        // Edges are in three rows on average. Where all is flat this is not a number, and one row would do.
        let rows = edges.len() as f64 * ((high - low) / rise).min(1.0);
        let mut polygon = Self {
            rows: vec![Vec::new(); (rows.ceil() as usize).max(1)],
            edges,
            range: [low, high],
        };
        for (number, [a, b]) in (0u32..).zip(&polygon.edges) {
            let [from, to] = [a[1].min(b[1]), a[1].max(b[1])].map(|y| polygon.row(y));
            for row in polygon.rows.iter_mut().take(to + 1).skip(from) {
                row.push(number);
            }
        }
        polygon
    }

    fn row(&self, height: f64) -> usize {
        let [low, high] = self.range;
        let share = (height - low) / (high - low);
        ((share * self.rows.len() as f64) as usize).min(self.rows.len() - 1)
    }

    /// Whether a place is within: whether a ray from it crosses the polygon an odd number of times.
    /// O(edges of its row).
    pub fn holds(&self, place: Place) -> bool {
        let [low, high] = self.range;
        if !(low..high).contains(&place[1]) {
            return false;
        }
        let crosses = |number: &&u32| {
            let [a, b] = self.edges[**number as usize];
            let is_beside = (a[1] <= place[1]) != (b[1] <= place[1]);
            is_beside && place[0] < a[0] + (b[0] - a[0]) * (place[1] - a[1]) / (b[1] - a[1])
        };
        let row = &self.rows[self.row(place[1])];
        row.iter().filter(crosses).count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_within_a_polygon_or_not() {
        let corners = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [2.0, 1.0],
            [0.0, 4.0],
            [0.0, 0.0],
        ];
        let polygon = Polygon::new(&corners);
        assert!(polygon.holds([1.0, 1.0]) && polygon.holds([3.5, 3.0]));
        assert!(!polygon.holds([2.0, 2.0]) && !polygon.holds([5.0, 1.0]));
        assert!(!polygon.holds([1.0, -1.0]) && !polygon.holds([1.0, f64::NAN]));
        assert!(!Polygon::new(&[]).holds([0.0, 0.0]));
        assert!(!Polygon::new(&[[1.0, 1.0]; 3]).holds([1.0, 1.0]));
    }
}
