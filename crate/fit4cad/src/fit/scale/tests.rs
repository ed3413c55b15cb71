//! Scales of clouds whose spacing and noise are known.

use super::*;
use crate::cloud::Vector;
use crate::cloud::neighbours::KdTree;

fn measured(points: Vec<Point>, tolerance: f64) -> Scale {
    let graph = Neighbourhoods::new(&points, &KdTree::new(&points), 16);
    Scale::measure(&Cloud::new(points), &graph, tolerance)
}

/// A square plate of 40 × 40 points with spacing one.
fn plate() -> Vec<Point> {
    (0..1600)
        .map(|i| Point::new(f64::from(i % 40), f64::from(i / 40), 2.0))
        .collect()
}

/// Points spread evenly over a sphere of radius ten (Fibonacci's spiral).
fn ball() -> Vec<Point> {
    (0..2000)
        .map(|i| {
            let z = 1.0 - (f64::from(i) + 0.5) / 1000.0;
            let (sin, cos) = (f64::from(i) * 2.399_963_229_728_653).sin_cos();
            let r = (1.0 - z * z).sqrt();
            Point::new(10.0 * r * cos, 10.0 * r * sin, 10.0 * z)
        })
        .collect()
}

/// Displaces every coordinate by normal deviates: the sum of twelve uniform ones, less its mean.
fn shaken(points: &[Point], sigma: f64, seed: u64) -> Vec<Point> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    points
        .iter()
        .map(|p| p + Vector::new(normal(), normal(), normal()) * sigma)
        .collect()
}

#[test]
fn a_clean_cloud_has_the_finest_tolerance() {
    for points in [plate(), ball()] {
        let scale = measured(points, 0.0);
        assert_eq!(scale.tolerance, LEVELS[0] * scale.diagonal);
        assert_eq!(scale.noise, scale.tolerance / SIGMAS);
        assert!(scale.is_clean());
    }
}

/// Steps of 1/400 leave points up to 6e-5 of the diagonal off their sphere, most of them within 4e-5.
/// The sphere is a little smaller, lest its heights be such steps already.
#[test]
fn rounded_coordinates_have_a_larger_tolerance_and_are_clean_all_the_same() {
    let rounded = ball()
        .iter()
        .map(|p| p.map(|x| (x * 0.987 * 400.0).round() / 400.0))
        .collect();
    let scale = measured(rounded, 0.0);
    assert_eq!(scale.tolerance, LEVELS[2] * scale.diagonal);
    assert!(scale.is_clean(), "{scale:?}");
}

#[test]
fn the_noise_of_a_shaken_cloud_is_estimated_within_a_fifth() {
    for (points, sigma) in [
        (plate(), 0.05),
        (plate(), 0.2),
        (ball(), 0.02),
        (ball(), 0.1),
    ] {
        for seed in 0..3 {
            let scale = measured(shaken(&points, sigma, seed), 0.0);
            let ratio = scale.noise / sigma;
            assert!((0.8..=1.2).contains(&ratio), "σ = {sigma}: {ratio}");
            assert_eq!(scale.tolerance, SIGMAS * scale.noise);
            assert!(!scale.is_clean());
        }
    }
}

#[test]
fn a_tolerance_that_is_asked_for_overrides_the_estimate_and_nothing_else() {
    let (estimated, asked) = (measured(plate(), 0.0), measured(plate(), 0.01));
    assert_eq!(asked.tolerance, 0.01 * asked.diagonal);
    assert_eq!(asked.noise, estimated.noise);
    assert!(!asked.is_clean());
}

#[test]
fn the_spacing_is_that_of_the_lattice_however_often_its_points_are_listed() {
    assert_eq!(measured(plate(), 0.0).spacing, 1.0);
    let twice = [plate(), plate()].concat();
    assert_eq!(measured(twice, 0.0).spacing, 1.0);
    let larger = plate().iter().map(|p| p * 3.0).collect();
    assert_eq!(measured(larger, 0.0).spacing, 3.0);
}

#[test]
fn clouds_of_no_extent_have_a_scale_of_zero() {
    for points in [Vec::new(), vec![Point::new(1.0, 2.0, 3.0); 30]] {
        let scale = measured(points, 0.0);
        assert_eq!(scale.spacing, 0.0);
        assert!(!scale.is_clean());
    }
}

#[test]
fn a_quantile_is_the_value_at_its_share_of_the_order() {
    let mut values = [5.0, 1.0, 4.0, 2.0, 3.0];
    assert_eq!(quantile(&mut values, 0.0), 1.0);
    assert_eq!(quantile(&mut values, 0.5), 3.0);
    assert_eq!(quantile(&mut values, 1.0), 5.0);
    assert_eq!(quantile(&mut [], 0.5), 0.0);
}
