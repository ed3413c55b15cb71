//! Step 3: slippage analysis (Gelfand and Guibas 2004) and the invariance classes of ISO 17450.
//!
//! A rigid motion of infinitesimal rotation r and translation t moves the point x by r × x + t. It
//! slides a surface over itself when no point moves along its normal n. The motions that nearly do
//! so are the eigenvectors of small eigenvalue of the 6 × 6 matrix Σ (x × n, n)(x × n, n)ᵀ.

use nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector6};

use crate::cloud::{Direction, Point, Vector};
use crate::fit::axes;
use crate::surface::{Cylinder, Plane, Sphere, Surface};

/// The seven invariance classes of ISO 17450, by the motions that leave a surface in place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Invariance {
    /// Two translations, one rotation.
    Planar,
    /// Three rotations.
    Spherical,
    /// One rotation and the translation along its axis.
    Cylindrical,
    /// One screw motion. The paper's table counts its turn and its advance as two.
    Helical,
    /// One translation.
    Prismatic,
    /// One rotation.
    Revolute,
    /// None.
    Complex,
}

impl Invariance {
    /// The name used by ISO 17450.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Planar => "planar",
            Self::Spherical => "spherical",
            Self::Cylindrical => "cylindrical",
            Self::Helical => "helical",
            Self::Prismatic => "prismatic",
            Self::Revolute => "revolute",
            Self::Complex => "complex",
        }
    }
}

/// Result of the analysis of one region.
#[derive(Debug, Clone, PartialEq)]
pub struct Slippage {
    /// Eigenvalues of the matrix, mean over the points, smallest first. Points are centred and have
    /// a mean distance of one from the centre, so these are plain numbers, at most about two.
    pub eigenvalues: [f64; 6],
    /// Invariance class.
    pub class: Invariance,
    /// Mean of the points.
    pub centre: Point,
    /// Axis of the motion: a point on it and its direction (normal of a plane, direction of a
    /// prism); nothing for spherical and complex regions.
    pub axis: Option<(Point, Direction)>,
}

/// Eigenvalues below this count as zero: normals estimated from neighbourhoods are off by some
/// degrees near borders, which leaves up to a thousandth.
const SLIPPABLE: f64 = 3e-3;
/// Largest share of a motion's length for its rotation to count as none.
const NO_ROTATION: f64 = 0.1;
/// Largest advance of a screw, in region sizes per radian, that still counts as a plain rotation.
const NO_PITCH: f64 = 0.03;

impl Slippage {
    /// Analyses points with unit normals of either sign; nothing for fewer than six.
    pub fn of(points: &[Point], normals: &[Vector]) -> Option<Self> {
        if points.len() < 6 {
            return None;
        }
        let count = points.len() as f64;
        let centre = Point::from(points.iter().map(|p| p.coords).sum::<Vector>() / count);
        let size = points.iter().map(|p| (p - centre).norm()).sum::<f64>() / count;
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let mut matrix = Matrix6::zeros();
        for (point, normal) in points.iter().zip(normals) {
            let turn = ((point - centre) / size).cross(normal);
            let row = Vector6::new(turn.x, turn.y, turn.z, normal.x, normal.y, normal.z);
            matrix.ger(1.0 / count, &row, &row, 1.0);
        }
        let eigen = SymmetricEigen::new(matrix);
        let mut order = [0, 1, 2, 3, 4, 5];
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        let eigenvalues = order.map(|i| eigen.eigenvalues[i]);
        let motions: Vec<Motion> = order
            .iter()
            .take_while(|&&i| eigen.eigenvalues[i] < SLIPPABLE)
            .map(|&i| {
                let v = eigen.eigenvectors.column(i);
                Motion {
                    rotation: Vector::new(v[0], v[1], v[2]),
                    translation: Vector::new(v[3], v[4], v[5]),
                }
            })
            .collect();
        let (class, axis) = classify(&motions);
        Some(Self {
            eigenvalues,
            class,
            centre,
            axis: axis.map(|(offset, direction)| (centre + offset * size, direction)),
        })
    }

