//! How rough a neighbourhood is: what a smooth sheet through it leaves.

use nalgebra::{SMatrix, SVector};

use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Point};

/// Coefficients of the height function.
const COEFFICIENTS: usize = 6;

/// Residual standard deviation of the height function c₀ + c₁x + c₂y + c₃x² + c₄xy + c₅y² over the plane of
/// a patch, corrected for its coefficients. `None` for fewer than nine points, or points near a line. O(n).
pub fn residual(patch: &[Point]) -> Option<f64> {
    if patch.len() < COEFFICIENTS + 3 {
        return None;
    }
    let spread = Spread::of(patch.iter())?;
    let scale = Ball::of(patch).radius;
    let [normal, second, first] = spread.directions;
    let mut matrix = SMatrix::<f64, COEFFICIENTS, COEFFICIENTS>::zeros();
    let mut right = SVector::<f64, COEFFICIENTS>::zeros();
    let mut square = 0.0;
    for point in patch {
        let offset = (point - spread.centroid) / scale;
        let (x, y, h) = (offset.dot(&first), offset.dot(&second), offset.dot(&normal));
        let row = [1.0, x, y, x * x, x * y, y * y];
        for j in 0..COEFFICIENTS {
            right[j] += h * row[j];
            for i in j..COEFFICIENTS {
                matrix[(i, j)] += row[i] * row[j];
            }
        }
        square += h * h;
    }
    matrix.fill_upper_triangle_with_lower_triangle();
    let solved = matrix.cholesky()?.solve(&right);
    let left = (square - solved.dot(&right)).max(0.0);
    Some((left / (patch.len() - COEFFICIENTS) as f64).sqrt() * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bent_sheet_is_smooth_and_a_folded_one_is_not() {
        let patch = |height: fn(f64, f64) -> f64| -> Vec<Point> {
            (0..49)
                .map(|i| (f64::from(i % 7) - 3.0, f64::from(i / 7) - 3.0))
                .map(|(x, y)| Point::new(x, y, height(x, y)))
                .collect()
        };
        let bent = patch(|x, y| 0.1 * x * x - 0.05 * x * y);
        assert!(residual(&bent).unwrap() < 0.03);
        assert!(residual(&patch(|x, _| x.abs())).unwrap() > 0.1);
        assert_eq!(residual(&bent[..8]), None);
    }
}
