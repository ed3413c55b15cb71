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
/// which is what is drawn while the camera moves if all the points would take too long, and while
/// the points are still being brought into that order.
///
/// To shuffle millions of points takes longer than a frame: [`Cloud::new`] only measures them, and
/// [`Cloud::proceed`] does the rest in pieces.
#[derive(Debug, Default)]
pub struct Cloud {
    /// x y z as they were given; none once all are in order.
    given: Vec<f32>,
    positions: Vec<Vec3>,
    shuffle: Shuffle,
    bounds: Bounds,
    pitch: Pitch,
}

impl Cloud {
    /// A cloud from x y z x y z …; an incomplete last point is dropped. A point that is not
    /// finite keeps its index and is never seen. None of the points is in order yet. O(n).
    pub fn new(coordinates: Vec<f32>) -> Self {
        let (given, _) = coordinates.as_chunks::<3>();
        let bounds = Bounds::of(given.iter().copied().map(Vec3::from_array));
        let count = u32::try_from(given.len()).unwrap_or(u32::MAX);
        Self {
            positions: Vec::with_capacity(given.len()),
            shuffle: Shuffle::of(count),
            given: coordinates,
            bounds,
            pitch: Pitch::default(),
        }
    }

    /// Number of points, in order or not.
    pub fn len(&self) -> usize {
        self.shuffle.order.len()
    }

    /// Whether there are no points.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether all points are in order.
    pub fn is_ready(&self) -> bool {
        self.positions.len() == self.len()
    }

    /// Brings more points into order, about as many as are asked for; the spacing is found before the
    /// first of them.
    pub fn proceed(&mut self, points: usize) {
        let (given, _) = self.given.as_chunks::<3>();
        let mut left = points;
        while left > 0 && !self.pitch.is_found(given) {
            self.pitch.look(given, &mut self.shuffle);
            // To look at a point takes a fraction of what it takes to bring one into order.
            left = left.saturating_sub(given.len() / 4 + 1);
        }
        let end = self.positions.len().saturating_add(left).min(given.len());
        for place in self.positions.len()..end {
            let point = self.shuffle.at(place).and_then(|index| given.get(index));
            let point = point.copied().map_or(Vec3::NAN, Vec3::from_array);
            self.positions.push(point);
        }
        if self.is_ready() {
            self.given = Vec::new();
        }
    }

    /// The positions, shuffled, as far as they are in order.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// For each point of [`Cloud::positions`], its index as it was given.
    pub fn order(&self) -> &[u32] {
        let all = &self.shuffle.order;
        all.get(..self.positions.len()).unwrap_or_default()
    }

    /// The box around all the points.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Typical distance between neighbouring points (a median over a sample); 0 before any point is
    /// in order.
    pub fn spacing(&self) -> f32 {
        match self.pitch.median() {
            Some(spacing) => spacing,
            None => self.bounds.diagonal() * 0.01,
        }
    }
}

/// Values given per point, on their way into the shuffled order of a [`Cloud`].
#[derive(Debug)]
pub struct Arranged<G, T> {
    /// So many numbers for each point; none once all are in order.
    given: Vec<G>,
    width: usize,
    values: Vec<T>,
    /// The value of a point by its numbers, of which there are none where it was given none.
    value: fn(&[G]) -> T,
    is_wanted: bool,
}

impl<G, T> Arranged<G, T> {
    /// No values at all: no point has one.
    pub fn none(value: fn(&[G]) -> T) -> Self {
        Self {
            given: Vec::new(),
            width: 0,
            values: Vec::new(),
            value,
            is_wanted: false,
        }
    }

    /// As many numbers for each point as `width` says, in the order the points were given; those beyond the
    /// last point are ignored.
    pub fn of(given: Vec<G>, width: usize, value: fn(&[G]) -> T) -> Self {
        Self {
            given,
            width,
            values: Vec::new(),
            value,
            is_wanted: true,
        }
    }

    /// Whether points have values.
    pub fn is_wanted(&self) -> bool {
        self.is_wanted
    }

