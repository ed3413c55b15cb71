//! Near neighbours: a static kd-tree and the graph of the k nearest neighbours of every point.
//!
//! The tree splits index ranges in half, never coordinates, so faces parallel to an axis, where
//! thousands of points share a coordinate, and repeated points leave it balanced. Every node keeps
//! the tight box of its points: CAD clouds are made of thin sheets, and a tight box around a sheet
//! prunes far more than the cell between splitting planes. The boxes also answer which points lie
//! near a surface (see [`KdTree::near_zero`]), which splitting planes cannot.

use super::{Bounds, Point};

/// Points per leaf: the fastest of 8, 12, 16 and 24 for 16 neighbours of 50,000 points.
const LEAF: usize = 12;

/// A neighbour of a query point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Neighbour {
    /// Index of the point in the cloud.
    pub index: u32,
    /// Squared distance to the query.
    pub distance_squared: f64,
}

/// Whether two points are linked in the Gabriel graph (Gabriel and Sokal 1969): whether the ball over
/// the segment between them holds none of those nearby. On the sphere they are outside.
pub fn is_gabriel_link<'a>(
    start: &Point,
    end: &Point,
    mut nearby: impl Iterator<Item = &'a Point>,
) -> bool {
    let middle = nalgebra::center(start, end);
    let limit = 0.25 * (end - start).norm_squared() * (1.0 - 1e-9);
    nearby.all(|point| (point - middle).norm_squared() >= limit)
}

/// A static tree over points. Building takes O(n log n) time; 28 bytes a point and 48 bytes per
/// node of up to 12 points.
#[derive(Debug, Clone)]
pub struct KdTree {
    /// The points in the order of the leaves, next to each other in memory as they are in space.
    points: Vec<Point>,
    /// Index in the cloud of each of them.
    indices: Vec<u32>,
    /// Box of each node; the children of node i are 2i + 1 and 2i + 2.
    boxes: Vec<Bounds>,
}

impl KdTree {
    /// The tree of the points. Coordinates that are not finite make results meaningless, but do no
    /// harm.
    pub fn new(points: &[Point]) -> Self {
        let mut indices: Vec<u32> = (0u32..).take(points.len()).collect();
        let mut boxes = vec![Bounds::EMPTY; node_count(points.len())];
        build(points, &mut indices, 0, &mut boxes);
        let points = indices.iter().map(|&i| points[i as usize]).collect();
        Self {
            points,
            indices,
            boxes,
        }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Indices of the points in the order of the leaves: those that follow each other lie near each
    /// other.
    pub fn order(&self) -> &[u32] {
        &self.indices
    }

    /// Whether the tree holds no point.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The up to `count` points nearest to `query` among those `keep` admits, not farther than
    /// `radius`, nearest first, equals by index. Distances that differ by rounding alone are equal:
    /// in the lattices of a mesher many are, and turning the cloud is not to change their order.
    /// `found` is overwritten. O(log n + count) where `keep` admits most points.
    pub fn nearest(
        &self,
        query: &Point,
        count: usize,
        radius: f64,
        mut keep: impl FnMut(u32) -> bool,
        found: &mut Vec<Neighbour>,
    ) {
        found.clear();
        if count == 0 || self.is_empty() {
            return;
        }
        let mut search = Nearest {
            query,
            count,
            limit: radius * radius,
            found,
        };
        self.visit_nearest(0, 0, self.len(), &mut search, &mut keep);
    }

    fn visit_nearest(
        &self,
        node: usize,
        start: usize,
        end: usize,
        search: &mut Nearest<'_>,
        keep: &mut impl FnMut(u32) -> bool,
    ) {
        if end - start <= LEAF {
            for slot in start..end {
                let distance_squared = (self.points[slot] - search.query).norm_squared();
                if distance_squared <= search.limit && keep(self.indices[slot]) {
                    search.add(Neighbour {
                        index: self.indices[slot],
                        distance_squared,
                    });
                }
            }
            return;
        }
        let middle = start + (end - start) / 2;
        let left = (2 * node + 1, start, middle);
        let right = (2 * node + 2, middle, end);
        let to_left = self.boxes[left.0].distance_squared_to(search.query);
        let to_right = self.boxes[right.0].distance_squared_to(search.query);
        let ((near, to_near), (far, to_far)) = if to_right < to_left {
            ((right, to_right), (left, to_left))
        } else {
            ((left, to_left), (right, to_right))
        };
        if to_near <= search.limit {
            self.visit_nearest(near.0, near.1, near.2, search, keep);
        }
        if to_far <= search.limit {
            self.visit_nearest(far.0, far.1, far.2, search, keep);
        }
    }

    /// Calls `visit` for every point at which `distance`, the distance to some set, is at most
    /// `tolerance` in absolute value.
    ///
    /// A distance changes by no more than one moves (it is 1-Lipschitz), so a box whose middle is
    /// farther from the set than half its diagonal holds no such point. For a surface this takes
    /// time proportional to the answer and to the n^⅔ leaves the surface cuts.
    pub fn near_zero(
        &self,
        tolerance: f64,
        distance: impl Fn(&Point) -> f64,
        mut visit: impl FnMut(u32),
    ) {
        if !self.is_empty() {
            self.visit_near_zero(0, 0, self.len(), tolerance, &distance, &mut visit);
        }
    }

    fn visit_near_zero(
        &self,
        node: usize,
        start: usize,
        end: usize,
        tolerance: f64,
        distance: &impl Fn(&Point) -> f64,
        visit: &mut impl FnMut(u32),
    ) {
        let bounds = &self.boxes[node];
        if distance(&bounds.centre()).abs() > tolerance + 0.5 * bounds.diagonal() {
            return;
        }
        if end - start <= LEAF {
            for slot in start..end {
                if distance(&self.points[slot]).abs() <= tolerance {
                    visit(self.indices[slot]);
                }
            }
            return;
        }
        let middle = start + (end - start) / 2;
        self.visit_near_zero(2 * node + 1, start, middle, tolerance, distance, visit);
        self.visit_near_zero(2 * node + 2, middle, end, tolerance, distance, visit);
    }
}

/// State of one search for the nearest points.
struct Nearest<'a> {
    query: &'a Point,
    count: usize,
    /// Squared distance beyond which nothing is wanted.
    limit: f64,
    /// Nearest first; short enough that insertion beats a heap.
    found: &'a mut Vec<Neighbour>,
}

