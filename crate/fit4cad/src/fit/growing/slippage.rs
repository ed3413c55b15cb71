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
mod tests {
    use super::*;
    use nalgebra::{Isometry3, Translation3, UnitQuaternion};

    /// Slippage of the patch that a parametric surface (point and normal) covers over (-1, 1)²,
    /// turned and moved away from where its formula puts it.
    fn slippage(surface: impl Fn(f64, f64) -> (Vector, Vector)) -> (Slippage, Isometry3<f64>) {
        let turn = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
        let motion = Isometry3::from_parts(Translation3::new(30.0, -20.0, 10.0), turn);
        let (points, normals): (Vec<Point>, Vec<Vector>) = (0..400)
            .map(|i| {
                let at = |k: i32| (f64::from(k) - 9.5) / 10.0;
                let (point, normal) = surface(at(i % 20), at(i / 20));
                (motion * Point::from(point), motion * normal.normalize())
            })
            .unzip();
        (Slippage::of(&points, &normals).unwrap(), motion)
    }

    /// Whether the axis found is the z axis of the formula.
    fn is_about_z((slippage, motion): &(Slippage, Isometry3<f64>)) -> bool {
        let (point, direction) = slippage.axis.unwrap();
        let (point, direction) = (motion.inverse() * point, motion.inverse() * direction);
        point.coords.xy().norm() < 1e-6 && direction.cross(&Vector::z()).norm() < 1e-6
    }

    #[test]
    fn a_flat_patch_is_planar_and_its_axis_is_its_normal() {
        let found = slippage(|u, v| (Vector::new(u, v, 0.0), Vector::z()));
        assert_eq!(found.0.class, Invariance::Planar);
        assert!(is_about_z(&found));
        assert!(found.0.eigenvalues[2] < 1e-12 && found.0.eigenvalues[3] > SLIPPABLE);
    }

    #[test]
    fn a_patch_of_a_sphere_is_spherical() {
        let on = |u: f64, v: f64| Vector::new(u.sin() * v.cos(), v.sin(), u.cos() * v.cos());
        let (found, _) = slippage(|u, v| (on(u, v), on(u, v)));
        assert_eq!((found.class, found.axis), (Invariance::Spherical, None));
    }

    #[test]
    fn half_a_cylinder_is_cylindrical_about_its_axis() {
        let found = slippage(|u, v| {
            let out = Vector::new((1.5 * u).cos(), (1.5 * u).sin(), 0.0);
            (out + Vector::z() * v, out)
        });
        assert_eq!(found.0.class, Invariance::Cylindrical);
        assert!(is_about_z(&found));
    }

    #[test]
    fn a_helicoid_is_helical_about_its_axis() {
        let found = slippage(|u, v| {
            let (turn, radius, rise) = (2.0 * v, 2.0 + u, 0.6);
            let (sin, cos) = turn.sin_cos();
            let point = Vector::new(radius * cos, radius * sin, rise * turn);
            (point, Vector::new(rise * sin, -rise * cos, radius))
        });
        assert_eq!(found.0.class, Invariance::Helical);
        assert!(is_about_z(&found));
    }

    #[test]
    fn an_extruded_parabola_is_prismatic_along_its_rulings() {
        let (found, motion) = slippage(|u, v| {
            (
                Vector::new(u, 1.5 * u * u, v),
                Vector::new(-3.0 * u, 1.0, 0.0),
            )
        });
        assert_eq!(found.class, Invariance::Prismatic);
        let direction = motion.inverse() * found.axis.unwrap().1;
        assert!(direction.cross(&Vector::z()).norm() < 1e-6);
    }

    #[test]
    fn cones_and_tori_are_revolute_about_their_axes() {
        let cone = slippage(|u, v| {
            let (sin, cos) = (1.4 * u).sin_cos();
            let radius = 1.5 + v;
            (
                Vector::new(radius * cos, radius * sin, v),
                Vector::new(cos, sin, -1.0),
            )
        });
        let torus = slippage(|u, v| {
            let (sin, cos) = (1.4 * u).sin_cos();
            let out = Vector::new(cos, sin, 0.0);
            let normal = out * (1.4 * v).cos() + Vector::z() * (1.4 * v).sin();
            (out * 3.0 + normal, normal)
        });
        for found in [cone, torus] {
            assert_eq!(found.0.class, Invariance::Revolute, "{:?}", found.0);
            assert!(is_about_z(&found));
        }
    }

    #[test]
    fn a_patch_of_an_ellipsoid_is_complex() {
        let (found, _) = slippage(|u, v| {
            let on = Vector::new(u.sin() * v.cos(), v.sin(), u.cos() * v.cos());
            let axes = Vector::new(1.0, 2.0, 3.0);
            (on.component_mul(&axes), on.component_div(&axes))
        });
        assert_eq!((found.class, found.axis), (Invariance::Complex, None));
    }

    #[test]
    fn too_few_points_have_no_slippage() {
        assert_eq!(Slippage::of(&[Point::origin(); 5], &[Vector::z(); 5]), None);
        assert_eq!(Slippage::of(&[Point::origin(); 9], &[Vector::z(); 9]), None);
    }

    #[test]
    fn the_section_of_a_revolute_region_starts_its_surface_exactly() {
        let truth = crate::surface::Torus::new(Point::new(1.0, 2.0, 3.0), Vector::z(), 3.0, 1.0);
        let surface = Surface::Torus(truth);
        let points: Vec<Point> = (0..50)
            .map(|i| {
                let (s, t) = (f64::from(i % 7) * 0.3, f64::from(i / 7) * 0.25);
                surface.foot(&(truth.centre + Vector::new(3.9 * s.cos(), 3.9 * s.sin(), t - 0.8)))
            })
            .collect();
        let slippage = Slippage {
            eigenvalues: [0.0; 6],
            class: Invariance::Revolute,
            centre: Point::origin(),
            axis: Some((truth.centre + Vector::z(), Vector::z_axis())),
        };
        let starts = slippage.starts(&points);
        let torus = starts
            .iter()
            .find(|s| matches!(s, Surface::Torus(_)))
            .unwrap();
        assert!(points.iter().all(|p| torus.distance(p) < 1e-9));
    }
}