    /// Where least squares may start to find the one surface of a region of this class. A revolute
    /// region may be a cone or a torus (or part of a sphere): in the half-plane of height h and
    /// distance ρ from the axis a line or a circle. Prismatic, helical and complex regions have none.
    pub fn starts(&self, points: &[Point]) -> Vec<Surface> {
        match (self.class, self.axis) {
            (Invariance::Planar, Some((point, normal))) => {
                vec![Surface::Plane(Plane::new(point, normal.into_inner()))]
            }
            (Invariance::Spherical, _) => sphere(points).into_iter().collect(),
            (Invariance::Cylindrical, Some((point, axis))) => {
                let along = axis.into_inner();
                let distance = |p: &Point| (p - point).cross(&along).norm();
                let radius = points.iter().map(distance).sum::<f64>() / points.len() as f64;
                vec![Surface::Cylinder(Cylinder::new(point, along, radius))]
            }
            (Invariance::Revolute, Some((point, axis))) => revolute(points, point, axis),
            _ => Vec::new(),
        }
    }
}

/// An infinitesimal rigid motion: x moves by rotation × x + translation.
struct Motion {
    rotation: Vector,
    translation: Vector,
}

impl Motion {
    /// Point of the axis of rotation nearest the centre, and its direction.
    fn axis(&self) -> Option<(Vector, Direction)> {
        let squared = self.rotation.norm_squared();
        let direction = Direction::try_new(self.rotation, f64::MIN_POSITIVE)?;
        Some((self.rotation.cross(&self.translation) / squared, direction))
    }
}

/// The class of the space that some independent motions span, and its axis relative to the centre.
fn classify(motions: &[Motion]) -> (Invariance, Option<(Vector, Direction)>) {
    let mut turns = Matrix3::zeros();
    for motion in motions {
        turns += motion.rotation * motion.rotation.transpose();
    }
    // Axes of independent rotations in the space: planes have one, spheres three.
    let eigen = SymmetricEigen::new(turns);
    let rotations = eigen
        .eigenvalues
        .iter()
        .filter(|&&value| value > NO_ROTATION * NO_ROTATION)
        .count();
    let main_turn =
        Direction::new_normalize(eigen.eigenvectors.column(eigen.eigenvalues.imax()).into());
    match (motions.len(), rotations) {
        (3.., 3) => (Invariance::Spherical, None),
        (3.., _) => (Invariance::Planar, plane_normal(motions)),
        (2, 1) => (Invariance::Cylindrical, cylinder_axis(motions, main_turn)),
        (1, 0) => {
            let direction = Direction::try_new(motions[0].translation, f64::MIN_POSITIVE);
            (
                Invariance::Prismatic,
                direction.map(|d| (Vector::zeros(), d)),
            )
        }
        (1, _) => {
            let motion = &motions[0];
            let pitch = motion.rotation.dot(&motion.translation) / motion.rotation.norm_squared();
            let class = if pitch.abs() > NO_PITCH {
                Invariance::Helical
            } else {
                Invariance::Revolute
            };
            (class, motion.axis())
        }
        _ => (Invariance::Complex, None),
    }
}

/// Every translation of a plane is across its normal.
fn plane_normal(motions: &[Motion]) -> Option<(Vector, Direction)> {
    let mut slides = Matrix3::zeros();
    for motion in motions {
        slides += motion.translation * motion.translation.transpose();
    }
    let eigen = SymmetricEigen::new(slides);
    let normal = eigen
        .eigenvectors
        .column(eigen.eigenvalues.imin())
        .into_owned();
    Direction::try_new(normal, f64::MIN_POSITIVE).map(|normal| (Vector::zeros(), normal))
}

/// Of the two motions, a combination is the translation along the axis; the rest is a screw, whose
/// axis does not depend on its advance.
fn cylinder_axis(motions: &[Motion], axis: Direction) -> Option<(Vector, Direction)> {
    let screw = motions.iter().max_by(|a, b| {
        a.rotation
            .norm_squared()
            .total_cmp(&b.rotation.norm_squared())
    })?;
    let turn = screw.rotation.dot(&axis);
    (turn != 0.0).then(|| (axis.cross(&screw.translation) / turn, axis))
}

/// The sphere of least algebraic error.
fn sphere(points: &[Point]) -> Option<Surface> {
    crate::fit::local::starts(crate::surface::SurfaceType::Sphere, points).pop()
}

/// A cone, torus and sphere about the axis.
fn revolute(points: &[Point], origin: Point, axis: Direction) -> Vec<Surface> {
    let section = axes::half_plane(points, &origin, &axis);
    let mut surfaces: Vec<Surface> = axes::cone(&section, &origin, &axis).into_iter().collect();
    if let Some(torus) = axes::torus(&section, &origin, &axis) {
        surfaces.push(torus);
        if let Surface::Torus(shape) = torus {
            surfaces.push(Surface::Sphere(Sphere::new(
                shape.centre,
                shape.minor_radius,
            )));
        }
    }
    surfaces
}

#[cfg(test)]
mod tests;
