//! Orthogonal least squares: the surface of a family that minimises the sum of squared true
//! distances Σ wᵢ d(xᵢ, 𝒮)².
//!
//! A plane is solved in closed form (principal directions). The others are minimised by
//! Levenberg-Marquardt steps on a local chart of the family around the current surface
//! (`charts`): as many unknowns as the surface has degrees of freedom, with no constraint to
//! keep and no redundant direction, so the normal equations are 4 × 4 to 7 × 7 matrices on the
//! stack. Points are moved to their centroid and scaled to unit size first: the normal equations
//! square the condition number, and this keeps exact data exact to about 1e-12 of the patch.

mod charts;
mod errors;
mod levenberg_marquardt;

pub use errors::{BIWEIGHT, StandardErrors};
use levenberg_marquardt::{Effort, minimise};
use nalgebra::Isometry3;

use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Point, Vector};
use crate::surface::{Cylinder, Plane, Surface, SurfaceType};

/// How much a point counts, by its distance d to the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loss {
    /// Every point counts fully: plain least squares.
    Squares,
    /// Tukey's biweight (1 - (d/c)²)² inside the cut-off c, nothing outside: points farther than c
    /// (in the units of the cloud) have no say.
    Biweight(f64),
}

impl Loss {
    /// How much a point at that distance counts, from 0 to 1.
    pub fn weight(self, distance: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Biweight(cut_off) => {
                let inside = 1.0 - (distance / cut_off).powi(2);
                if inside > 0.0 { inside * inside } else { 0.0 }
            }
        }
    }

    /// Derivative of weight times distance by the distance: how much a point still pulls that is a little farther off.
    fn slope(self, distance: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Biweight(cut_off) => {
                let squared = (distance / cut_off).powi(2);
                if squared < 1.0 {
                    (1.0 - squared) * (1.0 - 5.0 * squared)
                } else {
                    0.0
                }
            }
        }
    }

    fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Squares => Self::Squares,
            Self::Biweight(cut_off) => Self::Biweight(cut_off * factor),
        }
    }

    /// The loss itself, scaled so that it is d² for small d.
    fn cost(self, distance: f64) -> f64 {
        match self {
            Self::Squares => distance * distance,
            Self::Biweight(cut_off) => {
                let inside = (1.0 - (distance / cut_off).powi(2)).max(0.0);
                (1.0 - inside.powi(3)) * cut_off * cut_off / 3.0
            }
        }
    }
}

/// A fitted surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// The surface.
    pub surface: Surface,
    /// Root of the weighted mean squared distance, in the units of the cloud.
    pub error: f64,
}

/// Number of degrees of freedom of a family: so many points determine a surface.
pub const fn degrees_of_freedom(kind: SurfaceType) -> usize {
    match kind {
        SurfaceType::Plane => 3,
        SurfaceType::Sphere => 4,
        SurfaceType::Cylinder => 5,
        SurfaceType::Cone => 6,
        SurfaceType::Torus => 7,
    }
}

/// The surface of the family of `start` nearest to the points in the least-squares sense, found
/// from `start`.
///
/// `None` where there are fewer points than degrees of freedom, or the points do not determine a
/// surface near the start (it flies off to infinity). O(iterations × points).
pub fn fit(start: &Surface, points: &[Point], loss: Loss) -> Option<Fitted> {
    fit_within(start, points, loss, Effort::FULL)
}

/// As [`fit`], but with so few steps that a bad start is given up early: for hypotheses, most of
/// which are wrong.
pub fn approximate(start: &Surface, points: &[Point], loss: Loss) -> Option<Fitted> {
    fit_within(start, points, loss, Effort::HYPOTHESIS)
}

/// As [`fit`], but with a single step: towards the minimum from near it, where points are so many that one takes time.
pub fn step(start: &Surface, points: &[Point], loss: Loss) -> Option<Fitted> {
    fit_within(start, points, loss, Effort::STEP)
}

