//! From a curve drawn on the screen to a region of space. Pure geometry.

use glam::{Vec2, Vec3};
use tsify::Tsify;

use crate::camera::{Camera, Projection};
use crate::layout::Rect;

/// How far from the curve a corner that is left out may lie, in pixels of the page: less than the
/// eye can tell.
const TOLERANCE: f32 = 0.75;
/// As many corners as the engine takes.
const MAX_CORNERS: usize = 1000;

/// A polygon in the plane through a camera's target, swept along its lines of sight. Places are
/// relative to the cloud's centre.
#[derive(Debug, Clone, PartialEq, Tsify)]
pub struct Lasso {
    /// The point that the camera looks at.
    pub target: [f32; 3],
    /// Unit quaternion x y z w: from the camera's axes to the cloud's.
    pub rotation: [f32; 4],
    /// Distance of the eye from the target; infinite where lines of sight are parallel.
    pub eye: f32,
    /// How far beyond the target it reaches; may be infinite.
    pub depth: f32,
    /// x y in the camera's axes, joined first to last and back.
    pub corners: Vec<[f32; 2]>,
}

impl Lasso {
    /// The region that a closed curve (x y in device pixels) on a view encloses, all the way
    /// through; `None` where it encloses nothing. O(n log n) as a rule, O(n²) at worst, for n
    /// places of the curve.
    pub fn drawn(
        curve: &[Vec2],
        viewport: &Rect,
        camera: &Camera,
        pixel_ratio: f32,
    ) -> Option<Self> {
        let finite = curve.iter().all(|place| place.is_finite());
        if !finite || viewport.height <= 0 {
            return None;
        }
        let corners = outline(curve, TOLERANCE * pixel_ratio, MAX_CORNERS);
        if corners.len() < 3 {
            return None;
        }
        let middle = Vec2::new(
            viewport.x as f32 + viewport.width as f32 * 0.5,
            viewport.y as f32 + viewport.height as f32 * 0.5,
        );
        let unit = camera.height / viewport.height as f32;
        let in_plane = |corner: &Vec2| ((*corner - middle) * unit).to_array();
        Some(Self {
            target: camera.target.to_array(),
            rotation: camera.rotation.to_array(),
            eye: match camera.projection {
                Projection::Perspective => camera.distance(),
                Projection::Orthographic => f32::INFINITY,
            },
            depth: f32::INFINITY,
            corners: corners.iter().map(in_plane).collect(),
        })
    }

    /// The same no deeper than the deepest of some points and a margin. Without points it reaches
    /// nothing.
    pub fn down_to(self, points: impl Iterator<Item = Vec3>, camera: &Camera, margin: f32) -> Self {
        let depths = points.map(|point| (camera.target - point).dot(camera.back()));
        Self {
            depth: depths.fold(f32::NEG_INFINITY, f32::max) + margin,
            ..self
        }
    }
}

/// A curve with fewer corners, none of those left out farther from it than a tolerance (Douglas and
/// Peucker 1973). Where more than `most` would be left, the tolerance doubles until they are few.
fn outline(curve: &[Vec2], tolerance: f32, most: usize) -> Vec<Vec2> {
    let mut tolerance = tolerance.max(f32::MIN_POSITIVE);
    loop {
        let simple = simplified(curve, tolerance);
        if simple.len() <= most {
            return simple;
        }
        tolerance *= 2.0;
    }
}

fn simplified(curve: &[Vec2], tolerance: f32) -> Vec<Vec2> {
    let Some(last) = curve.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut kept = vec![false; curve.len()];
    let mut keep = |at: usize| {
        if let Some(flag) = kept.get_mut(at) {
            *flag = true;
        }
    };
    keep(0);
    keep(last);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let (Some(&a), Some(&b)) = (curve.get(from), curve.get(to)) else {
            continue;
        };
        let between = curve.iter().enumerate().take(to).skip(from + 1);
        let distances = between.map(|(at, &place)| (at, distance_to(place, a, b)));
        let farthest = distances.max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((at, _)) = farthest.filter(|&(_, distance)| distance > tolerance) {
            keep(at);
            open.extend([(from, at), (at, to)]);
        }
    }
    let corners = curve.iter().zip(&kept).filter(|(_, kept)| **kept);
    corners.map(|(place, _)| *place).collect()
}

