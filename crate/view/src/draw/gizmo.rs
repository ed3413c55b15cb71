//! The little cross of axes in the corner: which way x, y and z point.

use glam::{Mat4, Quat, Vec2, Vec3};

use crate::draw::lines::Line;

/// Side of the square it takes, in pixels of the page.
pub const SIZE: f32 = 84.0;
/// Length of an axis and distance of its letter from the middle.
const ARM: f32 = 24.0;
const LETTER: f32 = 33.0;
/// Half width and half height of a letter.
const STROKE: Vec2 = Vec2::new(3.2, 4.2);

const COLOURS: [[u8; 4]; 3] = [[209, 73, 91, 255], [79, 157, 58, 255], [59, 125, 216, 255]];

/// Strokes of the letters X, Y and Z in a square from −1 to 1.
const LETTERS: [&[[f32; 4]]; 3] = [
    &[[-1.0, -1.0, 1.0, 1.0], [-1.0, 1.0, 1.0, -1.0]],
    &[
        [-1.0, 1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, -1.0],
    ],
    &[
        [-1.0, 1.0, 1.0, 1.0],
        [1.0, 1.0, -1.0, -1.0],
        [-1.0, -1.0, 1.0, -1.0],
    ],
];

/// Number of lines: three axes and eight strokes.
pub const LINES: usize = 11;

/// The lines, in pixels from the middle, for a camera's rotation. The axis that points most towards
/// the viewer comes last.
pub fn lines(rotation: Quat) -> [Line; LINES] {
    let to_camera = rotation.inverse();
    let mut axes =
        [(0, Vec3::X), (1, Vec3::Y), (2, Vec3::Z)].map(|(axis, way)| (axis, to_camera * way));
    for (a, b) in [(0, 1), (1, 2), (0, 1)] {
        if axes[a].1.z > axes[b].1.z {
            axes.swap(a, b);
        }
    }
    let mut lines = axes.iter().flat_map(|&(axis, seen)| of_axis(axis, seen));
    let nothing = Line {
        from: [0.0; 3],
        to: [0.0; 3],
        colour: [0; 4],
        width: 0.0,
    };
    std::array::from_fn(|_| lines.next().unwrap_or(nothing))
}

fn of_axis(axis: usize, seen: Vec3) -> impl Iterator<Item = Line> {
    let colour = COLOURS.get(axis).copied().unwrap_or_default();
    let line = move |from: Vec2, to: Vec2, width: f32| Line {
        from: from.extend(0.0).to_array(),
        to: to.extend(0.0).to_array(),
        colour,
        width,
    };
    let seen = seen.truncate();
    // Seen end on, the letter steps aside from the middle.
    let aside = if seen.length() < 0.3 {
        Vec2::new(9.0, 9.0)
    } else {
        Vec2::ZERO
    };
    let middle = seen * LETTER + aside;
    let strokes = LETTERS.get(axis).copied().unwrap_or_default().iter();
    let strokes = strokes.map(move |&[a, b, c, d]| {
        let at = |x: f32, y: f32| middle + Vec2::new(x, y) * STROKE;
        line(at(a, b), at(c, d), 1.6)
    });
    std::iter::once(line(Vec2::ZERO, seen * ARM, 2.2)).chain(strokes)
}

/// From pixels around the middle of a viewport of so many pixels to clip coordinates.
pub fn projection(pixels: f32) -> Mat4 {
    let half = pixels * 0.5;
    Mat4::orthographic_rh_gl(-half, half, -half, half, -1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Standpoint;

    #[test]
    fn from_the_front_x_points_right_and_z_up() {
        let lines = lines(Standpoint::Front.rotation());
        let ends: Vec<_> = lines.iter().filter(|line| line.width > 2.0).collect();
        let end = |colour: [u8; 4]| ends.iter().find(|line| line.colour == colour).unwrap().to;
        assert!((end(COLOURS[0])[0] - ARM).abs() < 1e-3);
        assert!((end(COLOURS[2])[1] - ARM).abs() < 1e-3);
        assert!(end(COLOURS[1])[0].abs() < 1e-3);
    }

    #[test]
    fn every_line_is_drawn_and_stays_in_its_square() {
        for standpoint in Standpoint::ALL {
            for line in lines(standpoint.rotation()) {
                assert!(line.width > 0.0);
                let ends = [line.from, line.to];
                assert!(ends.as_flattened().iter().all(|c| c.abs() < SIZE / 2.0));
            }
        }
    }
}
