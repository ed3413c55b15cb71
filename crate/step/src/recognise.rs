//! Free-form faces that are planes, cylinders, cones, spheres or tori all the same: exporters write
//! many a fillet as a spline.

use fit4cad::cloud::{Direction, Point, Vector};
use fit4cad::fit::least_squares::{Loss, fit};
use fit4cad::random::Random;
use fit4cad::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};
use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector6};

use crate::face::Trimmed;
use crate::geometry::shape::{Ring, Shape};
use crate::placement::Frame;

/// How many places of a face are looked at.
const LOOKS: usize = 160;
/// How far a first guess may be off, over the size of the face: worse ones are of another family.
const GUESS: f64 = 0.02;

/// The surface of one of the five families on which a free-form face lies to within a tolerance in
/// millimetres, the simplest there is.
pub(crate) fn recognise(face: &Trimmed, tolerance: f64, seed: u64) -> Option<Shape> {
    let mut random = Random::new(seed, 0x5eed);
    let mut looks: Vec<(Point, Vector)> = Vec::with_capacity(LOOKS);
    for _ in 0..LOOKS {
        let (at, _) = face.draw(&mut random)?;
        let look = face.oriented(at);
        if look.1 != Vector::zeros() {
            looks.push(look);
        }
    }
    let points: Vec<Point> = looks.iter().map(|(point, _)| *point).collect();
    let size = fit4cad::cloud::Bounds::of(&points).diagonal();
    let farthest = |surface: &Surface| {
        let distances = points.iter().map(|point| surface.distance(point));
        distances.fold(0.0, f64::max)
    };
    let guesses = [plane, cylinder, cone, sphere, torus];
    guesses.into_iter().find_map(|guess| {
        let first = guess(&looks)?;
        if !first.is_in_range() || farthest(&first) > GUESS * size {
            return None;
        }
        let polished = fit(&first, &points, Loss::Squares).map_or(first, |fitted| fitted.surface);
        let best = if farthest(&polished) <= farthest(&first) {
            polished
        } else {
            first
        };
        // A radius far beyond the face says that it is flat, and numbers of its own mean nothing.
        (best.is_in_range() && farthest(&best) <= tolerance && is_of_size(&best, size))
            .then(|| shape(&best))?
    })
}

fn is_of_size(surface: &Surface, size: f64) -> bool {
    let most = 1e4 * size;
    match surface {
        Surface::Plane(_) => true,
        Surface::Cylinder(it) => it.radius < most,
        Surface::Cone(it) => it.half_angle > 1e-4 && it.half_angle < 1.5706,
        Surface::Sphere(it) => it.radius < most,
        Surface::Torus(it) => it.major_radius < most && it.minor_radius < most,
    }
}

type Looks = [(Point, Vector)];

fn centroid(looks: &Looks) -> Point {
    let sum: Vector = looks.iter().map(|(point, _)| point.coords).sum();
    Point::from(sum / looks.len() as f64)
}

/// Eigenvectors of a symmetric matrix, that of the least eigenvalue first.
fn least_direction(matrix: Matrix3<f64>) -> Vector {
    let eigen = SymmetricEigen::new(matrix);
    eigen
        .eigenvectors
        .column(eigen.eigenvalues.imin())
        .into_owned()
}

fn plane(looks: &Looks) -> Option<Surface> {
    let centre = centroid(looks);
    let spread = looks
        .iter()
        .map(|(point, _)| (point - centre) * (point - centre).transpose());
    let normal = least_direction(spread.sum());
    Some(Surface::Plane(Plane::new(centre, normal)))
}

/// The place nearest to all lines along the normals.
fn focus(looks: &Looks, across: Option<&Vector>) -> Option<Point> {
    let centre = centroid(looks);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector::zeros());
    for (point, normal) in looks {
        let reject = Matrix3::identity() - normal * normal.transpose();
        matrix += reject;
        right += reject * (point - centre);
    }
    if let Some(axis) = across {
        // Along the axis every place is as good: that of the centroid.
        matrix += axis * axis.transpose() * looks.len() as f64;
        right -= axis * axis.dot(&right);
    }
    Some(centre + matrix.try_inverse()? * right)
}

fn mean_distance(looks: &Looks, distance: impl Fn(&Point) -> f64) -> f64 {
    looks.iter().map(|(point, _)| distance(point)).sum::<f64>() / looks.len() as f64
}

