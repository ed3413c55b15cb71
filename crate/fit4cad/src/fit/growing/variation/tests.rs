//! Surface variation of known configurations, and η of known histograms.

use super::*;
use crate::cloud::neighbours::KdTree;

fn grid(height: impl Fn(f64, f64) -> f64) -> Vec<Point> {
    (0..900)
        .map(|i| {
            let (x, y) = (f64::from(i % 30), f64::from(i / 30));
            Point::new(x, y, height(x, y))
        })
        .collect()
}

fn variation(points: &[Point]) -> Vec<f64> {
    let tree = KdTree::new(points);
    surface_variation(points, &Neighbourhoods::new(points, &tree, 16), 15)
}

#[test]
fn a_plane_has_no_variation_and_no_sharp_point() {
    let values = variation(&grid(|x, y| 0.5 * x - 0.2 * y));
    assert!(values.iter().all(|&value| value < 1e-12));
    let threshold = threshold(&values, 0.0);
    assert!(values.iter().all(|&value| value <= threshold.value));
}

#[test]
fn the_points_along_a_roof_ridge_are_the_sharp_ones() {
    let points = grid(|x, _| -(x - 15.0).abs());
    let values = variation(&points);
    let threshold = threshold(&values, 0.0);
    for (point, value) in points.iter().zip(&values) {
        match (point.x - 15.0).abs() {
            distance if distance < 0.5 => assert!(*value > threshold.value),
            distance if distance > 3.5 => assert!(*value <= threshold.value),
            _ => {}
        }
    }
    assert!((0.65..=0.95).contains(&threshold.quantile));
}

#[test]
fn a_quantile_asked_for_is_the_one_used() {
    let values: Vec<f64> = (1..=100).map(|i| f64::from(i) / 1000.0).collect();
    let threshold = threshold(&values, 0.8);
    assert_eq!(threshold.quantile, 0.8);
    assert_eq!(values.iter().filter(|&&v| v > threshold.value).count(), 20);
}

/// A point amid four neighbours at distance one around it and one at distance h on either side: two
/// variances are equal and the third is h² of them.
#[test]
fn the_variation_of_a_cross_is_that_of_its_axes() {
    for (height, variation) in [(0.0, 0.0), (0.5, 1.0 / 9.0), (1.0, 1.0 / 3.0)] {
        let mut points = vec![Point::new(7.0, -3.0, 2.0)];
        for (axis, length) in [1.0, 1.0, height].into_iter().enumerate() {
            for side in [-length, length] {
                let mut end = points[0];
                end[axis] += side;
                points.push(end);
            }
        }
        let tree = KdTree::new(&points);
        let graph = Neighbourhoods::new(&points, &tree, 6);
        let values = surface_variation(&points, &graph, 6);
        assert!((values[0] - variation).abs() < 1e-12, "{height}");
    }
}

/// A sheet folded along the line of points in its middle.
#[test]
fn a_fold_varies_most_at_a_right_angle() {
    let fold = |angle: f64| {
        let (sin, cos) = (0.5 * angle).sin_cos();
        let points: Vec<Point> = grid(|_, _| 0.0)
            .iter()
            .map(|p| Point::new((p.x - 15.0) * cos, p.y, -(p.x - 15.0).abs() * sin))
            .collect();
        let middle = points.iter().position(|p| p.x == 0.0 && p.y == 15.0);
        variation(&points)[middle.unwrap()]
    };
    let degrees = |angle: f64| fold(angle.to_radians());
    assert!(degrees(0.0) < 1e-12);
    assert!(degrees(30.0) < degrees(60.0) && degrees(60.0) < degrees(90.0));
}

#[test]
fn the_quantile_is_the_share_of_flat_points_within_the_range_of_the_paper() {
    for (flat, quantile) in [(50, 0.65), (65, 0.65), (80, 0.8), (95, 0.95), (99, 0.95)] {
        let mut values = vec![1e-7; flat];
        values.extend((flat..100).map(|i| 0.05 + 0.001 * i as f64));
        let threshold = threshold(&values, 0.0);
        assert_eq!(threshold.quantile, quantile, "{flat} flat points");
        let sharp = values.iter().filter(|&&value| value > threshold.value);
        // As many as the quantile leaves above it, but nothing flat is sharp.
        let expected = (100.0 * (1.0 - quantile)).min(100.0 - flat as f64);
        assert!(
            (sharp.count() as f64 - expected).abs() <= 1.0,
            "{flat} flat points"
        );
    }
}

#[test]
fn no_points_have_a_threshold_and_no_variation() {
    assert_eq!(variation(&[]), Vec::<f64>::new());
    assert!(threshold(&[], 0.0).value > 0.0);
    assert_eq!(variation(&[Point::origin(); 3]), [0.0; 3]);
}
