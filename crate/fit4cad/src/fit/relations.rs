//! Surfaces that share a direction or an axis with one that is known.
//!
//! Most parts have few directions and axes, and many faces along and about them. What is shared takes no numbers to
//! describe, and is known better than from the points of one small face (as GlobFit; Li and others 2011). Along a known
//! direction a plane has one number left and a cylinder three. About a known axis every surface of revolution is a line
//! or a circle in the half-plane of distance from the axis and height (`axes`): a cylinder has one number left, a cone two,
//! a torus three.

use nalgebra::{Matrix3, Vector3};

use super::axes::{self, axis_of, direction_of, half_plane};
use super::least_squares::{BIWEIGHT, Loss};
use crate::cloud::normals::Spread;
use crate::cloud::{Direction, Point, Vector};
use crate::surface::{Cylinder, Plane, Surface, SurfaceType, Torus, across};

/// Directions that are remembered, and axes: those of the largest surfaces.
const REMEMBERED: usize = 12;
/// Times that points are weighted anew.
const ROUNDS: usize = 6;
/// Sine of the angle between directions that are one, but for rounding.
const ONE: f64 = 1e-7;

/// Directions and axes that surfaces may share.
#[derive(Debug, Clone, Default)]
pub struct Known {
    directions: Vec<Direction>,
    axes: Vec<(Point, Direction)>,
}

/// A surface that shares its direction or axis, fitted to some points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// The surface.
    pub surface: Surface,
    /// How many numbers are its own.
    pub parameters: usize,
    /// From among how many what it shares was chosen.
    pub choices: usize,
}

impl Known {
    /// Remembers the direction and the axis of a surface, the most important surfaces first.
    pub fn add(&mut self, surface: &Surface) {
        let is_one = |a: &Direction, b: &Direction| a.cross(b).norm() < ONE;
        if let Some(direction) = direction_of(surface)
            && self.directions.len() < REMEMBERED
            && !self.directions.iter().any(|it| is_one(it, &direction))
        {
            self.directions.push(direction);
        }
        if let Some((point, direction)) = axis_of(surface)
            && self.axes.len() < REMEMBERED
            && !self.axes.iter().any(|(other, it)| {
                let offset = point - other;
                is_one(it, &direction)
                    && offset.cross(it).norm() <= ONE * (offset.norm() + point.coords.norm())
            })
        {
            self.axes.push((point, direction));
        }
    }

    /// Every surface that shares something and is of a family that is asked for, fitted to points off it by Gaussian noise of the given
    /// standard deviation. O(points).
    pub fn held<'a>(
        &'a self,
        is_asked: impl Fn(SurfaceType) -> bool + Copy + 'a,
        points: &'a [Point],
        noise: f64,
    ) -> impl Iterator<Item = Held> + 'a {
        let along = self.directions.iter().flat_map(move |direction| {
            let plane = is_asked(SurfaceType::Plane).then(|| plane(points, direction, noise));
            let cylinder =
                is_asked(SurfaceType::Cylinder).then(|| cylinder(points, direction, noise));
            [(plane.flatten(), 1), (cylinder.flatten(), 3)]
        });
        let along = along.map(|it| (it, self.directions.len()));
        let about = self.axes.iter().flat_map(move |(origin, direction)| {
            let section = half_plane(points, origin, direction);
            let axis = Axis {
                origin,
                direction,
                section: &section,
                noise,
            };
            let cylinder = is_asked(SurfaceType::Cylinder).then(|| axis.cylinder());
            let cone = is_asked(SurfaceType::Cone).then(|| axis.cone());
            let torus = is_asked(SurfaceType::Torus).then(|| axis.torus());
            [
                (cylinder.flatten(), 1),
                (cone.flatten(), 2),
                (torus.flatten(), 3),
            ]
        });
        let about = about.map(|it| (it, self.axes.len()));
        along
            .chain(about)
            .filter_map(|((surface, parameters), choices)| {
                let surface = surface?;
                Some(Held {
                    surface,
                    parameters,
                    choices,
                })
            })
    }
}

/// The weight of a point so many standard deviations off.
fn weight(deviations: f64) -> f64 {
    Loss::Biweight(BIWEIGHT).weight(deviations)
}

