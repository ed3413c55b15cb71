//! Surfaces of revolution about an axis that is already known.
//!
//! A ring-shaped fillet, chamfer or countersink that is all border shows too little of itself for
//! its axis to be found, but it shares the axis with the cylinder, cone or torus beside it. About a
//! given axis every surface of revolution is a curve in the half-plane of distance ρ and height h:
//! a line is a cylinder or cone, a circle a torus. Three unknowns are left instead of seven.

use nalgebra::{Matrix3, Vector3};

use crate::cloud::normals::Spread;
use crate::cloud::{Direction, Point};
use crate::surface::{Cone, Surface, Torus};

/// The axis of a surface of revolution other than a sphere: a point on it and its direction.
pub fn axis_of(surface: &Surface) -> Option<(Point, Direction)> {
    match surface {
        Surface::Cylinder(shape) => Some((shape.centre, shape.axis)),
        Surface::Cone(shape) => Some((shape.apex, shape.axis)),
        Surface::Torus(shape) => Some((shape.centre, shape.axis)),
        Surface::Plane(_) | Surface::Sphere(_) => None,
    }
}

/// The normal or axis of a surface; a sphere has none.
pub fn direction_of(surface: &Surface) -> Option<Direction> {
    match surface {
        Surface::Plane(plane) => Some(plane.normal),
        Surface::Cylinder(cylinder) => Some(cylinder.axis),
        Surface::Cone(cone) => Some(cone.axis),
        Surface::Sphere(_) => None,
        Surface::Torus(torus) => Some(torus.axis),
    }
}

/// Points in the half-plane of an axis: x is the distance ρ from it, y the height h, z zero.
pub fn half_plane(points: &[Point], origin: &Point, axis: &Direction) -> Vec<Point> {
    points
        .iter()
        .map(|point| {
            let offset = point - origin;
            let height = offset.dot(axis);
            Point::new((offset - axis.into_inner() * height).norm(), height, 0.0)
        })
        .collect()
}

/// The cone whose line passes through points of the half-plane best. `None` for a cylinder or plane.
pub fn cone(section: &[Point], origin: &Point, axis: &Direction) -> Option<Surface> {
    cone_of(&Spread::of(section.iter())?, origin, axis)
}

/// The cone whose line is that of a spread in the half-plane. `None` for a cylinder or plane.
pub fn cone_of(spread: &Spread, origin: &Point, axis: &Direction) -> Option<Surface> {
    let line = spread.directions[2];
    let (out, up) = (line.x, line.y);
    (up.abs() > 1e-6 && out.abs() > 1e-6).then(|| {
        let height = spread.centroid.y - spread.centroid.x * up / out;
        let apex = origin + axis.into_inner() * height;
        Surface::Cone(Cone::new(
            apex,
            axis.into_inner(),
            libm::atan((out / up).abs()),
        ))
    })
}

/// The torus whose circle passes through points of the half-plane best.
pub fn torus(section: &[Point], origin: &Point, axis: &Direction) -> Option<Surface> {
    let (centre, minor) = circle(section)?;
    let middle = origin + axis.into_inner() * centre.y;
    Some(Surface::Torus(Torus::new(
        middle,
        axis.into_inner(),
        centre.x,
        minor,
    )))
}

/// The circle x² + y² = 2ax + 2by + c of least algebraic error: centre and radius.
pub fn circle(points: &[Point]) -> Option<(Point, f64)> {
    let middle = Spread::of(points.iter())?.centroid;
    let mut matrix = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for point in points {
        let p = point - middle;
        let row = Vector3::new(2.0 * p.x, 2.0 * p.y, 1.0);
        matrix += row * row.transpose();
        right += row * (p.x * p.x + p.y * p.y);
    }
    let s = matrix.cholesky()?.solve(&right);
    let radius = (s.z + s.x * s.x + s.y * s.y).sqrt();
    radius
        .is_finite()
        .then(|| (Point::new(middle.x + s.x, middle.y + s.y, 0.0), radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;

    #[test]
    fn a_few_points_of_a_torus_and_its_axis_give_the_torus() {
        let axis = Direction::new_normalize(Vector::new(0.3, -0.4, 1.0));
        let origin = Point::new(1.0, 2.0, 3.0);
        let truth = Torus::new(origin, axis.into_inner(), 5.0, 0.7);
        let surface = Surface::Torus(truth);
        let points: Vec<Point> = (0..8)
            .map(|i| {
                let t = f64::from(i) * 0.2;
                surface.foot(&(origin + Vector::new(5.0 + 0.3 * t, t, 1.0 - t)))
            })
            .collect();
        // Any point of the axis will do.
        let elsewhere = origin - axis.into_inner() * 2.0;
        let section = half_plane(&points, &elsewhere, &axis);
        let Some(Surface::Torus(found)) = torus(&section, &elsewhere, &axis) else {
            panic!("no torus");
        };
        assert!((found.centre - truth.centre).norm() < 1e-9);
        assert!((found.major_radius - 5.0).abs() + (found.minor_radius - 0.7).abs() < 1e-9);
    }
}