    /// Whether as many are in order as there are points.
    pub fn is_ready(&self, cloud: &Cloud) -> bool {
        !self.is_wanted || self.values.len() == cloud.len()
    }

    /// Brings as many more into order as are asked for, and not more than there are points in order.
    pub fn proceed(&mut self, cloud: &Cloud, points: usize) {
        if self.is_ready(cloud) {
            return;
        }
        let width = self.width;
        let more = cloud.order().iter().skip(self.values.len()).take(points);
        let values = more.map(|&index| {
            let start = index as usize * width;
            (self.value)(self.given.get(start..start + width).unwrap_or_default())
        });
        self.values.extend(values);
        if self.is_ready(cloud) {
            self.given = Vec::new();
        }
    }

    /// The values, shuffled, as far as they are in order.
    pub fn values(&self) -> &[T] {
        &self.values
    }
}

/// A random permutation of 0‥n, the same on every machine (Fisher and Yates; splitmix64), drawn from its
/// front as far as it is asked for.
#[derive(Debug, Default)]
struct Shuffle {
    order: Vec<u32>,
    /// As many from the front are where they stay.
    settled: usize,
    state: u64,
}

impl Shuffle {
    fn of(count: u32) -> Self {
        Self {
            order: (0..count).collect(),
            settled: 0,
            state: 0x5fee_d1e5,
        }
    }

    /// What is at a place; nothing beyond the last.
    fn at(&mut self, place: usize) -> Option<usize> {
        let end = place.saturating_add(1).min(self.order.len());
        for next in self.settled..end {
            let other = next + self.below(self.order.len() - next);
            self.order.swap(next, other);
        }
        self.settled = self.settled.max(end);
        self.order.get(place).map(|&index| index as usize)
    }

    /// A random number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        // Multiply and shift brings 32 random bits below the end.
        (((bits >> 32) * end as u64) >> 32) as usize
    }
}

/// Median distance from a point to its fourth nearest other place, over a sample that shrinks as
/// the cloud grows: the search is by brute force and looks at about 20 million pairs at most
/// (20 ms), one point of the sample at a time. Four, because that is the pitch of a square grid, the
/// larger pitch of an oblong one and, for points scattered at random, the side of the square that each
/// has to itself.
#[derive(Debug, Default)]
struct Pitch {
    /// Squares of the distances found, as bits: squares are not negative, so that their bits are in their
    /// order, and whole numbers have one sort, compiled once.
    squares: Vec<u32>,
    /// How many points of the sample have been looked at: the first of the shuffled ones.
    looked: usize,
}

impl Pitch {
    fn is_found(&self, points: &[[f32; 3]]) -> bool {
        const PAIRS: usize = 20_000_000;
        let sample = (PAIRS / points.len().max(1)).clamp(1, 256);
        self.looked >= sample.min(points.len())
    }

    /// Looks at one point more.
    fn look(&mut self, points: &[[f32; 3]], shuffle: &mut Shuffle) {
        let point = shuffle
            .at(self.looked)
            .and_then(|index| points.get(index))
            .map(|&point| fourth_nearest(Vec3::from_array(point), points));
        if let Some(square) = point.filter(|square| square.is_finite()) {
            self.squares.push(square.to_bits());
            self.squares.sort_unstable();
        }
        self.looked += 1;
    }

    fn median(&self) -> Option<f32> {
        let middle = self.squares.get(self.squares.len() / 2);
        middle.map(|&square| f32::from_bits(square).sqrt())
    }
}

