//! The patch of a surface that some points cover: a mesh of it, its rim, and the marks that name
//! its parameters (axis, radii, apex). For drawing; nothing is measured on it.
//!
//! A surface is endless or closed; a primitive is the part of it that its points lie on. The extent
//! is found in the surface's own parameters: the convex hull on a plane, else a range of each
//! parameter, where an angle's range leaves out the widest gap between points.

mod extent;
mod sheet;

use super::{Cone, Cylinder, Plane, Sphere, Surface, Torus, across};
use crate::cloud::{Bounds, Direction, Point, Vector};
use extent::{Range, angles, heights, hull};
use sheet::Sheet;

/// What a line of a patch stands for. The numbers are those of typed arrays.
#[repr(u8)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// The border of the covered part.
    Rim = 0,
    /// The axis of a cylinder, cone or torus.
    Axis = 1,
    /// From axis or centre to the surface; for a torus from the centre to the tube's centre line,
    /// and from there to the surface.
    Radius = 2,
    /// The apex of a cone, or the centre of a sphere or torus: a line of no length.
    Centre = 3,
}

/// A patch: a triangle mesh and lines, in the coordinates of the points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Patch {
    /// Vertices.
    pub vertices: Vec<Point>,
    /// Unit normal of the surface at each vertex, to its outer side.
    pub normals: Vec<Direction>,
    /// Indices of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Straight pieces of lines.
    pub lines: Vec<(Mark, [Point; 2])>,
}

/// How far an axis reaches beyond the patch at either end, as a share of the patch's diagonal.
const OVERHANG: f64 = 0.12;

/// Axes, centres and radii are not marked where they are farther from the patch than this many of
/// its diagonals: there is nothing to be seen of them.
const FARTHEST_MARK: f64 = 12.0;

impl Patch {
    /// The patch of a surface that the points cover; nothing where no point is finite. Points need
    /// not lie on the surface, their feet count. O(n log n); at most a few thousand triangles.
    pub fn new(surface: &Surface, points: &[Point]) -> Option<Self> {
        let points: Vec<Point> = points
            .iter()
            .filter(|point| point.coords.iter().all(|c| c.is_finite()))
            .copied()
            .collect();
        if points.is_empty() {
            return None;
        }
        let mut patch = match surface {
            Surface::Plane(plane) => of_plane(plane, &points),
            Surface::Cylinder(cylinder) => of_cylinder(cylinder, &points),
            Surface::Cone(cone) => of_cone(cone, &points),
            Surface::Sphere(sphere) => of_sphere(sphere, &points),
            Surface::Torus(torus) => of_torus(torus, &points),
        };
        patch.drop_collapsed_rims();
        patch.drop_far_marks(&points);
        let finite = patch
            .vertices
            .iter()
            .all(|vertex| vertex.coords.iter().all(|c| c.is_finite()));
        finite.then_some(patch)
    }

    /// A pole is a border without length.
    fn drop_collapsed_rims(&mut self) {
        let length = |[from, to]: &[Point; 2]| nalgebra::distance(from, to);
        let longest = self
            .lines
            .iter()
            .map(|(_, ends)| length(ends))
            .fold(0.0, f64::max);
        self.lines
            .retain(|(mark, ends)| *mark != Mark::Rim || length(ends) > longest * 1e-9);
    }

    fn drop_far_marks(&mut self, points: &[Point]) {
        let bounds = Bounds::of(points);
        let (centre, reach) = (bounds.centre(), bounds.diagonal() * FARTHEST_MARK);
        self.lines.retain(|(mark, ends)| {
            *mark == Mark::Rim
                || ends
                    .iter()
                    .all(|end| nalgebra::distance(end, &centre) <= reach)
        });
    }

    fn mark(&mut self, mark: Mark, from: Point, to: Point) {
        self.lines.push((mark, [from, to]));
    }
}

/// Unit vectors u and v that with the axis make a right-handed frame.
fn frame(axis: &Direction) -> (Vector, Vector) {
    let u = across(axis).into_inner();
    (u, axis.cross(&u))
}

fn of_plane(plane: &Plane, points: &[Point]) -> Patch {
    let origin = plane.centre();
    let (u, v) = frame(&plane.normal);
    let flat = points.iter().map(|point| {
        let offset = point - origin;
        [offset.dot(&u), offset.dot(&v)]
    });
    let vertices: Vec<Point> = hull(flat.collect())
        .into_iter()
        .map(|[a, b]| origin + u * a + v * b)
        .collect();
    let mut patch = Patch {
        normals: vec![plane.normal; vertices.len()],
        triangles: (2..vertices.len() as u32).map(|k| [0, k - 1, k]).collect(),
        ..Patch::default()
    };
    for (from, to) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
        patch.mark(Mark::Rim, *from, *to);
    }
    patch.vertices = vertices;
    patch
}

fn of_cylinder(cylinder: &Cylinder, points: &[Point]) -> Patch {
    let Cylinder {
        centre,
        axis,
        radius,
    } = *cylinder;
    let (u, v) = frame(&axis);
    let along = heights(points, &centre, &axis);
    let around = angles(points.iter().map(|point| direction(point - centre, u, v)));
    let outward = |angle: f64| u * libm::cos(angle) + v * libm::sin(angle);
    let at =
        |height: f64, angle: f64| centre + axis.into_inner() * height + outward(angle) * radius;
    let mut patch = Sheet {
        rows: along,
        columns: around,
        straight: true,
    }
    .mesh(at, |_, angle| outward(angle));
    let overhang = Bounds::of(points).diagonal() * OVERHANG;
    let on_axis = |height: f64| centre + axis.into_inner() * height;
    patch.mark(
        Mark::Axis,
        on_axis(along.low - overhang),
        on_axis(along.high + overhang),
    );
    let (height, angle) = (along.middle(), around.middle());
    patch.mark(Mark::Radius, on_axis(height), at(height, angle));
    patch
}

