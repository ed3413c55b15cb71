//! Points in the order of a curve that fills space, so that those that follow each other lie near each other,
//! and a tree over them that takes no sorting.
//!
//! The curve is Morton's (1966): a point's place on it follows from the binary digits of its coordinates, those of
//! the three axes in turn. Cutting the curve where the first digit changes halves the box, again and again
//! (Lauterbach, Garland, Sengupta, Luebke and Manocha 2009, who build such trees on graphics cards). Any part of a cloud
//! keeps the order of the whole, so that many trees of parts of one cloud cost one sort.

use super::{Bounds, Point};

/// Binary digits of a coordinate: cells of a thousandth of the cloud's longest side, finer than points lie apart
/// in clouds of less than a million, and three coordinates in one word.
const DIGITS: u32 = 10;

/// Points per leaf: the fastest of 6, 8, 12 and 16, hardly before 16.
const LEAF: usize = 12;

/// The order of the points of a cloud along the curve through their box.
#[derive(Debug, Clone)]
pub struct Curve {
    /// The place of each point.
    places: Vec<u32>,
    /// The point at each place, after its cell.
    order: Vec<(u32, u32)>,
}

impl Curve {
    /// The curve through points, those of one cell as they come. Coordinates that are no numbers count as the
    /// smallest. O(n log n), a tenth of what building a tree takes.
    pub fn through(points: &[Point]) -> Self {
        let bounds = Bounds::of(points);
        let scale = f64::from(1u32 << DIGITS) / bounds.longest_side().max(f64::MIN_POSITIVE);
        let last = f64::from((1u32 << DIGITS) - 1);
        let cell = |point: &Point| {
            // As casts do, what is no number becomes 0.
            let digits = |axis: usize| ((point[axis] - bounds.min[axis]) * scale).min(last) as u32;
            spread(digits(0)) | spread(digits(1)) << 1 | spread(digits(2)) << 2
        };
        let numbered = (0u32..).zip(points);
        let keys =
            numbered.map(|(index, point)| u64::from(cell(point)) << u32::BITS | u64::from(index));
        let mut keys: Vec<u64> = keys.collect();
        keys.sort_unstable();
        let parts = keys
            .into_iter()
            .map(|key| ((key >> u32::BITS) as u32, key as u32));
        let order: Vec<(u32, u32)> = parts.collect();
        let mut places = vec![0; order.len()];
        for (place, &(_, index)) in (0u32..).zip(&order) {
            if let Some(slot) = places.get_mut(index as usize) {
                *slot = place;
            }
        }
        Self { places, order }
    }

    /// Where on the curve the point of an index is; `None` beyond the cloud.
    pub fn place(&self, index: u32) -> Option<u32> {
        self.places.get(index as usize).copied()
    }

    /// The number of the cell at a place, and the index of the point; `None` beyond the last.
    pub fn at(&self, place: u32) -> Option<(u32, u32)> {
        self.order.get(place as usize).copied()
    }
}

/// The ten lowest binary digits, two zeros between each and the next.
const fn spread(digits: u32) -> u32 {
    let digits = (digits | digits << 16) & 0x0300_00ff;
    let digits = (digits | digits << 8) & 0x0300_f00f;
    let digits = (digits | digits << 4) & 0x030c_30c3;
    (digits | digits << 2) & 0x0924_9249
}

/// A tree over points along the curve. Its boxes are tight, as those of a [`KdTree`](super::neighbours::KdTree), and
/// as good to search; its halves are of space, not of the points.
#[derive(Debug, Clone)]
pub struct CurveTree {
    points: Vec<Point>,
    /// The left child of each follows it.
    nodes: Vec<Node>,
}

/// 64 bytes.
#[derive(Debug, Clone)]
struct Node {
    bounds: Bounds,
    /// Its points.
    start: u32,
    end: u32,
    /// The right child; 0 for a leaf.
    right: u32,
}

impl CurveTree {
    /// The tree of points in the order of the curve, with the cell of each. O(n).
    ///
    /// # Panics
    /// If there are more cells than points.
    pub fn new(points: Vec<Point>, cells: &[u32]) -> Self {
        let mut nodes = Vec::with_capacity(cells.len() / 3 + 1);
        grow(&points, cells, 0, &mut nodes);
        Self { points, nodes }
    }

    /// A point nearest to `query` and its squared distance, if there is one nearer than that of the square `limit`.
    /// O(log n).
    pub fn closest(&self, query: &Point, limit: f64) -> Option<(&Point, f64)> {
        let mut search = Closest {
            query,
            limit,
            found: None,
        };
        self.visit(0, &mut search);
        Some((search.found?, search.limit))
    }

    fn visit<'a>(&'a self, node: usize, search: &mut Closest<'a, '_>) {
        let at = &self.nodes[node];
        if at.right == 0 {
            for point in &self.points[at.start as usize..at.end as usize] {
                let square = (point - search.query).norm_squared();
                if square < search.limit {
                    search.limit = square;
                    search.found = Some(point);
                }
            }
            return;
        }
        let (left, right) = (node + 1, at.right as usize);
        let to_left = self.nodes[left].bounds.distance_squared_to(search.query);
        let to_right = self.nodes[right].bounds.distance_squared_to(search.query);
        let ((near, to_near), (far, to_far)) = if to_right < to_left {
            ((right, to_right), (left, to_left))
        } else {
            ((left, to_left), (right, to_right))
        };
        if to_near < search.limit {
            self.visit(near, search);
        }
        if to_far < search.limit {
            self.visit(far, search);
        }
    }
}

