//! The camera: where it stands, what it sees, and the matrices that say so. Pure geometry.

use glam::{Mat3, Mat4, Quat, Vec3};
use tsify::Tsify;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::cloud::Bounds;

/// Vertical field of view of the perspective camera, in radians. Narrow, as for product
/// photography: CAD parts keep their proportions.
pub const FIELD_OF_VIEW: f32 = 0.52;

/// Share of the viewport that a framed box leaves free, so that nothing touches the border.
const MARGIN: f32 = 1.08;

/// Visible heights outside this range, in cloud units, would overflow or vanish in f32 when squared.
pub(crate) const HEIGHT_RANGE: (f32, f32) = (1e-18, 1e18);

/// How depth is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Projection {
    /// What is near looks larger.
    #[default]
    Perspective,
    /// Parallel lines stay parallel.
    Orthographic,
}

/// The directions a camera can be asked to look from. The z axis points up in the four sides.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standpoint {
    /// From −y.
    Front,
    /// From +y.
    Back,
    /// From −x.
    Left,
    /// From +x.
    Right,
    /// From +z, y up.
    Top,
    /// From −z, y down, as a page turned over its x axis.
    Bottom,
    /// From (1, −1, 1), so that the three axes make equal angles.
    Isometric,
}

impl Standpoint {
    /// All of them, in the order of the numbers the page uses.
    pub const ALL: [Self; 7] = [
        Self::Front,
        Self::Back,
        Self::Left,
        Self::Right,
        Self::Top,
        Self::Bottom,
        Self::Isometric,
    ];

    /// Rotation of a camera that stands there.
    pub fn rotation(self) -> Quat {
        let (back, up) = match self {
            Self::Front => (Vec3::NEG_Y, Vec3::Z),
            Self::Back => (Vec3::Y, Vec3::Z),
            Self::Left => (Vec3::NEG_X, Vec3::Z),
            Self::Right => (Vec3::X, Vec3::Z),
            Self::Top => (Vec3::Z, Vec3::Y),
            Self::Bottom => (Vec3::NEG_Z, Vec3::NEG_Y),
            Self::Isometric => (Vec3::new(1.0, -1.0, 1.0), Vec3::Z),
        };
        let back = back.normalize();
        let right = up.cross(back).normalize();
        Quat::from_mat3(&Mat3::from_cols(right, back.cross(right), back)).normalize()
    }
}

/// A camera that looks at a target. The visible height at the target, not a distance, is the
/// measure of zoom: it means the same in both projections, so switching keeps the size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The point in the middle of the viewport, about which the camera turns.
    pub target: Vec3,
    /// Rotation from camera axes (x right, y up, z towards the viewer) to the cloud's axes. Unit.
    pub rotation: Quat,
    /// Height of the viewport in cloud units, measured in the plane of the target. Positive.
    pub height: f32,
    /// Perspective or orthographic.
    pub projection: Projection,
}

/// A camera as plain numbers, for links. Positions are relative to the cloud's centre.
#[derive(Debug, Clone, Copy, PartialEq, Tsify)]
pub struct CameraState {
    /// The point in the middle of the view.
    #[tsify(type = "readonly [number, number, number]")]
    pub target: [f32; 3],
    /// Unit quaternion x y z w: from the camera's axes to the cloud's.
    #[tsify(type = "readonly [number, number, number, number]")]
    pub rotation: [f32; 4],
    /// Visible height at the target, in the cloud's units.
    pub height: f32,
    /// How depth is shown.
    pub projection: Projection,
}

/// What the shaders need to know of a camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lens {
    /// From cloud coordinates to clip coordinates.
    pub view_projection: Mat4,
    /// Distance of the near plane from the eye, along the line of sight.
    pub near: f32,
    /// Distance of the far plane.
    pub far: f32,
    /// Where the eye is (for the orthographic camera: a point on the line of sight).
    pub eye: Vec3,
    /// Pixels that one cloud unit covers at clip w = 1.
    pub scale: f32,
    /// Distance from the eye to the target.
    pub reference: f32,
    /// Whether rays meet in the eye.
    pub perspective: bool,
    /// Rotation of the camera.
    pub rotation: Quat,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: Vec3::ZERO,
            rotation: Standpoint::Isometric.rotation(),
            height: 1.0,
            projection: Projection::Perspective,
        }
    }
}