fn fit_within(start: &Surface, points: &[Point], loss: Loss, effort: Effort) -> Option<Fitted> {
    if points.len() < degrees_of_freedom(start.kind()) {
        return None;
    }
    let frame = Frame::of(points)?;
    let local: Vec<Vector> = points.iter().map(|point| frame.enter(point)).collect();
    let start = frame.enter_surface(start);
    let loss = loss.scaled(1.0 / frame.scale);
    let (surface, error) = match start {
        Surface::Plane(plane) => fit_plane(&plane, &local, loss)?,
        Surface::Cylinder(shape) => {
            minimise(charts::CylinderChart::new(&shape), &local, loss, effort)?
        }
        Surface::Cone(shape) => {
            minimise(charts::ConeChart::new(&shape, &local), &local, loss, effort)?
        }
        Surface::Sphere(shape) => minimise(charts::SphereChart::new(&shape), &local, loss, effort)?,
        Surface::Torus(shape) => minimise(
            charts::TorusChart::new(&shape, &local),
            &local,
            loss,
            effort,
        )?,
    };
    Some(Fitted {
        surface: frame.leave_surface(&surface),
        error: error * frame.scale,
    })
}

/// The cone nearest to the points, found from a cylinder: to the chart of a cone a cylinder is a cone
/// of half-angle zero. `None` where the best cone is one too, or as in [`fit`].
pub fn fit_cone_near(cylinder: &Cylinder, points: &[Point], loss: Loss) -> Option<Fitted> {
    if points.len() < degrees_of_freedom(SurfaceType::Cone) {
        return None;
    }
    let frame = Frame::of(points)?;
    let local: Vec<Vector> = points.iter().map(|point| frame.enter(point)).collect();
    let Surface::Cylinder(start) = frame.enter_surface(&Surface::Cylinder(*cylinder)) else {
        return None;
    };
    let chart = charts::ConeChart::from_cylinder(&start);
    let (surface, error) = minimise(
        chart,
        &local,
        loss.scaled(1.0 / frame.scale),
        Effort::HYPOTHESIS,
    )?;
    Some(Fitted {
        surface: frame.leave_surface(&surface),
        error: error * frame.scale,
    })
}

/// Total least squares of a plane: across the direction of least variance. With a robust loss the
/// weights are renewed until they settle.
fn fit_plane(start: &Plane, points: &[Vector], loss: Loss) -> Option<(Surface, f64)> {
    let mut plane = *start;
    let rounds = if loss == Loss::Squares { 1 } else { 10 };
    let mut error = f64::INFINITY;
    for _ in 0..rounds {
        let weights: Vec<f64> = points
            .iter()
            .map(|p| loss.weight(plane.normal.dot(p) - plane.offset))
            .collect();
        let points: Vec<Point> = points.iter().map(|&p| Point::from(p)).collect();
        let spread = Spread::weighted(points.iter().zip(weights))?;
        plane = Plane::new(spread.centroid, spread.normal().into_inner());
        let previous = error;
        error = spread.variances[0].sqrt();
        if (previous - error).abs() <= 1e-3 * error {
            break;
        }
    }
    Some((Surface::Plane(plane), error))
}

/// The similarity that takes the ball of some points to the unit ball.
#[derive(Debug, Clone, Copy)]
struct Frame {
    origin: Point,
    scale: f64,
}

impl Frame {
    fn of(points: &[Point]) -> Option<Self> {
        let Ball { centre, radius } = Ball::of(points);
        (radius > 0.0 && radius.is_finite()).then_some(Self {
            origin: centre,
            scale: radius,
        })
    }

    fn enter(&self, point: &Point) -> Vector {
        (point - self.origin) / self.scale
    }

    fn enter_surface(&self, surface: &Surface) -> Surface {
        let motion = Isometry3::from(-self.origin.coords);
        surface.moved(&motion).scaled(1.0 / self.scale)
    }

    fn leave_surface(&self, surface: &Surface) -> Surface {
        surface
            .scaled(self.scale)
            .moved(&Isometry3::from(self.origin.coords))
    }
}

#[cfg(test)]
mod tests;