/// From a place to the line between two others.
fn distance_to(place: Vec2, a: Vec2, b: Vec2) -> f32 {
    let along = b - a;
    let square = along.length_squared();
    let share = if square > 0.0 {
        ((place - a).dot(along) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    place.distance(a + along * share)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::camera::Standpoint;

    const VIEWPORT: Rect = Rect {
        x: 100,
        y: 0,
        width: 200,
        height: 100,
    };

    fn places(corners: &[[f32; 2]]) -> Vec<Vec2> {
        corners.iter().copied().map(Vec2::from_array).collect()
    }

    /// From the front, 10 units high.
    fn camera(projection: Projection) -> Camera {
        Camera {
            target: Vec3::new(1.0, 2.0, 3.0),
            rotation: Standpoint::Front.rotation(),
            height: 10.0,
            projection,
        }
    }

    #[test]
    fn corners_are_lengths_in_the_plane_of_the_target() {
        let curve = places(&[[200.0, 50.0], [300.0, 50.0], [300.0, 100.0], [200.0, 100.0]]);
        let camera = camera(Projection::Orthographic);
        let lasso = Lasso::drawn(&curve, &VIEWPORT, &camera, 1.0).unwrap();
        assert_eq!(
            lasso.corners,
            [[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [0.0, 5.0]]
        );
        assert_eq!(lasso.target, [1.0, 2.0, 3.0]);
        assert_eq!((lasso.eye, lasso.depth), (f32::INFINITY, f32::INFINITY));
    }

    #[test]
    fn the_eye_of_a_perspective_camera_sees_the_height_under_its_field_of_view() {
        let curve = places(&[[200.0, 50.0], [300.0, 50.0], [300.0, 100.0]]);
        let lasso = Lasso::drawn(&curve, &VIEWPORT, &camera(Projection::Perspective), 1.0);
        let eye = lasso.unwrap().eye;
        assert!((2.0 * eye * (crate::camera::FIELD_OF_VIEW / 2.0).tan() - 10.0).abs() < 1e-5);
    }

    #[test]
    fn it_reaches_a_margin_beyond_the_deepest_point() {
        let curve = places(&[[200.0, 50.0], [300.0, 50.0], [300.0, 100.0]]);
        let camera = camera(Projection::Orthographic);
        let lasso = Lasso::drawn(&curve, &VIEWPORT, &camera, 1.0).unwrap();
        // From the front the line of sight is +y: depth is y beyond the target's 2.
        let points = [Vec3::new(0.0, 5.0, 9.0), Vec3::new(-4.0, -1.0, 0.0)];
        let depth = lasso
            .clone()
            .down_to(points.into_iter(), &camera, 0.5)
            .depth;
        assert!((depth - 3.5).abs() < 1e-5, "{depth}");
        assert_eq!(
            lasso.down_to(std::iter::empty(), &camera, 0.5).depth,
            f32::NEG_INFINITY
        );
    }

    #[test]
    fn a_curve_that_encloses_nothing_is_no_lasso() {
        let camera = camera(Projection::Perspective);
        let drawn = |curve: &[[f32; 2]]| Lasso::drawn(&places(curve), &VIEWPORT, &camera, 1.0);
        assert_eq!(drawn(&[]), None);
        assert_eq!(drawn(&[[1.0, 1.0]; 50]), None);
        assert_eq!(drawn(&[[0.0, 0.0], [5.0, 0.1], [9.0, 0.0]]), None);
        assert_eq!(drawn(&[[0.0, 0.0], [f32::NAN, 0.0], [9.0, 9.0]]), None);
    }

    #[test]
    fn a_scribble_keeps_no_more_corners_than_the_engine_takes() {
        let zigzag: Vec<Vec2> = (0..5000)
            .map(|at| Vec2::new(at as f32, (at % 2 * 40) as f32))
            .collect();
        let lasso = Lasso::drawn(&zigzag, &VIEWPORT, &camera(Projection::Perspective), 1.0);
        assert!(lasso.is_none_or(|lasso| lasso.corners.len() <= MAX_CORNERS));
        assert!(outline(&zigzag, 0.75, 1000).len() <= 1000);
    }

    proptest! {
        #[test]
        fn what_is_left_out_lies_within_the_tolerance(
            curve in prop::collection::vec(prop::array::uniform2(0.0_f32..100.0), 2..60),
        ) {
            let curve = places(&curve);
            let simple = simplified(&curve, 2.0);
            for place in &curve {
                let pieces = simple.windows(2);
                let nearest = pieces.map(|piece| distance_to(*place, piece[0], piece[1]));
                prop_assert!(nearest.fold(f32::INFINITY, f32::min) <= 2.0 + 1e-4);
            }
        }
    }
}
