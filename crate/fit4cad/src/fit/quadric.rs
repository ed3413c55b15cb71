//! The algebraic quadric through a neighbourhood, read as a cylinder or a cone.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use nalgebra::{Matrix3, SMatrix, SVector, SymmetricEigen};

use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Point, Vector};
use crate::surface::{Cone, Cylinder};

/// The quadric xᵀAx + 2b·x + c = 0 of least algebraic error with |(A, b, c)| = 1, in coordinates
/// centred on the neighbourhood and scaled to its extent. The norm is Frobenius', so that turned points have
/// the turned quadric.
#[derive(Debug, Clone, PartialEq)]
pub struct Quadric {
    matrix: Matrix3<f64>,
    linear: Vector,
    constant: f64,
    origin: Point,
    scale: f64,
    /// Root mean square distance of the points to the quadric to first order (Taubin, 1991), in the
    /// units of the cloud.
    pub error: f64,
}

impl Quadric {
    /// The quadric through at least nine points. O(n).
    pub fn of(patch: &[Point]) -> Option<Self> {
        if patch.len() < 9 {
            return None;
        }
        let origin = Spread::of(patch.iter())?.centroid;
        let scale = SQRT_2 * Ball::of(patch).radius;
        let mut moments = SMatrix::<f64, 10, 10>::zeros();
        for point in patch {
            let p = (point - origin) / scale;
            let row = SVector::<f64, 10>::from([
                p.x * p.x,
                p.y * p.y,
                p.z * p.z,
                SQRT_2 * p.x * p.y,
                SQRT_2 * p.x * p.z,
                SQRT_2 * p.y * p.z,
                2.0 * p.x,
                2.0 * p.y,
                2.0 * p.z,
                1.0,
            ]);
            for j in 0..10 {
                for i in j..10 {
                    moments[(i, j)] += row[i] * row[j];
                }
            }
        }
        moments.fill_upper_triangle_with_lower_triangle();
        let eigen = SymmetricEigen::new(moments);
        let q = eigen
            .eigenvectors
            .column(eigen.eigenvalues.imin())
            .into_owned();
        // A coefficient beside the diagonal stands in the matrix twice, which its square counts.
        let [xy, xz, yz] = [q[3], q[4], q[5]].map(|beside| beside * FRAC_1_SQRT_2);
        let mut quadric = Self {
            matrix: Matrix3::new(q[0], xy, xz, xy, q[1], yz, xz, yz, q[2]),
            linear: Vector::new(q[6], q[7], q[8]),
            constant: q[9],
            origin,
            scale,
            error: 0.0,
        };
        let (mut values, mut gradients) = (0.0, 0.0);
        for point in patch {
            let p = (point - origin) / scale;
            let slope = quadric.matrix * p + quadric.linear;
            values += (p.dot(&slope) + p.dot(&quadric.linear) + quadric.constant).powi(2);
            gradients += 4.0 * slope.norm_squared();
        }
        quadric.error = (values / gradients).sqrt() * scale;
        quadric.error.is_finite().then_some(quadric)
    }

    /// The quadric read as a cylinder.
    pub fn cylinder(&self) -> Option<Cylinder> {
        let Revolution {
            axis, across, pair, ..
        } = self.revolution();
        let radius = (across.norm_squared() - self.constant / pair).sqrt();
        radius
            .is_finite()
            .then(|| Cylinder::new(self.origin + across * self.scale, axis, radius * self.scale))
    }

    /// The quadric read as a cone.
    pub fn cone(&self) -> Option<Cone> {
        let Revolution {
            axis,
            across,
            pair,
            along,
        } = self.revolution();
        let apex = across - axis * (self.linear.dot(&axis) / along);
        let half_angle = libm::atan((-along / pair).sqrt());
        let finite = half_angle.is_finite() && apex.iter().all(|x| x.is_finite());
        finite.then(|| Cone::new(self.origin + apex * self.scale, axis, half_angle))
    }

    /// The nearest quadric of revolution: the axis belongs to the eigenvalue of A that differs
    /// from two others, which are taken to be equal.
    fn revolution(&self) -> Revolution {
        let eigen = SymmetricEigen::new(self.matrix);
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
        let [low, middle, high] = order.map(|i| eigen.eigenvalues[i]);
        let (odd, pair) = if middle - low > high - middle {
            (order[0], 0.5 * (middle + high))
        } else {
            (order[2], 0.5 * (low + middle))
        };
        let axis = eigen.eigenvectors.column(odd).into_owned();
        let b = self.linear;
        Revolution {
            axis,
            across: -(b - axis * b.dot(&axis)) / pair,
            pair,
            along: eigen.eigenvalues[odd],
        }
    }
}

/// A quadric's axis of revolution.
struct Revolution {
    axis: Vector,
    /// Where the axis pierces the plane across it through the origin.
    across: Vector,
    /// Eigenvalue of both directions across the axis.
    pair: f64,
    /// Eigenvalue of the axis.
    along: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a surface of revolution about an oblique axis: `radius(height)` over 60°.
    fn patch(radius: impl Fn(f64) -> f64) -> Vec<Point> {
        let turn = nalgebra::Rotation3::new(Vector::new(0.3, -0.5, 0.2));
        (0..24)
            .map(|i| {
                let (height, angle) = (f64::from(i / 6) * 0.2 + 0.3, f64::from(i % 6) * 0.2);
                let (r, (sin, cos)) = (radius(height), angle.sin_cos());
                Point::new(4.0, 5.0, 6.0) + turn * Vector::new(r * cos, r * sin, height)
            })
            .collect()
    }

    #[test]
    fn exact_points_of_a_cylinder_or_cone_give_it_back() {
        let points = patch(|_| 0.7);
        let cylinder = Quadric::of(&points).unwrap().cylinder().unwrap();
        assert!((cylinder.radius - 0.7).abs() < 1e-9);
        let points = patch(|height| 0.5 * height);
        let cone = Quadric::of(&points).unwrap().cone().unwrap();
        assert!((cone.half_angle.tan() - 0.5).abs() < 1e-9);
        assert!((cone.apex - Point::new(4.0, 5.0, 6.0)).norm() < 1e-9);
    }

    #[test]
    fn the_error_tells_quadrics_from_other_surfaces() {
        assert!(Quadric::of(&patch(|_| 0.7)).unwrap().error < 1e-9);
        let waves = patch(|height| 0.7 + 0.1 * (9.0 * height).sin());
        assert!(Quadric::of(&waves).unwrap().error > 1e-4);
    }

    #[test]
    fn too_few_points_have_no_quadric() {
        assert_eq!(Quadric::of(&patch(|_| 1.0)[..8]), None);
    }
}