impl Camera {
    /// Unit vector to the right of the viewport.
    pub fn right(&self) -> Vec3 {
        self.rotation * Vec3::X
    }

    /// Unit vector to the top of the viewport.
    pub fn up(&self) -> Vec3 {
        self.rotation * Vec3::Y
    }

    /// Unit vector from the target to the eye.
    pub fn back(&self) -> Vec3 {
        self.rotation * Vec3::Z
    }

    /// Distance from eye to target: where the viewport shows [`Camera::height`].
    pub fn distance(&self) -> f32 {
        self.height * 0.5 / (FIELD_OF_VIEW * 0.5).tan()
    }

    /// Where the eye is.
    pub fn eye(&self) -> Vec3 {
        self.target + self.back() * self.distance()
    }

    /// Matrices for a viewport of the given size in pixels. The near and far plane enclose the
    /// bounds as tightly as they can, which is what gives the depth buffer its resolution.
    pub fn lens(&self, width: f32, height: f32, bounds: &Bounds) -> Lens {
        let (width, height) = (width.max(1.0), height.max(1.0));
        let aspect = width / height;
        let eye = self.eye();
        let radius = (bounds.diagonal() * 0.5).max(self.height * 1e-3) * 1.01;
        let middle = (eye - bounds.centre()).dot(self.back());
        let far = (middle + radius).max(self.distance() * 2e-3);
        let view = Mat4::from_rotation_translation(self.rotation, eye).inverse();
        let (near, projection, scale) = match self.projection {
            Projection::Perspective => {
                let near = (middle - radius)
                    .max(far * 1e-3)
                    .max(self.distance() * 1e-3);
                let far = far.max(near * 1.001);
                (
                    near,
                    Mat4::perspective_rh_gl(FIELD_OF_VIEW, aspect, near, far),
                    self.distance() / self.height * height,
                )
            }
            Projection::Orthographic => {
                let near = middle - radius;
                let half = self.height * 0.5;
                let (left, right) = (-half * aspect, half * aspect);
                (
                    near,
                    Mat4::orthographic_rh_gl(left, right, -half, half, near, middle + radius),
                    height / self.height,
                )
            }
        };
        Lens {
            view_projection: projection * view,
            near,
            far: match self.projection {
                Projection::Perspective => far.max(near * 1.001),
                Projection::Orthographic => middle + radius,
            },
            eye,
            scale,
            reference: self.distance(),
            rotation: self.rotation,
            perspective: self.projection == Projection::Perspective,
        }
    }

    /// The same camera moved and zoomed so that a box just fits a viewport of that aspect
    /// (width / height). An empty box leaves the camera alone.
    pub fn framing(&self, bounds: &Bounds, aspect: f32) -> Self {
        if bounds.is_empty() || aspect.is_nan() || aspect <= 0.0 {
            return *self;
        }
        let target = bounds.centre();
        let (right, up, back) = (self.right(), self.up(), self.back());
        let slope = (FIELD_OF_VIEW * 0.5).tan();
        let mut height = 0.0_f32;
        for corner in bounds.corners() {
            let offset = corner - target;
            let half = offset.dot(up).abs().max(offset.dot(right).abs() / aspect);
            // A corner nearer to the eye than the target looks larger by its depth times the slope.
            let nearer = match self.projection {
                Projection::Perspective => offset.dot(back) * slope,
                Projection::Orthographic => 0.0,
            };
            height = height.max(2.0 * (half + nearer));
        }
        // A single point has no size to go by: stay at the present zoom.
        let height = if height > 0.0 {
            height * MARGIN
        } else {
            self.height
        };
        Self {
            target,
            height: clamp_height(height),
            ..*self
        }
    }