/// A search for one point.
struct Closest<'a, 'b> {
    query: &'b Point,
    /// Squared distance of what was found, or from which on nothing is wanted.
    limit: f64,
    found: Option<&'a Point>,
}

/// Adds the node over the points of some cells, those from `start` on, and gives its box. As deep as cells have
/// digits, and below that as halving goes.
fn grow(points: &[Point], cells: &[u32], start: usize, nodes: &mut Vec<Node>) -> Bounds {
    let at = nodes.len();
    let end = start + cells.len();
    nodes.push(Node {
        bounds: Bounds::EMPTY,
        start: start as u32,
        end: end as u32,
        right: 0,
    });
    let (bounds, right) = match cells {
        [first, .., last] if cells.len() > LEAF => {
            let (left, right) = cells.split_at(cut(cells, *first, *last));
            let one = grow(points, left, start, nodes);
            let place = nodes.len() as u32;
            let other = grow(points, right, start + left.len(), nodes);
            let bounds = Bounds {
                min: one.min.inf(&other.min),
                max: one.max.sup(&other.max),
            };
            (bounds, place)
        }
        _ => (Bounds::of(&points[start..end]), 0),
    };
    if let Some(node) = nodes.get_mut(at) {
        (node.bounds, node.right) = (bounds, right);
    }
    bounds
}

/// Where the first digit in which ascending cells differ changes; the middle of equal ones.
fn cut(cells: &[u32], first: u32, last: u32) -> usize {
    match (first ^ last).checked_ilog2() {
        None => cells.len() / 2,
        Some(digit) => {
            let from = last & (u32::MAX << digit);
            cells.partition_point(|&cell| cell < from)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;
    use proptest::prelude::*;

    fn order(points: &[Point]) -> Vec<u32> {
        let curve = Curve::through(points);
        let order = (0u32..).map_while(|place| Some(curve.at(place)?.1));
        let order: Vec<u32> = order.collect();
        for (place, &index) in (0u32..).zip(&order) {
            assert_eq!(curve.place(index), Some(place));
        }
        order
    }

    #[test]
    fn digits_are_spread_one_in_three() {
        let slow =
            |digits: u32| (0..DIGITS).fold(0, |sum, at| sum | (digits >> at & 1) << (3 * at));
        assert!((0..1 << DIGITS).all(|digits| spread(digits) == slow(digits)));
    }

    #[test]
    fn every_point_is_there_once_and_follows_one_near_it() {
        let grid = |k: u32| Point::new(f64::from(k % 32), f64::from(k / 32), 0.0);
        // A lattice in an order without sense.
        let points: Vec<Point> = (0..1024).map(|k| grid(k * 389 % 1024)).collect();
        let order = order(&points);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..1024).collect::<Vec<u32>>());
        let at = |index: u32| &points[index as usize];
        let steps = order
            .windows(2)
            .map(|pair| nalgebra::distance(at(pair[0]), at(pair[1])));
        let mean = steps.sum::<f64>() / 1023.0;
        assert!(mean < 2.0, "{mean}");
    }

    #[test]
    fn points_without_extent_and_what_is_no_number_do_no_harm() {
        assert!(order(&[]).is_empty());
        assert_eq!(order(&[Point::origin(); 3]), [0, 1, 2]);
        let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0].map(|x| Point::new(x, 1.0, x));
        assert_eq!(order(&odd).len(), 4);
        let nothing = CurveTree::new(Vec::new(), &[]);
        assert_eq!(nothing.closest(&Point::origin(), f64::INFINITY), None);
    }

    proptest! {
        /// Coordinates on a coarse grid: most are shared, and many points coincide.
        #[test]
        fn closest_agrees_with_looking_at_all(
            grid in prop::collection::vec((0u8..6, 0u8..6, 0u8..3), 1..200),
            part in 1usize..4,
        ) {
            let points: Vec<Point> = grid
                .iter()
                .map(|&(x, y, z)| Point::new(x.into(), y.into(), z.into()))
                .collect();
            let curve = Curve::through(&points);
            let places = (0..points.len() as u32).step_by(part);
            let (cells, some): (Vec<u32>, Vec<Point>) = places
                .filter_map(|place| curve.at(place))
                .map(|(cell, index)| (cell, points[index as usize]))
                .unzip();
            let tree = CurveTree::new(some.clone(), &cells);
            for query in &points {
                let beside = query + Vector::new(0.25, 0.125, -0.25);
                let squares = some.iter().map(|point| (point - beside).norm_squared());
                let least = squares.fold(f64::INFINITY, f64::min);
                let (near, square) = tree.closest(&beside, f64::INFINITY).unwrap();
                prop_assert_eq!(square, least);
                prop_assert_eq!((near - beside).norm_squared(), least);
                prop_assert!(tree.closest(&beside, least).is_none());
                prop_assert!(tree.closest(&beside, 1.001 * least).is_some());
            }
        }
    }
}