/// The value that most of some agree on within the noise, from their median on.
fn agreed(mut values: Vec<f64>, noise: f64) -> Option<f64> {
    let middle = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let (_, &mut median, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let mut value = median;
    for _ in 0..ROUNDS {
        let (mut sum, mut weights) = (0.0, 0.0);
        for it in &values {
            let weight = weight((it - value) / noise);
            sum += weight * it;
            weights += weight;
        }
        if weights <= 0.0 {
            return None;
        }
        value = sum / weights;
    }
    Some(value)
}

/// The plane across a direction.
fn plane(points: &[Point], normal: &Direction, noise: f64) -> Option<Surface> {
    let heights = points.iter().map(|it| it.coords.dot(normal));
    let height = agreed(heights.collect(), noise)?;
    let normal = normal.into_inner();
    Some(Surface::Plane(Plane::new(
        Point::from(normal * height),
        normal,
    )))
}

/// The cylinder along a direction.
fn cylinder(points: &[Point], axis: &Direction, noise: f64) -> Option<Surface> {
    let first = across(axis).into_inner();
    let second = axis.cross(&first);
    let flat = |it: &Point| Point::new(it.coords.dot(&first), it.coords.dot(&second), 0.0);
    let flat: Vec<Point> = points.iter().map(flat).collect();
    let (centre, radius) = circle(&flat, noise)?;
    let centre = Point::from(first * centre.x + second * centre.y);
    Some(Surface::Cylinder(Cylinder::new(
        centre,
        axis.into_inner(),
        radius,
    )))
}

/// Points about an axis.
struct Axis<'a> {
    origin: &'a Point,
    direction: &'a Direction,
    /// The points in its half-plane.
    section: &'a [Point],
    noise: f64,
}

impl Axis<'_> {
    fn cylinder(&self) -> Option<Surface> {
        let radius = agreed(self.section.iter().map(|it| it.x).collect(), self.noise)?;
        let axis = self.direction.into_inner();
        (radius > 0.0).then(|| Surface::Cylinder(Cylinder::new(*self.origin, axis, radius)))
    }

    /// The cone whose line in the half-plane most points are on.
    fn cone(&self) -> Option<Surface> {
        let mut spread = Spread::of(self.section.iter())?;
        for _ in 0..ROUNDS {
            let (normal, centroid) = (line_normal(&spread), spread.centroid);
            let off = |it: &Point| normal.dot(&(it - centroid));
            let weighted = self
                .section
                .iter()
                .map(|it| (it, weight(off(it) / self.noise)));
            spread = Spread::weighted(weighted)?;
        }
        axes::cone_of(&spread, self.origin, self.direction)
    }

    fn torus(&self) -> Option<Surface> {
        let (centre, minor) = circle(self.section, self.noise)?;
        (centre.x > 0.0).then(|| {
            let middle = self.origin + self.direction.into_inner() * centre.y;
            Surface::Torus(Torus::new(
                middle,
                self.direction.into_inner(),
                centre.x,
                minor,
            ))
        })
    }
}

/// The direction across the line through points of a half-plane, in it.
fn line_normal(spread: &Spread) -> Vector {
    let along = spread.directions[2];
    Vector::new(-along.y, along.x, 0.0)
}

/// The circle through flat points: of least algebraic error at first, then of least distances, those far off without a say.
fn circle(points: &[Point], noise: f64) -> Option<(Point, f64)> {
    let (mut centre, mut radius) = axes::circle(points)?;
    for _ in 0..ROUNDS {
        let mut matrix = Matrix3::zeros();
        let mut right = Vector3::zeros();
        for point in points {
            let offset = point - centre;
            let length = (offset.x * offset.x + offset.y * offset.y).sqrt();
            let off = length - radius;
            let weight = weight(off / noise);
            if weight > 0.0 && length > 0.0 {
                let row = Vector3::new(offset.x / length, offset.y / length, 1.0);
                matrix += row * row.transpose() * weight;
                right += row * (off * weight);
            }
        }
        let step = matrix.cholesky()?.solve(&right);
        centre += Vector::new(step.x, step.y, 0.0);
        radius += step.z;
    }
    (radius.is_finite() && radius > 0.0).then_some((centre, radius))
}

#[cfg(test)]
mod tests;