fn sphere(looks: &Looks) -> Option<Surface> {
    let centre = focus(looks, None)?;
    let radius = mean_distance(looks, |point| (point - centre).norm());
    Some(Surface::Sphere(Sphere::new(centre, radius)))
}

fn cylinder(looks: &Looks) -> Option<Surface> {
    let axis = least_direction(looks.iter().map(|(_, n)| n * n.transpose()).sum());
    let flat: Vec<(Point, Vector)> = looks
        .iter()
        .filter_map(|(point, n)| Some((*point, (n - axis * n.dot(&axis)).try_normalize(1e-3)?)))
        .collect();
    if flat.len() < 3 {
        return None;
    }
    let centre = focus(&flat, Some(&axis))?;
    let radius = mean_distance(looks, |point| (point - centre).cross(&axis).norm());
    Some(Surface::Cylinder(Cylinder::new(centre, axis, radius)))
}

fn cone(looks: &Looks) -> Option<Surface> {
    let mean: Vector = looks.iter().map(|(_, n)| n).sum::<Vector>() / looks.len() as f64;
    let axis = least_direction(
        looks
            .iter()
            .map(|(_, n)| (n - mean) * (n - mean).transpose())
            .sum(),
    );
    let centre = centroid(looks);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector::zeros());
    for (point, normal) in looks {
        matrix += normal * normal.transpose();
        right += normal * normal.dot(&(point - centre));
    }
    let apex = centre + matrix.try_inverse()? * right;
    let angle = mean_distance(looks, |point| {
        let offset = point - apex;
        libm::atan2(offset.cross(&axis).norm(), offset.dot(&axis).abs())
    });
    Some(Surface::Cone(Cone::new(apex, axis, angle)))
}

/// All normals of a torus meet its axis: the line whose moment with each of them vanishes.
fn torus(looks: &Looks) -> Option<Surface> {
    let centre = centroid(looks);
    let size = looks
        .iter()
        .map(|(point, _)| (point - centre).norm())
        .fold(0.0, f64::max);
    let mut matrix = Matrix6::zeros();
    for (point, normal) in looks {
        let moment = (point - centre).cross(normal) / size;
        let line = Vector6::new(moment.x, moment.y, moment.z, normal.x, normal.y, normal.z);
        matrix += line * line.transpose();
    }
    let eigen = SymmetricEigen::new(matrix);
    let line = eigen
        .eigenvectors
        .column(eigen.eigenvalues.imin())
        .into_owned();
    let axis = Direction::try_new(Vector::new(line[0], line[1], line[2]), 1e-9)?;
    let moment = Vector::new(line[3], line[4], line[5]);
    let length = Vector::new(line[0], line[1], line[2]).norm();
    let on_axis = centre + axis.cross(&(moment / length)) * size;
    // In the half-plane of the axis the tube is a circle: 2 x x0 + 2 z z0 + c = x² + z².
    let seen = |point: &Point| {
        let offset = point - on_axis;
        let height = offset.dot(&axis);
        ((offset - axis.into_inner() * height).norm(), height)
    };
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector::zeros());
    for (point, _) in looks {
        let (x, z) = seen(point);
        let row = Vector::new(2.0 * x, 2.0 * z, size);
        matrix += row * row.transpose();
        right += row * (x * x + z * z);
    }
    let found = matrix.try_inverse()? * right;
    let square = found.z * size + found.x * found.x + found.y * found.y;
    let tube = (square > 0.0).then(|| square.sqrt())?;
    let middle = on_axis + axis.into_inner() * found.y;
    Some(Surface::Torus(Torus::new(
        middle,
        axis.into_inner(),
        found.x,
        tube,
    )))
}

/// A surface with a frame of its own.
fn shape(surface: &Surface) -> Option<Shape> {
    Some(match surface {
        Surface::Plane(it) => Shape::Plane(Frame::new(it.centre(), it.normal.into_inner(), None)?),
        Surface::Cylinder(it) => Shape::Cylinder(
            Frame::new(it.centre, it.axis.into_inner(), None)?,
            it.radius,
        ),
        Surface::Cone(it) => Shape::Cone(
            Frame::new(it.apex, it.axis.into_inner(), None)?,
            it.half_angle,
        ),
        Surface::Sphere(it) => Shape::Sphere(Frame::new(it.centre, Vector::z(), None)?, it.radius),
        Surface::Torus(it) => Shape::Torus(Ring {
            frame: Frame::new(it.centre, it.axis.into_inner(), None)?,
            major: it.major_radius,
            minor: it.minor_radius,
            inner: false,
        }),
    })
}