impl Nearest<'_> {
    fn add(&mut self, neighbour: Neighbour) {
        let key = |n: &Neighbour| (rounded(n.distance_squared), n.index);
        let place = self.found.partition_point(|n| key(n) <= key(&neighbour));
        if place >= self.count {
            return;
        }
        if self.found.len() == self.count {
            self.found.pop();
        }
        self.found.insert(place, neighbour);
        if self.found.len() == self.count
            && let Some(last) = self.found.last()
        {
            self.limit = last.distance_squared * (1.0 + 2.0 * ROUNDING);
        }
    }
}

/// Relative difference of squared distances up to which they are the same: far above what moving a
/// cloud by many diagonals leaves of its coordinates, far below what coordinates of seven digits tell.
const ROUNDING: f64 = 1.0 / (1u64 << 30) as f64;

/// A number to the nearest multiple of about [`ROUNDING`] of itself, as something that is ordered as
/// it is: the bits of a float that is not negative are.
fn rounded(positive: f64) -> u64 {
    /// Digits of the mantissa's 52 that are dropped.
    const DROPPED: u32 = 22;
    (positive.to_bits() + (1 << (DROPPED - 1))) >> DROPPED
}

/// How many slots the nodes over so many points may take.
fn node_count(points: usize) -> usize {
    let (mut largest, mut nodes) = (points, 1);
    while largest > LEAF {
        largest = largest.div_ceil(2);
        nodes = 2 * nodes + 1;
    }
    nodes
}

/// Orders the indices so that every node's points are next to each other, and sets its box.
fn build(points: &[Point], indices: &mut [u32], node: usize, boxes: &mut [Bounds]) {
    let bounds = Bounds::of(indices.iter().map(|&i| &points[i as usize]));
    boxes[node] = bounds;
    if indices.len() <= LEAF {
        return;
    }
    let axis = bounds.size().imax();
    let middle = indices.len() / 2;
    indices.select_nth_unstable_by(middle, |&a, &b| {
        let (p, q) = (points[a as usize][axis], points[b as usize][axis]);
        p.total_cmp(&q).then(a.cmp(&b))
    });
    let (left, right) = indices.split_at_mut(middle);
    build(points, left, 2 * node + 1, boxes);
    build(points, right, 2 * node + 2, boxes);
}

/// The k nearest neighbours of every point of a cloud. 4 k bytes a point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Neighbourhoods {
    count: usize,
    indices: Vec<u32>,
}

