//! The spread of a group of points: principal directions, normals, surface variation.

use nalgebra::{Matrix3, SymmetricEigen};

use super::neighbours::{KdTree, Neighbourhoods};
use super::{Direction, Point, Vector};

/// Principal directions of a group of points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Mean of the points.
    pub centroid: Point,
    /// Variances λ₁ ≤ λ₂ ≤ λ₃ along the directions, in squared units of the cloud.
    pub variances: [f64; 3],
    /// Unit directions, pairwise perpendicular; the first is the normal of the best plane.
    pub directions: [Direction; 3],
}

impl Spread {
    /// The spread of the points, or nothing for no point. O(n).
    pub fn of<'a>(points: impl Iterator<Item = &'a Point> + Clone) -> Option<Self> {
        Self::weighted(points.map(|point| (point, 1.0)))
    }

    /// The spread of points with weights, not negative; nothing where their sum is not positive.
    pub fn weighted<'a>(points: impl Iterator<Item = (&'a Point, f64)> + Clone) -> Option<Self> {
        let (mut sum, mut total) = (Vector::zeros(), 0.0);
        for (point, weight) in points.clone() {
            sum += point.coords * weight;
            total += weight;
        }
        if !(total > 0.0 && total.is_finite()) {
            return None;
        }
        let centroid = Point::from(sum / total);
        let mut covariance = Matrix3::zeros();
        for (point, weight) in points {
            let offset = point - centroid;
            covariance += offset * offset.transpose() * weight;
        }
        covariance /= total;
        if !covariance.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let eigen = SymmetricEigen::new(covariance);
        let mut order = [0, 1, 2];
        // Three are soon in order, by far less code than a sort.
        for (one, other) in [(0, 1), (1, 2), (0, 1)] {
            let [a, b] = [one, other].map(|place: usize| eigen.eigenvalues[order[place]]);
            if a.total_cmp(&b).is_gt() {
                order.swap(one, other);
            }
        }
        Some(Self {
            centroid,
            variances: order.map(|i| eigen.eigenvalues[i].max(0.0)),
            directions: order
                .map(|i| Direction::new_normalize(eigen.eigenvectors.column(i).into())),
        })
    }

    /// Normal of the plane that fits the points best.
    pub fn normal(&self) -> Direction {
        self.directions[0]
    }

    /// Surface variation σ = λ₁ / (λ₁ + λ₂ + λ₃) (paper, section "PG"; Pauly, Gross and Kobbelt
    /// 2002): 0 on a plane, at most 1/3; 0 for points that all coincide.
    pub fn surface_variation(&self) -> f64 {
        let total: f64 = self.variances.iter().sum();
        if total > 0.0 {
            self.variances[0] / total
        } else {
            0.0
        }
    }
}

/// Unit normals of points, without a sign: for each the normal of the plane that best fits it and
/// its `count` nearest neighbours (Hoppe et al. 1992); the z axis where there is no such plane.
/// O(n log n).
pub fn estimate_normals(points: &[Point], count: usize) -> Vec<Direction> {
    let neighbourhoods = Neighbourhoods::new(points, &KdTree::new(points), count);
    (0_u32..)
        .zip(points)
        .map(|(index, point)| {
            let neighbours = neighbourhoods.of(index).iter();
            let near = neighbours.filter_map(|&other| points.get(other as usize));
            let spread = Spread::of(near.chain(std::iter::once(point)));
            spread.map_or_else(Vector::z_axis, |spread| spread.normal())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_has_no_surface_variation_and_its_own_normal() {
        let normal = Direction::new_normalize(Vector::new(1.0, 2.0, 3.0));
        let across = crate::surface::across(&normal);
        let along = normal.cross(&across);
        let points: Vec<Point> = (0..25)
            .map(|i| {
                let (u, v) = (f64::from(i % 5), f64::from(i / 5));
                Point::new(4.0, 5.0, 6.0) + across.into_inner() * u + along * v
            })
            .collect();
        let spread = Spread::of(points.iter()).unwrap();
        assert!(spread.surface_variation() < 1e-15);
        assert!((spread.normal().dot(&normal).abs() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn points_spread_equally_in_all_directions_have_surface_variation_one_third() {
        let points: Vec<Point> = [-1.0, 1.0]
            .iter()
            .flat_map(|&s| {
                [
                    Point::new(s, 0.0, 0.0),
                    Point::new(0.0, s, 0.0),
                    Point::new(0.0, 0.0, s),
                ]
            })
            .collect();
        let spread = Spread::of(points.iter()).unwrap();
        assert!((spread.surface_variation() - 1.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn no_points_have_no_spread_and_coinciding_ones_no_variation() {
        assert_eq!(Spread::of([].iter()), None);
        let same = [Point::origin(); 4];
        assert_eq!(Spread::of(same.iter()).unwrap().surface_variation(), 0.0);
    }

    #[test]
    fn normals_of_a_block_of_points_face_its_sides() {
        let face = |i: u32| (f64::from(i % 12), f64::from(i / 12));
        let top = (0..144).map(face).map(|(u, v)| Point::new(u, v, 20.0));
        let side = (0..144).map(face).map(|(u, v)| Point::new(40.0, u, v));
        let points: Vec<Point> = top.chain(side).collect();
        let normals = estimate_normals(&points, 8);
        assert_eq!(normals.len(), points.len());
        for (point, normal) in points.iter().zip(&normals) {
            let expected = if point.z == 20.0 {
                Vector::z()
            } else {
                Vector::x()
            };
            assert!(normal.dot(&expected).abs() > 1.0 - 1e-9, "{point}");
        }
    }

    #[test]
    fn few_points_or_none_have_normals_too() {
        assert!(estimate_normals(&[], 8).is_empty());
        let alone = estimate_normals(&[Point::origin()], 8);
        assert!((alone[0].norm() - 1.0).abs() < 1e-12);
    }
}
