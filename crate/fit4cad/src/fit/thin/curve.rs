//! Points on a line or a circle: one row or ring of points, through which too many surfaces pass.

use nalgebra::{Matrix3, Vector3};

use crate::cloud::Point;
use crate::cloud::normals::Spread;

/// Whether all points lie on one line or one circle. O(n).
pub fn is_curve(points: &[Point], tolerance: f64) -> bool {
    let Some(Spread {
        centroid,
        directions: [normal, second, first],
        ..
    }) = Spread::of(points.iter())
    else {
        return true;
    };
    let mut flat = Vec::with_capacity(points.len());
    for point in points {
        let offset = point - centroid;
        if offset.dot(&normal).abs() > tolerance {
            return false;
        }
        flat.push([offset.dot(&first), offset.dot(&second)]);
    }
    if flat.iter().all(|[_, y]| y.abs() <= tolerance) {
        return true;
    }
    let Some(([x, y], radius)) = circle(&flat) else {
        return false;
    };
    let on = |at: &[f64; 2]| {
        let distance = ((at[0] - x).powi(2) + (at[1] - y).powi(2)).sqrt();
        (distance - radius).abs() <= tolerance
    };
    flat.iter().all(on)
}

/// The circle of least algebraic error (Kåsa, 1976), x² + y² = 2ax + 2by + c: centre and radius.
/// `None` for points on a line. O(n).
pub fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let count = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|p| p[axis]).sum::<f64>() / count);
    let squared = |p: &[f64; 2]| (p[0] - mean[0]).powi(2) + (p[1] - mean[1]).powi(2);
    let scale = points.iter().map(squared).fold(0.0, f64::max).sqrt();
    let mut matrix = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for p in points {
        let (x, y) = ((p[0] - mean[0]) / scale, (p[1] - mean[1]) / scale);
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        matrix += row * row.transpose();
        right += row * (x * x + y * y);
    }
    let solution = matrix.cholesky()?.solve(&right);
    let radius = (solution[2] + solution[0].powi(2) + solution[1].powi(2)).sqrt() * scale;
    let centre = [mean[0] + solution[0] * scale, mean[1] + solution[1] * scale];
    (radius.is_finite() && centre[0].is_finite() && centre[1].is_finite())
        .then_some((centre, radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;

    fn arc(lift: f64) -> Vec<Point> {
        let turn = nalgebra::Rotation3::new(Vector::new(0.4, 0.1, -0.7));
        (0..9)
            .map(|i| {
                let (sin, cos) = (0.2 * f64::from(i)).sin_cos();
                Point::new(1.0, 2.0, 3.0) + turn * Vector::new(cos, sin, lift * f64::from(i % 2))
            })
            .collect()
    }

    #[test]
    fn an_arc_and_a_line_are_curves_and_two_arcs_are_not() {
        assert!(is_curve(&arc(0.0), 1e-9));
        assert!(!is_curve(&arc(0.1), 1e-9));
        let line: Vec<Point> = (0..9).map(|i| Point::new(f64::from(i), 2.0, 3.0)).collect();
        assert!(is_curve(&line, 1e-9));
        assert!(is_curve(&[], 1e-9));
    }

    #[test]
    fn exact_points_give_their_circle() {
        let points: Vec<[f64; 2]> = (0..5)
            .map(|i| {
                let (sin, cos) = (0.3 * f64::from(i)).sin_cos();
                [4.0 + 0.5 * cos, -3.0 + 0.5 * sin]
            })
            .collect();
        let (centre, radius) = circle(&points).unwrap();
        assert!((centre[0] - 4.0).abs() < 1e-9 && (centre[1] + 3.0).abs() < 1e-9);
        assert!((radius - 0.5).abs() < 1e-9);
    }
}