impl Neighbourhoods {
    /// The `count` nearest neighbours of each point, itself left out (fewer where the cloud has no
    /// more). O(n log n).
    pub fn new(points: &[Point], tree: &KdTree, count: usize) -> Self {
        let count = count.min(points.len().saturating_sub(1));
        let mut indices = vec![0; points.len() * count];
        if count == 0 {
            return Self { count, indices };
        }
        let mut found = Vec::with_capacity(count + 1);
        // In the order of the leaves, so that each search finds its part of the tree in the cache.
        for &index in &tree.indices {
            let point = &points[index as usize];
            tree.nearest(point, count, f64::INFINITY, |i| i != index, &mut found);
            let start = index as usize * count;
            for (slot, neighbour) in indices[start..start + count].iter_mut().zip(&found) {
                *slot = neighbour.index;
            }
        }
        Self { count, indices }
    }

    /// Number of neighbours kept per point.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The neighbours of a point of the cloud, nearest first.
    ///
    /// # Panics
    /// If the cloud has no such point.
    pub fn of(&self, index: u32) -> &[u32] {
        let start = index as usize * self.count;
        &self.indices[start..start + self.count]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn brute_force(points: &[Point], query: &Point, count: usize) -> Vec<u32> {
        let mut order: Vec<u32> = (0u32..).take(points.len()).collect();
        order.sort_by(|&a, &b| {
            let distance = |i: u32| (points[i as usize] - query).norm_squared();
            distance(a).total_cmp(&distance(b)).then(a.cmp(&b))
        });
        order.truncate(count);
        order
    }

    proptest! {
        /// Coordinates on a coarse grid: most are shared, and many points coincide.
        #[test]
        fn nearest_agrees_with_sorting_all_distances(
            grid in prop::collection::vec((0u8..6, 0u8..6, 0u8..3), 1..200),
            count in 1usize..20,
        ) {
            let points: Vec<Point> = grid
                .iter()
                .map(|&(x, y, z)| Point::new(x.into(), y.into(), z.into()))
                .collect();
            let tree = KdTree::new(&points);
            let mut found = Vec::new();
            for query in &points {
                tree.nearest(query, count, f64::INFINITY, |_| true, &mut found);
                let found: Vec<u32> = found.iter().map(|n| n.index).collect();
                let expected = brute_force(&points, query, count);
                prop_assert_eq!(&found, &expected);
            }
        }

        #[test]
        fn near_zero_finds_exactly_the_points_in_the_band(
            points in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64), 0..200),
            radius in 0.1..1.0f64,
        ) {
            let points: Vec<Point> =
                points.into_iter().map(|(x, y, z)| Point::new(x, y, z)).collect();
            let distance = |p: &Point| p.coords.norm() - radius;
            let mut found = Vec::new();
            KdTree::new(&points).near_zero(0.1, distance, |index| found.push(index));
            found.sort_unstable();
            let expected: Vec<u32> = (0u32..)
                .zip(&points)
                .filter(|(_, p)| distance(p).abs() <= 0.1)
                .map(|(index, _)| index)
                .collect();
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn neighbours_at_equal_distances_keep_their_order_when_the_cloud_is_turned() {
        let lattice: Vec<Point> = (0..400)
            .map(|i| Point::new(f64::from(i % 20), f64::from(i / 20), 0.0) * 0.1)
            .collect();
        let turn = nalgebra::Rotation3::from_euler_angles(0.7, -0.4, 1.3);
        let turned: Vec<Point> = lattice.iter().map(|p| turn * (p * 1000.0)).collect();
        let graph = |points: &[Point]| Neighbourhoods::new(points, &KdTree::new(points), 10);
        assert_eq!(graph(&lattice), graph(&turned));
    }

    #[test]
    fn a_cloud_of_one_repeated_point_is_searched_without_harm() {
        let points = vec![Point::origin(); 1000];
        let tree = KdTree::new(&points);
        let graph = Neighbourhoods::new(&points, &tree, 16);
        assert_eq!(graph.of(0), (1..17).collect::<Vec<u32>>());
    }

    #[test]
    fn fewer_points_than_neighbours_asked_for_give_all_others() {
        let points = [Point::origin(), Point::new(1.0, 0.0, 0.0)];
        let tree = KdTree::new(&points);
        let graph = Neighbourhoods::new(&points, &tree, 16);
        assert_eq!((graph.count(), graph.of(1)), (1, [0].as_slice()));
    }

    #[test]
    fn an_empty_cloud_has_no_neighbours() {
        let tree = KdTree::new(&[]);
        let mut found = Vec::new();
        tree.nearest(&Point::origin(), 3, 1.0, |_| true, &mut found);
        assert!(found.is_empty());
        assert_eq!(Neighbourhoods::new(&[], &tree, 8).count(), 0);
    }
}
