//! Where a ray meets a surface.

use fit4cad::cloud::{Bounds, Point, Vector};

use super::roots::roots;
use crate::geometry::shape::Shape;
use crate::placement::Frame;

/// The way from a place, at 0, to another, at 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    pub from: Point,
    pub way: Vector,
}

impl Ray {
    pub fn at(&self, t: f64) -> Point {
        self.from + self.way * t
    }

    /// The piece of it within a box, as its ends; `None` where it misses the box.
    pub fn within(&self, bounds: &Bounds) -> Option<[f64; 2]> {
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let (from, way) = (self.from[axis], self.way[axis]);
            let (least, most) = (bounds.min[axis], bounds.max[axis]);
            if way == 0.0 {
                if from < least || from > most {
                    return None;
                }
                continue;
            }
            let (a, b) = ((least - from) / way, (most - from) / way);
            low = low.max(a.min(b));
            high = high.min(a.max(b));
        }
        (low <= high).then_some([low, high])
    }

    /// A piece of it.
    fn piece(&self, [low, high]: [f64; 2]) -> Self {
        Self {
            from: self.at(low),
            way: self.way * (high - low),
        }
    }

    /// Where its piece between two of its values meets one of the five families, ascending; `None` of other
    /// surfaces. The piece alone is looked at: far from the surface, the digits would be spent on the distance.
    pub fn crossings(&self, shape: &Shape, piece: [f64; 2]) -> Option<Vec<f64>> {
        let ray = self.piece(piece);
        let found = match shape {
            Shape::Plane(frame) => {
                let [_, _, z] = ray.coordinates(frame);
                roots(&z)
            }
            Shape::Cylinder(frame, radius) => {
                let [x, y, _] = ray.coordinates(frame);
                roots(&sum([square(x), square(y), [-radius * radius, 0.0, 0.0]]))
            }
            Shape::Cone(frame, angle) => {
                let [x, y, z] = ray.coordinates(frame);
                let tan = libm::tan(*angle);
                let z = square(z).map(|it| -tan * tan * it);
                roots(&sum([square(x), square(y), z]))
            }
            Shape::Sphere(frame, radius) => {
                let [x, y, z] = ray.coordinates(frame).map(square);
                let ball = sum([x, y, z]);
                roots(&[ball[0] - radius * radius, ball[1], ball[2]])
            }
            Shape::Torus(ring) => {
                let [x, y, z] = ray.coordinates(&ring.frame).map(square);
                let (major, minor) = (ring.major * ring.major, ring.minor * ring.minor);
                let [a, b, c] = sum([x, y, z]);
                let a = a + major - minor;
                let across = sum([x, y, [0.0; 3]]).map(|it| -4.0 * major * it);
                roots(&[
                    a * a + across[0],
                    2.0 * a * b + across[1],
                    2.0 * a * c + b * b + across[2],
                    2.0 * b * c,
                    c * c,
                ])
            }
            _ => return None,
        };
        let [low, high] = piece;
        Some(found.iter().map(|t| low + (high - low) * t).collect())
    }

    /// Each coordinate in a frame along the ray: its start and its growth.
    fn coordinates(&self, frame: &Frame) -> [[f64; 2]; 3] {
        let from = frame.enter(&self.from);
        let way = [frame.x, frame.y, frame.z].map(|axis| self.way.dot(&axis));
        [0, 1, 2].map(|k| [from[k], way[k]])
    }

    /// Where it meets a triangle, with the shares of the second and third corner (Möller and Trumbore 1997).
    pub fn triangle(&self, [a, b, c]: [&Point; 3]) -> Option<(f64, [f64; 2])> {
        let (ab, ac) = (b - a, c - a);
        let across = self.way.cross(&ac);
        let determinant = ab.dot(&across);
        if determinant == 0.0 {
            return None;
        }
        let offset = self.from - a;
        let u = offset.dot(&across) / determinant;
        let turned = offset.cross(&ab);
        let v = self.way.dot(&turned) / determinant;
        let t = ac.dot(&turned) / determinant;
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (0.0..=1.0).contains(&t);
        inside.then_some((t, [u, v]))
    }
}

/// The square of a linear polynomial.
fn square([a, b]: [f64; 2]) -> [f64; 3] {
    [a * a, 2.0 * a * b, b * b]
}

fn sum([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + b[k] + c[k])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::Ring;

    fn frame() -> Frame {
        Frame::new(Point::new(1.0, 2.0, 3.0), Vector::new(1.0, 1.0, 0.5), None).unwrap()
    }

    /// Every place where a ray is said to meet a surface lies on it, and there are as many as there must be.
    #[test]
    fn a_ray_through_the_middle_meets_each_family_as_often_as_it_must() {
        let frame = frame();
        let through = |from: [f64; 3], to: [f64; 3]| {
            let (from, to) = (frame.leave(from), frame.leave(to));
            Ray {
                from,
                way: to - from,
            }
        };
        let ring = Ring {
            frame,
            major: 2.0,
            minor: 0.5,
            inner: false,
        };
        let across = through([-9.0, 0.1, 0.2], [9.0, -0.1, 0.1]);
        let down = through([0.1, 0.2, 9.0], [-0.1, 0.1, -9.0]);
        let cases = [
            (Shape::Plane(frame), down, 1),
            (Shape::Cylinder(frame, 2.0), across, 2),
            (
                Shape::Cone(frame, 0.4),
                through([-9.0, 0.0, 3.0], [9.0, 0.0, 3.1]),
                2,
            ),
            (Shape::Sphere(frame, 2.0), across, 2),
            (Shape::Torus(ring), across, 4),
            (Shape::Torus(ring), down, 0),
        ];
        for (shape, ray, count) in cases {
            let found = ray.crossings(&shape, [0.0, 1.0]).unwrap();
            assert_eq!(found.len(), count, "{shape:?}");
            for t in found {
                let hit = ray.at(t);
                let foot = shape.at(shape.invert(&hit).unwrap()).0;
                assert!(
                    (foot - hit).norm() < 1e-9,
                    "{shape:?} {}",
                    (foot - hit).norm()
                );
            }
        }
    }

    #[test]
    fn a_box_keeps_the_piece_within_it() {
        let bounds = Bounds::of(&[Point::origin(), Point::new(1.0, 1.0, 1.0)]);
        let ray = |from: [f64; 3], way: [f64; 3]| Ray {
            from: from.into(),
            way: way.into(),
        };
        let hit = ray([-1.0, 0.5, 0.5], [4.0, 0.0, 0.0]).within(&bounds);
        assert_eq!(hit, Some([0.25, 0.5]));
        assert_eq!(ray([-1.0, 1.5, 0.5], [4.0, 0.0, 0.0]).within(&bounds), None);
        assert_eq!(ray([-1.0, 0.5, 0.5], [0.5, 0.0, 0.0]).within(&bounds), None);
    }
}