fn of_cone(cone: &Cone, points: &[Point]) -> Patch {
    let Cone {
        apex,
        axis,
        half_angle,
    } = *cone;
    let (u, v) = frame(&axis);
    let (sin, cos) = libm::sincos(half_angle);
    // Heights of the feet: the surface is straight, so they are the points' own shifted along the
    // normal; where points lie on it the two agree.
    let feet: Vec<Point> = points
        .iter()
        .map(|point| Surface::Cone(*cone).foot(point))
        .collect();
    let along = heights(&feet, &apex, &axis);
    // On the far nappe a point lies opposite to its angle on the near one.
    let around = angles(feet.iter().map(|foot| {
        let offset = foot - apex;
        direction(offset * offset.dot(&axis).signum(), u, v)
    }));
    let outward = |angle: f64| u * libm::cos(angle) + v * libm::sin(angle);
    let at = |height: f64, angle: f64| {
        apex + axis.into_inner() * height + outward(angle) * (height * sin / cos.max(1e-12))
    };
    let normal = |height: f64, angle: f64| {
        (outward(angle) * cos - axis.into_inner() * sin) * if height < 0.0 { -1.0 } else { 1.0 }
    };
    let mut patch = Sheet {
        rows: along,
        columns: around,
        straight: true,
    }
    .mesh(at, normal);
    let overhang = Bounds::of(points).diagonal() * OVERHANG;
    let on_axis = |height: f64| apex + axis.into_inner() * height;
    let (low, high) = (along.low.min(0.0), along.high.max(0.0));
    let far = if along.high.abs() > along.low.abs() {
        along.high
    } else {
        along.low
    };
    let reaches = low.abs().max(high) <= Bounds::of(points).diagonal() * FARTHEST_MARK;
    let (low, high) = if reaches {
        (low, high)
    } else {
        (along.low, along.high)
    };
    patch.mark(
        Mark::Axis,
        on_axis(low - overhang),
        on_axis(high + overhang),
    );
    patch.mark(Mark::Radius, on_axis(far), at(far, around.middle()));
    patch.mark(Mark::Centre, apex, apex);
    patch
}

fn of_sphere(sphere: &Sphere, points: &[Point]) -> Patch {
    let Sphere { centre, radius } = *sphere;
    // The pole is the middle of the points as seen from the centre: a cap keeps its round rim.
    let sum: Vector = points
        .iter()
        .filter_map(|point| (point - centre).try_normalize(f64::MIN_POSITIVE))
        .sum();
    let pole = Direction::try_new(sum, 1e-9).unwrap_or_else(Vector::z_axis);
    let (u, v) = frame(&pole);
    let polar = |point: &Point| {
        let offset = point - centre;
        let side = offset - pole.into_inner() * offset.dot(&pole);
        libm::atan2(side.norm(), offset.dot(&pole))
    };
    let down = Range::of(points.iter().map(polar)).clamped(0.0, std::f64::consts::PI);
    let around = angles(points.iter().map(|point| direction(point - centre, u, v)));
    let outward = |down: f64, angle: f64| {
        (u * libm::cos(angle) + v * libm::sin(angle)) * libm::sin(down)
            + pole.into_inner() * libm::cos(down)
    };
    let at = |down: f64, angle: f64| centre + outward(down, angle) * radius;
    let mut patch = Sheet {
        rows: down,
        columns: around,
        straight: false,
    }
    .mesh(at, outward);
    patch.mark(Mark::Centre, centre, centre);
    patch.mark(Mark::Radius, centre, at(down.middle(), around.middle()));
    patch
}

fn of_torus(torus: &Torus, points: &[Point]) -> Patch {
    let Torus {
        centre,
        axis,
        major_radius,
        minor_radius,
    } = *torus;
    let (u, v) = frame(&axis);
    let around = angles(points.iter().map(|point| direction(point - centre, u, v)));
    // The position in the half-plane through the axis, relative to the tube's centre.
    let tube = angles(points.iter().map(|point| {
        let offset = point - centre;
        let height = offset.dot(&axis);
        let outward = (offset - axis.into_inner() * height).norm() - major_radius;
        (height != 0.0 || outward != 0.0).then(|| libm::atan2(height, outward))
    }));
    let outward = |angle: f64| u * libm::cos(angle) + v * libm::sin(angle);
    let spine = |angle: f64| centre + outward(angle) * major_radius;
    let normal = |turn: f64, angle: f64| {
        outward(angle) * libm::cos(turn) + axis.into_inner() * libm::sin(turn)
    };
    let at = |turn: f64, angle: f64| spine(angle) + normal(turn, angle) * minor_radius;
    let mut patch = Sheet {
        rows: tube,
        columns: around,
        straight: false,
    }
    .mesh(at, normal);
    let half = axis.into_inner() * (minor_radius * 1.5);
    let (turn, angle) = (tube.middle(), around.middle());
    patch.mark(Mark::Axis, centre - half, centre + half);
    patch.mark(Mark::Centre, centre, centre);
    patch.mark(Mark::Radius, centre, spine(angle));
    patch.mark(Mark::Radius, spine(angle), at(turn, angle));
    patch
}

/// The angle of an offset in the plane of u and v; nothing on the axis.
fn direction(offset: Vector, u: Vector, v: Vector) -> Option<f64> {
    let (a, b) = (offset.dot(&u), offset.dot(&v));
    (a != 0.0 || b != 0.0).then(|| libm::atan2(b, a))
}

#[cfg(test)]
mod tests;
