//! Cylinder, cone and sphere as xᵀAx + 2g·x + l = 0, told apart by the eigenvalues of A.

use nalgebra::Matrix3;

use super::super::conversion::Defect;
use super::super::{Cone, Cylinder, Sphere, Surface};
use crate::cloud::{Direction, Point, Vector};

/// The parts of the vector `a b c d e f g h i l`.
struct Quadric {
    second: Matrix3<f64>,
    first: Vector,
    constant: f64,
}

impl Quadric {
    /// Scaled so that the largest entry of A is 1.
    fn of(values: &[f64]) -> Result<Self, Defect> {
        let &[a, b, c, d, e, f, g, h, i, l] = values else {
            return Err(Defect::NoLeadingTerms);
        };
        let second = Matrix3::new(a, d, e, d, b, f, e, f, c);
        let scale = second.amax();
        if scale <= 0.0 {
            return Err(Defect::NoLeadingTerms);
        }
        Ok(Self {
            second: second / scale,
            first: Vector::new(g, h, i) / scale,
            constant: l / scale,
        })
    }

    fn to_vector(&self) -> Vec<f64> {
        let (a, g) = (&self.second, &self.first);
        let [xx, yy, zz] = [a[(0, 0)], a[(1, 1)], a[(2, 2)]];
        let [xy, xz, yz] = [a[(0, 1)], a[(0, 2)], a[(1, 2)]];
        vec![xx, yy, zz, xy, xz, yz, g.x, g.y, g.z, self.constant]
    }
}

/// A symmetric matrix that has, or should have, a double eigenvalue.
pub(super) struct Revolution {
    /// Eigenvector of the single eigenvalue.
    pub axis: Direction,
    /// The single eigenvalue.
    pub along: f64,
    /// Mean of the two that should be equal.
    pub across: f64,
}

impl Revolution {
    /// Takes the two eigenvalues that lie nearest each other as the double one.
    pub fn of(matrix: Matrix3<f64>) -> Result<Self, Defect> {
        const SWEEPS: usize = 1000;
        let eigen = nalgebra::SymmetricEigen::try_new(matrix, f64::EPSILON, SWEEPS)
            .ok_or(Defect::Overflow)?;
        let values = eigen.eigenvalues;
        let gap = |single: usize| {
            let (one, other) = ((single + 1) % 3, (single + 2) % 3);
            (values[one] - values[other]).abs()
        };
        let single = (1..3).fold(
            0,
            |best, next| if gap(next) < gap(best) { next } else { best },
        );
        let (one, other) = ((single + 1) % 3, (single + 2) % 3);
        Ok(Self {
            axis: Direction::new_normalize(eigen.eigenvectors.column(single).into_owned()),
            along: values[single],
            across: (values[one] + values[other]) / 2.0,
        })
    }
}

pub(super) fn sphere(values: &[f64]) -> Result<Surface, Defect> {
    let quadric = Quadric::of(values)?;
    let lead = quadric.second.trace() / 3.0;
    if lead == 0.0 {
        return Err(Defect::NoLeadingTerms);
    }
    let centre = -quadric.first / lead;
    let radius = root(centre.norm_squared() - quadric.constant / lead)?;
    Ok(Surface::Sphere(Sphere::new(Point::from(centre), radius)))
}

pub(super) fn cylinder(values: &[f64]) -> Result<Surface, Defect> {
    let quadric = Quadric::of(values)?;
    let Revolution { axis, across, .. } = Revolution::of(quadric.second)?;
    if across == 0.0 {
        return Err(Defect::NoAxis);
    }
    let first = quadric.first - axis.into_inner() * quadric.first.dot(&axis);
    let centre = -first / across;
    let radius = root(centre.norm_squared() - quadric.constant / across)?;
    let cylinder = Cylinder::new(Point::from(centre), axis.into_inner(), radius);
    Ok(Surface::Cylinder(cylinder))
}

pub(super) fn cone(values: &[f64]) -> Result<Surface, Defect> {
    let quadric = Quadric::of(values)?;
    let revolution = Revolution::of(quadric.second)?;
    let (axis, along, across) = (revolution.axis, revolution.along, revolution.across);
    if across == 0.0 || along == 0.0 {
        return Err(Defect::NoOpening);
    }
    let half_angle = libm::atan(root(-along / across)?);
    // A⁻¹ from the eigenvalues: along the axis and across it.
    let height = quadric.first.dot(&axis);
    let radial = quadric.first - axis.into_inner() * height;
    let apex = -(radial / across + axis.into_inner() * (height / along));
    let cone = Cone::new(Point::from(apex), axis.into_inner(), half_angle);
    Ok(Surface::Cone(cone))
}

fn root(square: f64) -> Result<f64, Defect> {
    if square > 0.0 {
        Ok(square.sqrt())
    } else if square == 0.0 {
        Err(Defect::NoRadius)
    } else if square.is_nan() {
        Err(Defect::Overflow)
    } else {
        Err(Defect::Imaginary { square })
    }
}

pub(super) fn of_sphere(sphere: &Sphere) -> Vec<f64> {
    let centre = sphere.centre.coords;
    Quadric {
        second: Matrix3::identity(),
        first: -centre,
        constant: difference_of_squares(centre.norm(), sphere.radius),
    }
    .to_vector()
}

/// The centre is the point of the axis nearest the origin, so A·centre = centre.
pub(super) fn of_cylinder(cylinder: &Cylinder) -> Vec<f64> {
    let (axis, centre) = (cylinder.axis.into_inner(), cylinder.centre.coords);
    Quadric {
        second: Matrix3::identity() - axis * axis.transpose(),
        first: -centre,
        constant: difference_of_squares(centre.norm(), cylinder.radius),
    }
    .to_vector()
}

pub(super) fn of_cone(cone: &Cone) -> Vec<f64> {
    let (axis, apex) = (cone.axis.into_inner(), cone.apex.coords);
    let slope = libm::tan(cone.half_angle);
    let second = Matrix3::identity() - axis * axis.transpose() * (1.0 + slope * slope);
    let height = apex.dot(&axis);
    let radius = (apex - axis * height).norm();
    Quadric {
        second,
        first: -(second * apex),
        constant: difference_of_squares(radius, slope * height),
    }
    .to_vector()
}

/// a² − b² without the rounding of large squares.
fn difference_of_squares(a: f64, b: f64) -> f64 {
    (a - b) * (a + b)
}
