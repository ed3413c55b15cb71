//! Which boxes a viewpoint sees in each direction.

use fit4cad::cloud::{Point, Vector};

use crate::placement::Frame;

/// Bins along each side of what the viewpoint sees.
const SIDE: usize = 64;

/// The numbers of boxes, by the bins of the picture that each may cover.
pub(super) struct Bins {
    eye: Frame,
    /// Bins for one unit across at a distance of one.
    scale: f64,
    lists: Vec<Vec<u32>>,
}

impl Bins {
    /// Of boxes about a middle, none of whose corners lies farther from it than `radius`. O(boxes · bins that
    /// each covers).
    pub fn new(eye: Point, middle: Point, radius: f64, boxes: &[[Point; 8]]) -> Self {
        let ahead = middle - eye;
        // The sphere about the middle, seen from the eye, is as wide on either side.
        let sin = (radius / ahead.norm()).min(0.9);
        let wide = sin / (1.0 - sin * sin).sqrt();
        let frame = Frame::new(eye, ahead, None);
        let mut bins = Self {
            eye: frame.unwrap_or(Frame {
                origin: eye,
                x: Vector::x(),
                y: Vector::y(),
                z: Vector::z(),
            }),
            scale: SIDE as f64 / (2.0 * wide),
            lists: vec![Vec::new(); SIDE * SIDE],
        };
        for (index, corners) in (0_u32..).zip(boxes) {
            let places = corners.map(|corner| bins.bin(&corner));
            let range = |k: usize| {
                let of = places.iter().map(|it| it[k]);
                of.clone().min().unwrap_or(0)..=of.max().unwrap_or(SIDE - 1)
            };
            for row in range(0) {
                for column in range(1) {
                    bins.lists[row * SIDE + column].push(index);
                }
            }
        }
        bins
    }

    /// The boxes that may lie in the direction of a place.
    pub fn towards(&self, place: &Point) -> &[u32] {
        let [row, column] = self.bin(place);
        &self.lists[row * SIDE + column]
    }

    fn bin(&self, place: &Point) -> [usize; 2] {
        let [x, y, z] = self.eye.enter(place);
        [x, y].map(|it| {
            let across = it / z * self.scale + 0.5 * SIDE as f64;
            // What is no number goes to the first.
            (across.max(0.0) as usize).min(SIDE - 1)
        })
    }
}
