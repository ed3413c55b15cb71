//! How a hand moves the camera: trackball, pan, zoom, and flights from one place to another.
//!
//! Positions on the screen are in pixels from the middle of the viewport, x right and y up.

use glam::{Quat, Vec2, Vec3};

use crate::camera::{Camera, HEIGHT_RANGE, clamp_height};

/// How long a flight to another camera takes, in milliseconds.
pub const FLIGHT_MS: f64 = 320.0;

/// The rotation, in camera axes, of a virtual trackball dragged from one position to another.
/// The ball has the radius given (pixels); outside it falls off as a hyperbola, so that the
/// rotation has no kink (Bell 1988, as compared by Henriksen, Sporring and Hornbæk 2004).
pub fn trackball(from: Vec2, to: Vec2, radius: f32) -> Quat {
    let on_ball = |position: Vec2| {
        let position = position / radius.max(1.0);
        let square = position.length_squared();
        let depth = if square <= 0.5 {
            (1.0 - square).sqrt()
        } else {
            0.5 / square.sqrt()
        };
        position.extend(depth).normalize()
    };
    let (from, to) = (on_ball(from), on_ball(to));
    if from.abs_diff_eq(to, 1e-7) {
        return Quat::IDENTITY;
    }
    Quat::from_rotation_arc(from, to)
}

impl Camera {
    /// Drags the trackball: what is under the cursor follows it.
    pub fn drag(&mut self, from: Vec2, to: Vec2, radius: f32) {
        let turn = trackball(from, to, radius);
        self.turn_by(turn.inverse());
    }

    /// Turns about the viewport's own axes, in radians: the cloud turns right with `yaw`, down
    /// with `pitch`, counter-clockwise with `roll`.
    pub fn turn(&mut self, yaw: f32, pitch: f32, roll: f32) {
        let turn = Quat::from_axis_angle(Vec3::Y, -yaw)
            * Quat::from_axis_angle(Vec3::X, -pitch)
            * Quat::from_axis_angle(Vec3::Z, -roll);
        self.turn_by(turn);
    }

    /// Turns in its own axes; stays where the turn is made of numbers that are none.
    fn turn_by(&mut self, turn: Quat) {
        let rotation = (self.rotation * turn).normalize();
        if rotation.is_finite() {
            self.rotation = rotation;
        }
    }

    /// Moves the cloud across the viewport by so many pixels; no farther than heights are counted.
    pub fn pan(&mut self, by: Vec2, viewport_height: f32) {
        let unit = self.height / viewport_height.max(1.0);
        let moved = (self.right() * by.x + self.up() * by.y) * unit;
        let target = self.target - moved;
        // False for what is no number, too.
        if target.abs().max_element() <= HEIGHT_RANGE.1 {
            self.target = target;
        }
    }

    /// Enlarges by a factor; what lies in the target's plane under the cursor stays under it.
    pub fn zoom(&mut self, factor: f32, cursor: Vec2, viewport_height: f32) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        let height = clamp_height(self.height / factor);
        let change = 1.0 - height / self.height;
        self.pan(-cursor * change, viewport_height);
        self.height = height;
    }
}

/// A flight from one camera to another.
#[derive(Debug, Clone, Copy)]
pub struct Flight {
    from: Camera,
    to: Camera,
    start: Option<f64>,
}

impl Flight {
    /// A flight that starts at the first frame it is asked for.
    pub fn new(from: Camera, to: Camera) -> Self {
        Self {
            from,
            to,
            start: None,
        }
    }

    /// Where it goes.
    pub fn destination(&self) -> Camera {
        self.to
    }

