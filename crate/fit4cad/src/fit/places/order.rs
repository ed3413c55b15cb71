//! An order of points that is the same however a file lists them and wherever the cloud stands.
//!
//! What a fit finds hangs on the order of the points: chance draws from a list of them, and of equals
//! the first is taken. So that it hangs on the points alone they are sorted: first by their
//! coordinates, which is the same for every listing to the last digit of every sum; then along a
//! space-filling curve (Morton 1966) through a frame that the points themselves tell, which turns and
//! grows with them. Its cells are so coarse that rounding puts hardly a point of a moved cloud into
//! another, and so fine that hardly two points share one.

use std::cmp::Ordering;

use crate::cloud::{Ball, Direction, Point, Vector};
use crate::surface::across;

/// Bits of a cell along each axis: three times 21 fill a word. Rounding leaves 1e-15 of the extent of
/// a cloud that was moved by a few of it, a billionth of a cell.
const BITS: u32 = 21;
/// Where the first cell begins, in cells. No multiple of a simple fraction, so that planes of symmetry
/// and the lattices of meshers, on which many points lie, are not on the borders of cells.
const OFFSET: f64 = 0.618_033_988_749_895;
/// Share of a length by which rounding may change it, with room to spare.
const ROUNDING: f64 = 1e-9;

/// Compares points by their coordinates, the two zeros being one.
pub fn by_coordinates(a: &Point, b: &Point) -> Ordering {
    let pairs = a.iter().zip(b.iter());
    let mut orders = pairs.map(|(x, y)| (x + 0.0).total_cmp(&(y + 0.0)));
    orders
        .find(|order| order.is_ne())
        .unwrap_or(Ordering::Equal)
}

/// The places in the list of points, which is sorted by coordinates, in the order along the curve.
/// O(n log n).
pub fn along_curve(points: &[Point]) -> Vec<u32> {
    let frame = Frame::of(points);
    let mut order: Vec<(u64, u32)> = points
        .iter()
        .map(|point| interleaved(frame.cell(point)))
        .zip(0..)
        .collect();
    order.sort_unstable();
    order.into_iter().map(|(_, place)| place).collect()
}

/// The places in the list of points, as a plane sweeps over them that the points tell. No symmetry has
/// it, so that of two copies of a face, one beside the other, all points of the same come first.
/// O(n log n).
pub fn swept(points: &[Point]) -> Vec<u32> {
    let Frame { axes, .. } = Frame::of(points);
    let way = axes[0] + axes[1] * OFFSET + axes[2] * (OFFSET * OFFSET);
    let mut order: Vec<u32> = (0u32..).take(points.len()).collect();
    let along = |place: u32| points[place as usize].coords.dot(&way);
    order.sort_by(|&a, &b| along(a).total_cmp(&along(b)));
    order
}

/// A frame that the points tell.
struct Frame {
    origin: Point,
    axes: [Vector; 3],
    /// Cells to a unit of length.
    cells: f64,
}

impl Frame {
    /// From the centroid to the point farthest from it, and to that farthest from the line through
    /// both. Where symmetry leaves a choice, the cells of the coordinates make it. O(n).
    fn of(points: &[Point]) -> Self {
        let Ball { centre, radius } = Ball::of(points);
        // Far from the origin the mean of so many loses digits that the mean of what is left has.
        let rest: Vector = points.iter().map(|point| point - centre).sum();
        let origin = centre + rest / points.len().max(1) as f64;
        let along_coordinates = Self {
            origin,
            axes: [Vector::x(), Vector::y(), Vector::z()],
            cells: if radius > 0.0 {
                f64::from(1u32 << (BITS - 2)) / radius
            } else {
                0.0
            },
        };
        let farthest = |squared: &dyn Fn(&Vector) -> f64| {
            let ways = points.iter().map(|point| point - origin);
            let most = ways.clone().map(|way| squared(&way)).fold(0.0, f64::max);
            let limit = most - ROUNDING * radius * radius;
            ways.filter(|way| squared(way) >= limit)
                .min_by_key(|way| along_coordinates.cell(&(origin + way)))
                .filter(|_| limit > 0.0)
        };
        let Some(first) = farthest(&|way| way.norm_squared()) else {
            return along_coordinates;
        };
        let first = first.normalize();
        let off = |way: &Vector| way - first * way.dot(&first);
        // Where all points are on one line, whatever is across it serves.
        let second = farthest(&|way| off(way).norm_squared()).map_or_else(
            || across(&Direction::new_unchecked(first)).into_inner(),
            |way| off(&way).normalize(),
        );
        Self {
            axes: [first, second, first.cross(&second)],
            ..along_coordinates
        }
    }

    /// The cell of a point along each axis.
    fn cell(&self, point: &Point) -> [u32; 3] {
        let way = point - self.origin;
        let middle = f64::from(1u32 << (BITS - 1)) + OFFSET;
        // Within the ball about the centroid a place is at most half way from the middle to the ends.
        self.axes
            .map(|axis| (way.dot(&axis) * self.cells + middle) as u32)
    }
}

/// The bits of three numbers of [`BITS`] by turns, the highest first.
fn interleaved(cell: [u32; 3]) -> u64 {
    let bits = (0..BITS).rev();
    bits.fold(0, |code, bit| {
        cell.iter()
            .fold(code, |code, &x| code << 1 | u64::from(x >> bit & 1))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_are_interleaved_from_their_highest_bits() {
        assert_eq!(interleaved([0b11, 0b00, 0b01]), 0b100_101);
        assert_eq!(interleaved([1 << (BITS - 1), 0, 0]), 1 << 62);
    }

    #[test]
    fn the_two_zeros_are_one_place() {
        let order = by_coordinates(&Point::new(0.0, -0.0, 1.0), &Point::new(-0.0, 0.0, 1.0));
        assert_eq!(order, Ordering::Equal);
    }

    #[test]
    fn points_on_a_line_and_a_single_one_have_an_order() {
        let line: Vec<Point> = (0..50)
            .map(|i| Point::new(f64::from(i), 0.0, 0.0))
            .collect();
        let mut order = along_curve(&line);
        assert!(order.is_sorted() || order.iter().rev().is_sorted());
        order.sort_unstable();
        assert_eq!(order, (0..50).collect::<Vec<u32>>());
        assert_eq!(along_curve(&line[..1]), [0]);
        assert_eq!(along_curve(&[]), [0u32; 0]);
    }

    proptest! {
        /// Of a brick of points at random: no symmetry, thousands of coordinates.
        #[test]
        fn a_cloud_that_is_turned_moved_and_scaled_keeps_its_order(
            seed in 0u64..1000,
            turn in prop::array::uniform3(-3.0..3.0f64),
            away in prop::array::uniform3(-3.0..3.0f64),
            exponent in -3.0..3.0f64,
        ) {
            let mut random = crate::random::Random::new(seed, 0);
            let mut points: Vec<Point> = (0..1000)
                .map(|_| Point::new(random.unit(), 0.7 * random.unit(), 0.2 * random.unit()))
                .collect();
            points.sort_by(by_coordinates);
            let turn = nalgebra::Rotation3::from_euler_angles(turn[0], turn[1], turn[2]);
            let scale = 10f64.powf(exponent);
            let moved: Vec<Point> =
                points.iter().map(|p| turn * (p * scale) + Vector::from(away) * scale).collect();
            prop_assert_eq!(along_curve(&points), along_curve(&moved));
        }
    }
}