    /// The camera at a standpoint, with the same target and zoom.
    pub fn from_standpoint(&self, standpoint: Standpoint) -> Self {
        Self {
            rotation: standpoint.rotation(),
            ..*self
        }
    }

    /// Part of the way to another camera: `share` 0 is this one, 1 the other. The zoom changes by
    /// equal factors in equal times. The projection is the other's throughout.
    pub fn towards(&self, other: &Self, share: f32) -> Self {
        let share = share.clamp(0.0, 1.0);
        if share.is_nan() || share >= 1.0 {
            return *other;
        }
        Self {
            target: self.target.lerp(other.target, share),
            rotation: self.rotation.slerp(other.rotation, share).normalize(),
            height: clamp_height(self.height * (other.height / self.height).powf(share)),
            projection: other.projection,
        }
    }

    /// As plain numbers.
    pub fn state(&self) -> CameraState {
        CameraState {
            target: self.target.to_array(),
            rotation: self.rotation.to_array(),
            height: self.height,
            projection: self.projection,
        }
    }

    /// From the numbers of [`Camera::state`]. `None` where they are no camera: not finite, no
    /// rotation or no height.
    pub fn from_state(state: &CameraState) -> Option<Self> {
        let target = Vec3::from_array(state.target);
        let rotation = Quat::from_array(state.rotation);
        let length = rotation.length_squared();
        let usable = target.is_finite()
            // Of finite numbers, but not of a finite length, it would become no rotation.
            && length.is_finite()
            && length > 1e-12
            && state.height > 0.0
            && state.height.is_finite();
        usable.then(|| Self {
            target,
            rotation: rotation.normalize(),
            height: clamp_height(state.height),
            projection: state.projection,
        })
    }
}