    /// The camera at a time (milliseconds of any clock that only goes forward), and whether the
    /// flight is over.
    pub fn at(&mut self, now: f64) -> (Camera, bool) {
        let start = *self.start.get_or_insert(now);
        let share = ((now - start) / FLIGHT_MS).clamp(0.0, 1.0) as f32;
        // Smoothstep: starts and ends at rest.
        let eased = share * share * (3.0 - 2.0 * share);
        // A clock that tells no time ends the flight.
        let over = share.is_nan() || share >= 1.0;
        (self.from.towards(&self.to, eased), over)
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;
    use crate::camera::{Projection, Standpoint};
    use crate::cloud::Bounds;

    fn front() -> Camera {
        Camera {
            height: 2.0,
            projection: Projection::Orthographic,
            ..Camera::default().from_standpoint(Standpoint::Front)
        }
    }

    fn on_screen(camera: &Camera, point: Vec3) -> Vec2 {
        let bounds = Bounds::new(Vec3::splat(-2.0), Vec3::splat(2.0));
        let lens = camera.lens(200.0, 200.0, &bounds);
        lens.view_projection.project_point3(point).truncate() * 100.0
    }

    #[test]
    fn a_turn_by_numbers_that_are_none_is_no_turn() {
        for number in [f32::NAN, f32::INFINITY, f32::MAX] {
            let mut camera = front();
            camera.turn(number, 0.0, number);
            camera.drag(Vec2::new(number, 0.0), Vec2::new(0.0, number), 100.0);
            camera.drag(Vec2::ZERO, Vec2::splat(number), number);
            assert!(camera.rotation.is_finite() && camera.rotation.is_normalized());
        }
        let there = front().from_standpoint(Standpoint::Top);
        let mut flight = Flight::new(front(), there);
        flight.at(0.0);
        assert_eq!(flight.at(f64::NAN), (there, true));
    }

    #[test]
    fn dragging_right_brings_the_left_side_to_the_front() {
        let mut camera = front();
        camera.drag(Vec2::ZERO, Vec2::new(30.0, 0.0), 100.0);
        assert!(camera.back().x < -0.2);
        assert!(camera.up().abs_diff_eq(Vec3::Z, 1e-5));
    }

    #[test]
    fn dragging_there_and_back_ends_where_it_began() {
        let mut camera = front();
        let (a, b) = (Vec2::new(-20.0, 10.0), Vec2::new(40.0, 70.0));
        camera.drag(a, b, 100.0);
        camera.drag(b, a, 100.0);
        assert!(camera.rotation.angle_between(front().rotation) < 1e-3);
    }

    #[test]
    fn turning_right_and_dragging_right_agree() {
        let (mut turned, mut dragged) = (front(), front());
        turned.turn(0.1, 0.0, 0.0);
        dragged.drag(Vec2::ZERO, Vec2::new(10.0, 0.0), 100.0);
        assert!(turned.back().x < 0.0 && dragged.back().x < 0.0);
        let (mut turned, mut dragged) = (front(), front());
        turned.turn(0.0, 0.1, 0.0);
        dragged.drag(Vec2::ZERO, Vec2::new(0.0, -10.0), 100.0);
        assert!(turned.back().z > 0.0 && dragged.back().z > 0.0);
    }

    #[test]
    fn panning_moves_the_cloud_by_the_pixels_asked_for() {
        let mut camera = front();
        let point = Vec3::new(0.2, 0.0, -0.3);
        let before = on_screen(&camera, point);
        camera.pan(Vec2::new(7.0, -11.0), 200.0);
        let moved = on_screen(&camera, point) - before;
        assert!(moved.abs_diff_eq(Vec2::new(7.0, -11.0), 1e-3), "{moved}");
    }

    #[test]
    fn no_number_of_pans_leads_out_of_the_numbers() {
        let mut camera = Camera {
            height: HEIGHT_RANGE.1,
            ..front()
        };
        for _ in 0..200 {
            camera.pan(Vec2::new(3e19, -3e19), 1.0);
            camera.pan(Vec2::splat(100.0), 1.0);
            camera.pan(Vec2::splat(f32::INFINITY), 1.0);
        }
        assert!(camera.target.abs().max_element() <= HEIGHT_RANGE.1);
    }

    #[test]
    fn a_flight_ends_at_its_destination() {
        let from = front();
        let to = Camera {
            height: 5.0,
            ..Camera::default()
        };
        let mut flight = Flight::new(from, to);
        assert_eq!(flight.at(1000.0).0.height, from.height);
        let (half_way, over) = flight.at(1000.0 + FLIGHT_MS / 2.0);
        assert!(!over && half_way.height > from.height && half_way.height < to.height);
        assert_eq!(flight.at(1000.0 + FLIGHT_MS), (to, true));
    }

    #[test]
    fn a_zoom_by_nonsense_does_nothing() {
        for factor in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            let mut camera = front();
            camera.zoom(factor, Vec2::new(5.0, 5.0), 200.0);
            assert_eq!(camera, front());
        }
    }

    proptest! {
        #[test]
        fn what_is_under_the_cursor_stays_there_while_zooming(
            x in -90.0_f32..90.0, y in -90.0_f32..90.0, factor in 0.2_f32..5.0,
        ) {
            let mut camera = front();
            let cursor = Vec2::new(x, y);
            let under = camera.target + (camera.right() * x + camera.up() * y) * (2.0 / 200.0);
            camera.zoom(factor, cursor, 200.0);
            let after = on_screen(&camera, under);
            prop_assert!(after.abs_diff_eq(cursor, 0.05), "{} for {}", after, cursor);
        }

        #[test]
        fn the_rotation_stays_a_rotation(
            drags in prop::collection::vec(prop::array::uniform4(-500.0_f32..500.0), 1..40),
        ) {
            let mut camera = front();
            for [a, b, c, d] in drags {
                camera.drag(Vec2::new(a, b), Vec2::new(c, d), 150.0);
            }
            prop_assert!((camera.rotation.length() - 1.0).abs() < 1e-4);
        }
    }
}