/// Square of the distance to the fourth nearest point in another place; infinite where there is none.
fn fourth_nearest(point: Vec3, points: &[[f32; 3]]) -> f32 {
    let mut nearest = [f32::INFINITY; 4];
    for &other in points {
        let mut square = point.distance_squared(Vec3::from_array(other));
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

    fn ready(coordinates: &[f32]) -> Cloud {
        let mut cloud = Cloud::new(coordinates.to_vec());
        cloud.proceed(usize::MAX);
        cloud
    }

    fn label(given: &[u32]) -> u32 {
        given.first().copied().unwrap_or(9)
    }

    fn arranged(cloud: &Cloud, labels: &[u32]) -> Vec<u32> {
        let mut values = Arranged::of(labels.to_vec(), 1, label);
        values.proceed(cloud, usize::MAX);
        values.values().to_vec()
    }

    #[test]
    fn the_order_is_a_permutation() {
        let cloud = ready(&[0.0; 3000]);
        let mut order = cloud.order().to_vec();
        assert_ne!(order, (0..1000).collect::<Vec<_>>());
        order.sort_unstable();
        assert_eq!(order, (0..1000).collect::<Vec<_>>());
    }

    #[test]
    fn every_prefix_samples_the_cloud_evenly() {
        let cloud = ready(&grid(100));
        let left = cloud.positions()[..1000].iter().filter(|p| p.x < 50.0);
        let count = left.count();
        assert!((430..570).contains(&count), "{count} of 1000 in one half");
    }

    #[test]
    fn in_pieces_a_cloud_becomes_what_it_is_at_once() {
        let (whole, mut cloud) = (ready(&grid(100)), Cloud::new(grid(100)));
        let labels: Vec<u32> = (0..10_000).collect();
        let mut values = Arranged::of(labels.clone(), 1, label);
        let mut pieces = 0;
        while !values.is_ready(&cloud) {
            cloud.proceed(3000);
            values.proceed(&cloud, 2000);
            let ready = cloud.positions().len();
            assert_eq!(cloud.positions(), &whole.positions()[..ready]);
            assert_eq!(cloud.order(), &whole.order()[..ready]);
            assert!(values.values().len() <= ready);
            pieces += 1;
        }
        assert!(pieces > 5, "{pieces}");
        assert!(cloud.is_ready());
        assert_eq!(cloud.spacing(), whole.spacing());
        assert_eq!(values.values(), arranged(&whole, &labels));
    }

    #[test]
    fn the_spacing_is_known_before_the_first_point() {
        let mut cloud = Cloud::new(grid(300));
        while cloud.positions().is_empty() {
            cloud.proceed(10_000);
        }
        assert!(!cloud.is_ready());
        assert_eq!(cloud.spacing(), 1.0);
    }

    #[test]
    fn the_spacing_of_a_grid_is_its_pitch() {
        assert_eq!(ready(&grid(40)).spacing(), 1.0);
    }

    #[test]
    fn the_spacing_of_an_oblong_grid_is_its_larger_pitch() {
        let mut oblong = grid(40);
        oblong.iter_mut().step_by(3).for_each(|x| *x *= 0.5);
        assert_eq!(ready(&oblong).spacing(), 1.0);
    }

    #[test]
    fn points_in_one_place_have_some_spacing_and_do_not_divide_by_zero() {
        assert_eq!(ready(&[1.0; 30]).spacing(), 0.0);
        assert_eq!(ready(&[]).spacing(), 0.0);
    }

    #[test]
    fn values_follow_their_points() {
        let cloud = ready(&grid(10));
        let numbers: Vec<u32> = (0..100).collect();
        for (value, position) in arranged(&cloud, &numbers).iter().zip(cloud.positions()) {
            assert_eq!(*value as f32, position.x + 10.0 * position.y);
        }
    }

    #[test]
    fn missing_values_are_filled_and_extra_ones_ignored() {
        let cloud = ready(&grid(2));
        let mut few = arranged(&cloud, &[7]);
        few.sort_unstable();
        assert_eq!(few, [7, 9, 9, 9]);
        assert_eq!(arranged(&cloud, &[1; 50]), [1; 4]);
    }

    #[test]
    fn bounds_ignore_what_is_not_finite() {
        let cloud = ready(&[0.0, 0.0, 0.0, f32::NAN, 1.0, 1.0, 2.0, 4.0, 4.0, 9.0]);
        assert_eq!(cloud.len(), 3);
        assert_eq!(cloud.bounds().diagonal(), 6.0);
        assert!(ready(&[]).bounds().is_empty());
    }
}