/// A height that f32 arithmetic survives.
pub(crate) fn clamp_height(height: f32) -> f32 {
    height.clamp(HEIGHT_RANGE.0, HEIGHT_RANGE.1)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn unit_box() -> Bounds {
        Bounds::new(Vec3::ZERO, Vec3::ONE)
    }

    fn clip(lens: &Lens, point: Vec3) -> Vec3 {
        lens.view_projection.project_point3(point)
    }

    #[test]
    fn from_the_front_x_runs_right_and_z_runs_up() {
        let camera = Camera::default().from_standpoint(Standpoint::Front);
        assert!(camera.right().abs_diff_eq(Vec3::X, 1e-6));
        assert!(camera.up().abs_diff_eq(Vec3::Z, 1e-6));
        assert!(camera.back().abs_diff_eq(Vec3::NEG_Y, 1e-6));
    }

    #[test]
    fn seen_isometrically_the_three_axes_look_equally_long() {
        let camera = Camera::default();
        let back = camera.back();
        let lengths = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis.reject_from(back).length());
        assert!((lengths[0] - lengths[1]).abs() < 1e-6);
        assert!((lengths[0] - lengths[2]).abs() < 1e-6);
        assert!(camera.up().z > 0.0);
    }

    #[test]
    fn every_standpoint_is_a_proper_rotation() {
        for standpoint in Standpoint::ALL {
            let matrix = Mat3::from_quat(standpoint.rotation());
            assert!((matrix.determinant() - 1.0).abs() < 1e-5, "{standpoint:?}");
        }
    }

    #[test]
    fn a_framed_box_touches_the_margin_and_no_more() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            for aspect in [0.4, 1.0, 2.5] {
                let camera = Camera {
                    projection,
                    ..Camera::default()
                }
                .framing(&unit_box(), aspect);
                let lens = camera.lens(aspect * 500.0, 500.0, &unit_box());
                let reach = unit_box()
                    .corners()
                    .map(|corner| clip(&lens, corner))
                    .map(|corner| corner.x.abs().max(corner.y.abs()))
                    .into_iter()
                    .fold(0.0, f32::max);
                assert!(
                    (0.8..1.0).contains(&reach),
                    "{projection:?} {aspect}: {reach}"
                );
            }
        }
    }

    #[test]
    fn switching_the_projection_keeps_the_size_at_the_target() {
        let perspective = Camera::default().framing(&unit_box(), 1.0);
        let orthographic = Camera {
            projection: Projection::Orthographic,
            ..perspective
        };
        let beside = perspective.target + perspective.right() * 0.3;
        let a = clip(&perspective.lens(400.0, 400.0, &unit_box()), beside);
        let b = clip(&orthographic.lens(400.0, 400.0, &unit_box()), beside);
        assert!((a.x - b.x).abs() < 1e-5 && (a.y - b.y).abs() < 1e-5);
    }

    #[test]
    fn scale_is_the_pixels_of_one_unit_at_the_target() {
        for projection in [Projection::Perspective, Projection::Orthographic] {
            let camera = Camera {
                projection,
                height: 2.0,
                ..Camera::default()
            };
            let lens = camera.lens(300.0, 600.0, &unit_box());
            let target = lens.view_projection * camera.target.extend(1.0);
            assert!(
                (lens.scale / target.w - 300.0).abs() < 0.05,
                "{projection:?}"
            );
        }
    }

    #[test]
    fn numbers_that_are_no_camera_are_refused() {
        let good = Camera::default().state();
        assert!(Camera::from_state(&good).is_some());
        let with = |change: fn(&mut CameraState)| {
            let mut state = good;
            change(&mut state);
            Camera::from_state(&state)
        };
        assert!(with(|state| state.target[0] = f32::NAN).is_none());
        assert!(with(|state| state.height = 0.0).is_none());
        assert!(with(|state| state.height = -1.0).is_none());
        assert!(with(|state| state.height = f32::INFINITY).is_none());
        assert!(with(|state| state.rotation = [0.0; 4]).is_none());
        // Its length is no number of single precision.
        assert!(with(|state| state.rotation = [1e30; 4]).is_none());
    }

    #[test]
    fn half_way_between_two_zooms_is_their_geometric_mean() {
        let near = Camera::default();
        let far = Camera {
            height: 16.0,
            ..near
        };
        assert!((near.towards(&far, 0.5).height - 4.0).abs() < 1e-4);
        assert_eq!(near.towards(&far, 1.0), far);
    }

    proptest! {
        #[test]
        fn the_state_round_trips(
            target in prop::array::uniform3(-1e3_f32..1e3),
            axis in prop::array::uniform4(-1.0_f32..1.0),
            height in 1e-3_f32..1e3,
            orthographic: bool,
        ) {
            let rotation = Quat::from_array(axis);
            prop_assume!(rotation.length() > 0.1);
            let projection = if orthographic { Projection::Orthographic } else { Projection::Perspective };
            let camera = Camera { target: target.into(), rotation: rotation.normalize(), height, projection };
            let read = Camera::from_state(&camera.state()).unwrap();
            prop_assert!(read.rotation.angle_between(camera.rotation) < 1e-2);
            prop_assert_eq!(read.height, camera.height);
            prop_assert_eq!(read.target, camera.target);
            prop_assert_eq!(read.projection, camera.projection);
        }

        #[test]
        fn the_whole_cloud_lies_between_the_near_and_far_plane(
            axis in prop::array::uniform4(-1.0_f32..1.0),
            height in 0.5_f32..50.0,
            orthographic: bool,
        ) {
            let rotation = Quat::from_array(axis);
            prop_assume!(rotation.length() > 0.1);
            let projection = if orthographic { Projection::Orthographic } else { Projection::Perspective };
            let camera = Camera {
                target: Vec3::splat(0.5),
                rotation: rotation.normalize(),
                height,
                projection,
            };
            let lens = camera.lens(640.0, 480.0, &unit_box());
            prop_assume!(orthographic || camera.distance() > 1.0);
            for corner in unit_box().corners() {
                let depth = clip(&lens, corner).z;
                prop_assert!((-1.0..=1.0).contains(&depth), "depth {}", depth);
            }
        }
    }
}
