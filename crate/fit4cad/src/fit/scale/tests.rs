//! Scales of clouds whose spacing and noise are known.

use nalgebra::UnitQuaternion;

use super::*;
use crate::cloud::Vector;
use crate::random::Random;

fn measured(points: Vec<Point>, tolerance: f64) -> Scale {
    let tree = KdTree::new(&points);
    let graph = Neighbourhoods::new(&points, &tree, 16);
    Scale::measure(&Cloud::new(points), &tree, &graph, tolerance)
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
    let mut random = Random::new(seed, 0);
    let mut normal = || (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
    points
        .iter()
        .map(|p| p + Vector::new(normal(), normal(), normal()) * sigma)
        .collect()
}

/// Two thirds of a cylinder of radius eight and height thirty, spacing about one, upright.
fn barrel() -> Vec<Point> {
    (0..1050)
        .map(|i| {
            let (sin, cos) = (0.12 * f64::from(i % 35)).sin_cos();
            Point::new(8.0 * cos, 8.0 * sin, f64::from(i / 35))
        })
        .collect()
}

/// Plates of spacing one, a third of the spacing apart: the nearest points of most are on the other.
fn thin_wall() -> Vec<Point> {
    let other = plate().into_iter().map(|p| p + Vector::new(0.4, 0.3, 0.33));
    plate().into_iter().chain(other).collect()
}

/// A sphere of so few points that a neighbourhood reaches far around it.
fn sparse_ball() -> Vec<Point> {
    ball().into_iter().step_by(13).collect()
}

/// So that no face is along the coordinate planes.
fn turned(points: Vec<Point>) -> Vec<Point> {
    let turn = UnitQuaternion::from_euler_angles(0.7, -0.4, 1.3);
    points.iter().map(|point| turn * point).collect()
}

#[test]
fn a_clean_cloud_has_the_finest_tolerance() {
    for points in [plate(), ball(), barrel(), thin_wall(), sparse_ball()] {
        let scale = measured(points, 0.0);
        assert_eq!(scale.noise, FLOOR * scale.diameter);
        assert_eq!(scale.tolerance, SIGMAS * scale.noise);
        assert!(scale.is_clean());
    }
}

#[test]
fn noise_is_estimated_within_a_fifth_from_none_to_a_thousandth_of_the_extent() {
    for (name, points) in [
        ("plate", turned(plate())),
        ("ball", ball()),
        ("barrel", turned(barrel())),
        ("sparse ball", sparse_ball()),
    ] {
        let diameter = Ball::of(&points).diameter();
        for exponent in [-9.0, -7.0, -6.0, -5.5, -5.0, -4.5, -4.0, -3.5, -3.0] {
            let sigma = 10f64.powf(exponent);
            let scale = measured(shaken(&points, sigma * diameter, 5), 0.0);
            let ratio = scale.noise / (sigma.max(FLOOR) * diameter);
            assert!(
                (0.75..=1.25).contains(&ratio),
                "{name}, σ = {sigma}: {ratio}"
            );
        }
    }
}

#[test]
fn a_thin_wall_is_not_taken_for_a_noisy_plate() {
    for sigma in [0.001, 0.005, 0.01] {
        let scale = measured(shaken(&thin_wall(), sigma, 3), 0.0);
        let ratio = scale.noise / sigma;
        assert!((0.8..=1.2).contains(&ratio), "σ = {sigma}: {ratio}");
    }
}

/// Half of the points of a ball moved inwards by a third of the spacing: the sheets of a shell.
fn shell() -> Vec<Point> {
    let sheets = (0..).zip(ball());
    sheets
        .map(|(i, p)| if i % 2 == 0 { p } else { p * 0.97 })
        .collect()
}

#[test]
fn a_shell_as_thin_as_its_spacing_is_not_taken_for_a_noisy_ball() {
    let scale = measured(shell(), 0.0);
    assert!(!scale.has_noise(), "{scale:?}");
    let scale = measured(shaken(&shell(), 0.01, 3), 0.0);
    assert!(scale.has_noise(), "{scale:?}");
}

#[test]
fn a_few_exact_points_do_not_make_a_noisy_cloud_exact() {
    let marker = ball().into_iter().step_by(67);
    let marker = marker.map(|p| p * 0.1 + Vector::new(30.0, 0.0, 0.0));
    let cloud = shaken(&ball(), 0.01, 3).into_iter().chain(marker);
    assert!(measured(cloud.collect(), 0.0).has_noise());
}

/// Rounding to a step displaces points evenly by up to half of it; its variance is a twelfth.
#[test]
fn coordinates_of_few_digits_have_the_noise_of_rounding() {
    for step in [1e-2, 1e-3, 1e-4] {
        for points in [ball(), barrel(), turned(plate())] {
            let rounded = points.iter().map(|p| p.map(|x| (x / step).round() * step));
            let scale = measured(rounded.collect(), 0.0);
            let expected = (step / 12f64.sqrt()).max(FLOOR * scale.diameter);
            assert!(
                (scale.noise / expected - 1.0).abs() < 1e-9,
                "{step}: {scale:?}"
            );
        }
    }
}

#[test]
fn faces_along_the_coordinate_planes_do_not_hide_that_the_others_are_rounded() {
    let mut points: Vec<Point> = plate();
    points.extend(plate().iter().map(|p| Point::new(p.z, p.x, p.y)));
    let exact = measured(points.clone(), 0.0);
    assert_eq!(exact.noise, FLOOR * exact.diameter);
    points.extend(
        barrel()
            .iter()
            .map(|p| (p * 0.987).map(|x| (x * 100.0).round() / 100.0)),
    );
    let scale = measured(points, 0.0);
    assert!(scale.noise > 3.0 * FLOOR * scale.diameter, "{scale:?}");
}

/// Whatever bends as no simple surface does leaves larger residuals, and more of them.
#[test]
fn a_free_form_region_is_not_taken_for_noise_where_faces_are_exact() {
    let bowl = plate().into_iter().map(|p| {
        let (x, y) = ((p.x - 20.0) / 10.0, (p.y - 20.0) / 10.0);
        Point::new(p.x + 45.0, p.y, (1.3 * x).sin() * y.cos() * 4.0)
    });
    let points = bowl.chain(ball().into_iter().take(300)).collect();
    let scale = measured(points, 0.0);
    assert_eq!(scale.noise, FLOOR * scale.diameter);
}

#[test]
fn noise_that_is_large_against_the_spacing_has_a_tolerance_of_fewer_deviations() {
    for (points, sigma) in [
        (plate(), 0.05),
        (plate(), 0.2),
        (ball(), 0.05),
        (ball(), 0.1),
    ] {
        for seed in 0..3 {
            let scale = measured(shaken(&points, sigma, seed), 0.0);
            let ratio = scale.noise / sigma;
            assert!((0.8..=1.2).contains(&ratio), "σ = {sigma}: {ratio}");
            assert_eq!(scale.tolerance, NOISY_SIGMAS * scale.noise);
            assert!(!scale.is_clean());
        }
    }
}

#[test]
fn the_tolerance_grows_with_the_noise_without_a_step() {
    let scales = (0..24).map(|i| {
        let sigma = 1e-6 * 10f64.powf(f64::from(i) / 6.0);
        measured(shaken(&ball(), sigma * 34.6, 4), 0.0)
    });
    let scales: Vec<Scale> = scales.collect();
    for pair in scales.windows(2) {
        let ratio = pair[1].tolerance / pair[0].tolerance;
        assert!((0.95..1.8).contains(&ratio), "{pair:?}");
        assert!(pair[1].redundancy() >= pair[0].redundancy());
        assert!(pair[0].is_clean() || !pair[1].is_clean());
    }
}

#[test]
fn a_tolerance_that_is_asked_for_overrides_the_estimate_and_nothing_else() {
    let (estimated, asked) = (measured(plate(), 0.0), measured(plate(), 0.01));
    let diagonal = Cloud::new(plate()).bounds().diagonal();
    assert_eq!(asked.tolerance, 0.01 * diagonal);
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
