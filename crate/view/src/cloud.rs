//! The points as the renderer keeps them: in shuffled order, with their bounds and spacing.

use glam::Vec3;

/// An axis-aligned box. Empty until a point is added.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    min: Vec3,
    max: Vec3,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            min: Vec3::INFINITY,
            max: Vec3::NEG_INFINITY,
        }
    }
}

impl Bounds {
    /// The box between two corners.
    pub fn new(min: Vec3, max: Vec3) -> Self {
        Self { min, max }
    }

    /// The box of some points; those that are not finite do not count.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        let mut bounds = Self::default();
        for point in points.into_iter().filter(|point| point.is_finite()) {
            bounds.min = bounds.min.min(point);
            bounds.max = bounds.max.max(point);
        }
        bounds
    }

    /// Whether there is no point in it.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The middle; the origin for an empty box.
    pub fn centre(&self) -> Vec3 {
        if self.is_empty() {
            return Vec3::ZERO;
        }
        self.min.midpoint(self.max)
    }

    /// Length of the diagonal; zero for an empty box.
    pub fn diagonal(&self) -> f32 {
        if self.is_empty() {
            return 0.0;
        }
        self.min.distance(self.max)
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|corner| {
            let pick =
                |bit: usize, min: f32, max: f32| if corner >> bit & 1 == 0 { min } else { max };
            Vec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }
}

/// The points of one model, in a random order. Any prefix of it is an even sample of the whole,
/// which is what is drawn while the camera moves if all the points would take too long.
#[derive(Debug, Default)]
pub struct Cloud {
    positions: Vec<Vec3>,
    order: Vec<u32>,
    bounds: Bounds,
    spacing: f32,
}

impl Cloud {
    /// A cloud from x y z x y z …; an incomplete last point is dropped. A point that is not
    /// finite keeps its index and is never seen. O(n).
    pub fn new(coordinates: &[f32]) -> Self {
        let (given, _) = coordinates.as_chunks::<3>();
        let order = shuffled(u32::try_from(given.len()).unwrap_or(u32::MAX));
        let positions: Vec<Vec3> = order
            .iter()
            .filter_map(|&index| given.get(index as usize).copied().map(Vec3::from_array))
            .collect();
        let bounds = Bounds::of(positions.iter().copied());
        let spacing = spacing(&positions, &bounds);
        Self {
            positions,
            order,
            bounds,
            spacing,
        }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are no points.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The positions, shuffled.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// For each shuffled point, its index as it was given.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The box around all the points.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Typical distance between neighbouring points (a median over a sample).
    pub fn spacing(&self) -> f32 {
        self.spacing
    }

    /// Values given per point, brought into the shuffled order; `missing` where there are too few.
    pub fn arrange<T: Copy>(&self, values: &[T], missing: T) -> Vec<T> {
        self.order
            .iter()
            .map(|&index| values.get(index as usize).copied().unwrap_or(missing))
            .collect()
    }
}

/// A random permutation of 0‥n, the same on every machine (Fisher and Yates; splitmix64).
fn shuffled(n: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n).collect();
    let mut state = 0x5fee_d1e5_u64;
    for last in (1..order.len()).rev() {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        // Multiply and shift brings 32 random bits into 0..=last.
        let other = ((bits >> 32) * (last as u64 + 1)) >> 32;
        order.swap(last, other as usize);
    }
    order
}

/// Median distance from a point to its fourth nearest other place, over a sample that shrinks as
/// the cloud grows: the search is by brute force and looks at about 20 million pairs at most
/// (20 ms). Four, because that is the pitch of a square grid, the larger pitch of an oblong one and,
/// for points scattered at random, the side of the square that each has to itself.
fn spacing(shuffled: &[Vec3], bounds: &Bounds) -> f32 {
    const PAIRS: usize = 20_000_000;
    let sample = (PAIRS / shuffled.len().max(1)).clamp(1, 256);
    // Squares are not negative, so that their bits are in their order: whole numbers have one sort, compiled once.
    let mut squares: Vec<u32> = shuffled
        .iter()
        .take(sample)
        .map(|point| fourth_nearest(point, shuffled))
        .filter(|square| square.is_finite())
        .map(f32::to_bits)
        .collect();
    squares.sort_unstable();
    match squares.get(squares.len() / 2) {
        Some(&square) => f32::from_bits(square).sqrt(),
        None => bounds.diagonal() * 0.01,
    }
}

/// Square of the distance to the fourth nearest point in another place; infinite where there is none.
fn fourth_nearest(point: &Vec3, points: &[Vec3]) -> f32 {
    let mut nearest = [f32::INFINITY; 4];
    for other in points {
        let mut square = point.distance_squared(*other);
        if square > 0.0 && square < nearest[3] {
            for place in &mut nearest {
                if square < *place {
                    std::mem::swap(place, &mut square);
                }
            }
        }
    }
    nearest[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(side: usize) -> Vec<f32> {
        (0..side * side)
            .flat_map(|cell| [(cell % side) as f32, (cell / side) as f32, 0.0])
            .collect()
    }

    #[test]
    fn the_order_is_a_permutation() {
        let mut order = shuffled(1000);
        assert_ne!(order, (0..1000).collect::<Vec<_>>());
        order.sort_unstable();
        assert_eq!(order, (0..1000).collect::<Vec<_>>());
    }

    #[test]
    fn every_prefix_samples_the_cloud_evenly() {
        let cloud = Cloud::new(&grid(100));
        let left = cloud.positions()[..1000].iter().filter(|p| p.x < 50.0);
        let count = left.count();
        assert!((430..570).contains(&count), "{count} of 1000 in one half");
    }

    #[test]
    fn the_spacing_of_a_grid_is_its_pitch() {
        assert_eq!(Cloud::new(&grid(40)).spacing(), 1.0);
    }

    #[test]
    fn the_spacing_of_an_oblong_grid_is_its_larger_pitch() {
        let mut oblong = grid(40);
        oblong.iter_mut().step_by(3).for_each(|x| *x *= 0.5);
        assert_eq!(Cloud::new(&oblong).spacing(), 1.0);
    }

    #[test]
    fn points_in_one_place_have_some_spacing_and_do_not_divide_by_zero() {
        assert_eq!(Cloud::new(&[1.0; 30]).spacing(), 0.0);
        assert_eq!(Cloud::new(&[]).spacing(), 0.0);
    }

    #[test]
    fn values_follow_their_points() {
        let cloud = Cloud::new(&grid(10));
        let numbers: Vec<u32> = (0..100).collect();
        for (value, position) in cloud.arrange(&numbers, 0).iter().zip(cloud.positions()) {
            assert_eq!(*value as f32, position.x + 10.0 * position.y);
        }
    }

    #[test]
    fn missing_values_are_filled_and_extra_ones_ignored() {
        let cloud = Cloud::new(&grid(2));
        let mut few = cloud.arrange(&[7], 9);
        few.sort_unstable();
        assert_eq!(few, [7, 9, 9, 9]);
        assert_eq!(cloud.arrange(&[1; 50], 0), [1; 4]);
    }

    #[test]
    fn bounds_ignore_what_is_not_finite() {
        let cloud = Cloud::new(&[0.0, 0.0, 0.0, f32::NAN, 1.0, 1.0, 2.0, 4.0, 4.0, 9.0]);
        assert_eq!(cloud.len(), 3);
        assert_eq!(cloud.bounds().diagonal(), 6.0);
        assert!(Cloud::new(&[]).bounds().is_empty());
    }
}
