//! Whole fits of clouds whose truth is known by construction.

use std::collections::HashSet;

use nalgebra::{Isometry3, Similarity3, Translation3, UnitQuaternion};
use proptest::prelude::*;

use super::*;
use crate::cloud::{Point, Vector};
use crate::metrics::agreement::changed;
use crate::random::Random;
use crate::sample;
use crate::surface::SurfaceType;

/// A plate of 20 × 20 × 4 with a round boss on top, sampled with spacing one, edges included.
fn boss_on_a_plate() -> Vec<Point> {
    let mut points = Vec::new();
    for i in 0..=20 {
        for j in 0..=20 {
            let (x, y) = (f64::from(i) - 10.0, f64::from(j) - 10.0);
            points.push(Point::new(x, y, -4.0));
            if x.hypot(y) > 5.4 {
                points.push(Point::new(x, y, 0.0));
            }
            if x.hypot(y) < 4.6 {
                points.push(Point::new(x, y, 6.0));
            }
            if x.abs() == 10.0 || y.abs() == 10.0 {
                points.extend((1..4).map(|z| Point::new(x, y, -f64::from(z))));
            }
        }
    }
    for turn in 0..32 {
        let (sin, cos) = (f64::from(turn) * std::f64::consts::TAU / 32.0).sin_cos();
        points.extend((0..=6).map(|z| Point::new(5.0 * cos, 5.0 * sin, f64::from(z))));
    }
    points
}

fn fitted(points: &[Point], method: Method, seed: u64) -> Segmentation {
    let cloud = Cloud::new(points.to_vec());
    fit(&cloud, method, &Parameters::default(), seed, &mut ())
        .unwrap()
        .segmentation
}

const METHODS: [Method; 2] = [Method::Hough, Method::Growing];

#[test]
fn a_boss_on_a_plate_is_seven_planes_and_a_cylinder() {
    let points = boss_on_a_plate();
    for method in METHODS {
        let found = fitted(&points, method, 1);
        let count = |kind| {
            found
                .primitives
                .iter()
                .filter(|primitive| primitive.kind == Some(kind))
                .count()
        };
        assert_eq!(
            (count(SurfaceType::Plane), count(SurfaceType::Cylinder)),
            (7, 1),
            "{method:?}"
        );
        let cylinder = found
            .primitives
            .iter()
            .find(|p| p.kind == Some(SurfaceType::Cylinder))
            .unwrap();
        // All of its seven circles, the outer two being edges that the planes list as well.
        assert_eq!(cylinder.points.len(), 7 * 32, "{method:?}");
        for primitive in &found.primitives {
            let surface = primitive.surface.unwrap();
            assert!(
                primitive
                    .points
                    .iter()
                    .all(|&i| surface.distance(&points[i as usize]) < 1e-9)
            );
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_answer() {
    let points = boss_on_a_plate();
    for method in METHODS {
        assert_eq!(fitted(&points, method, 7), fitted(&points, method, 7));
    }
}

#[test]
fn motion_and_scale_leave_the_labels_as_they_are() {
    let points = boss_on_a_plate();
    let turn = UnitQuaternion::from_euler_angles(0.5, -0.3, 0.9);
    let motion = Isometry3::from_parts(Translation3::new(70.0, -30.0, 20.0), turn);
    let moved: Vec<Point> = points.iter().map(|p| motion * (p * 0.25)).collect();
    let lists = |segmentation: Segmentation| {
        let mut lists: Vec<Vec<u32>> = segmentation
            .primitives
            .into_iter()
            .map(|primitive| primitive.points)
            .collect();
        lists.sort();
        lists
    };
    for method in METHODS {
        assert_eq!(
            lists(fitted(&points, method, 3)),
            lists(fitted(&moved, method, 3))
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// Of parts without free-form regions: small accidents in these hang on the last digit.
    #[test]
    fn parts_keep_their_labels_when_turned_moved_and_scaled(
        part in 0..sample::parts().len(),
        turn in prop::array::uniform3(-3.0..3.0f64),
        away in prop::array::uniform3(-100.0..100.0f64),
        exponent in -3.0..3.0f64,
    ) {
        let [roll, pitch, yaw] = turn;
        let turn = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        let scale = 10f64.powf(exponent);
        let away = Vector::from(away) * scale;
        let motion = Similarity3::from_parts(Translation3::from(away), turn, scale);
        let model = sample::generate(sample::parts()[part].name, &Default::default()).unwrap();
        let points = model.cloud.points();
        let listed: HashSet<u32> = model
            .truth
            .iter()
            .flat_map(|truth| &truth.primitives)
            .flat_map(|primitive| primitive.points.iter().copied())
            .collect();
        prop_assume!(listed.len() == points.len());
        let moved: Vec<Point> = points.iter().map(|p| motion * p).collect();
        for method in METHODS {
            let still = fitted(points, method, 1);
            let changed = changed(moved.len(), &still, &fitted(&moved, method, 1));
            prop_assert!(changed as f64 <= 0.005 * moved.len() as f64, "{method:?}: {changed}");
        }
    }
}

/// As fine as the benchmark's clouds: of a coarser one the bends between the points pass for noise.
#[test]
fn a_wavy_sheet_stays_unsegmented() {
    let points: Vec<Point> = (0..10_000)
        .map(|i| {
            let (x, y) = (0.5 * f64::from(i % 100), 0.5 * f64::from(i / 100));
            let wave = (0.31 * x).sin() * (0.23 * y + 0.01 * x * x / 5.0).cos();
            Point::new(x, y, 3.0 * wave)
        })
        .collect();
    for method in METHODS {
        let found = fitted(&points, method, 1);
        let claimed: usize = found.primitives.iter().map(|p| p.points.len()).sum();
        assert!(claimed <= 100, "{method:?}: {claimed} of 10000");
    }
}

#[test]
fn clouds_of_nothing_much_are_fitted_without_harm() {
    let line: Vec<Point> = (0..50)
        .map(|i| Point::from(Vector::x() * f64::from(i)))
        .collect();
    for points in [
        Vec::new(),
        vec![Point::origin()],
        vec![Point::origin(); 40],
        line,
    ] {
        for method in METHODS {
            assert!(fitted(&points, method, 1).primitives.len() <= 1);
        }
    }
}

/// Every surface through a few of the points passes through all of them, so that trying each of them
/// anew took a minute.
#[test]
fn a_long_row_of_points_has_no_face_and_is_soon_given_up() {
    let row = |at: fn(f64) -> Point| (0..10_000).map(|i| at(0.01 * f64::from(i))).collect();
    let line: Vec<Point> = row(|t| Point::new(0.3 * t, 0.7 * t, 0.1 * t));
    let circle = row(|t| {
        let turn = std::f64::consts::TAU * t / 100.0;
        Point::new(16.0 * turn.cos(), 16.0 * turn.sin(), 0.0)
    });
    for points in [line, circle] {
        for method in METHODS {
            assert_eq!(fitted(&points, method, 1).primitives, []);
        }
    }
}

#[test]
fn progress_never_goes_back() {
    struct Follower(Vec<(Stage, f64)>);
    impl Observer for Follower {
        fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
            self.0.push((stage, fraction));
            Ok(())
        }
    }
    let mut random = Random::new(1, 0);
    let exact = boss_on_a_plate();
    let noisy = exact
        .iter()
        .map(|p| p + Vector::from_fn(|_, _| 0.03 * (random.unit() - 0.5)))
        .collect();
    for points in [exact, noisy] {
        let cloud = Cloud::new(points);
        for method in METHODS {
            let mut follower = Follower(Vec::new());
            fit(&cloud, method, &Parameters::default(), 1, &mut follower).unwrap();
            assert!(follower.0.is_sorted(), "{method:?}: {:?}", follower.0);
            assert_eq!(follower.0.last(), Some(&(Stage::Patches, 1.0)));
        }
    }
}

#[test]
fn an_observer_can_stop_a_fit() {
    struct Impatient;
    impl Observer for Impatient {
        fn progress(&mut self, stage: Stage, _: f64) -> Result<(), Cancelled> {
            if stage == Stage::Find {
                Err(Cancelled)
            } else {
                Ok(())
            }
        }
    }
    let cloud = Cloud::new(boss_on_a_plate());
    for method in METHODS {
        let outcome = fit(&cloud, method, &Parameters::default(), 1, &mut Impatient);
        assert_eq!(outcome, Err(Cancelled.into()));
    }
}

/// A boss on a plate, its points off their surfaces by normal noise.
fn noisy_boss(noise: f64) -> Vec<Point> {
    let mut random = Random::new(5, 0);
    let mut off = || noise * random.normal();
    let points = boss_on_a_plate().into_iter();
    points
        .map(|point| point + Vector::new(off(), off(), off()))
        .collect()
}

#[test]
fn noise_that_is_told_is_gone_by_and_reported() {
    let noisy = noisy_boss(0.1);
    let cloud = Cloud::new(noisy);
    let with = |name: &str, value: f64| {
        let mut parameters = Parameters::default();
        parameters.set(name, value).unwrap();
        fit(&cloud, Method::Hough, &parameters, 1, &mut ()).unwrap()
    };
    let told = with("noise", 0.1);
    assert_eq!(told.scale.noise, 0.1);
    assert_eq!(told.noise.deviation, 0.1);
    assert_eq!(
        (told.noise.source, told.noise.kind),
        (noise::Source::Given, None)
    );
    assert_eq!(told.segmentation.primitives.len(), 8);
    let measured = with("noise", 0.0);
    assert_eq!(measured.noise.source, noise::Source::Measured);
    assert_eq!(measured.noise.kind, Some(Kind::Scattered));
    assert!(
        (measured.noise.deviation - 0.1).abs() < 0.03,
        "{:?}",
        measured.noise
    );
    assert_eq!(
        with("tolerance", 0.01).noise.source,
        noise::Source::Tolerance
    );
}

#[test]
fn of_exact_and_of_rounded_points_the_kind_is_told() {
    let points = boss_on_a_plate();
    let noise_of = |points: Vec<Point>| {
        let cloud = Cloud::new(points);
        let parameters = Parameters::default();
        let fit = fit(&cloud, Method::Growing, &parameters, 1, &mut ()).unwrap();
        fit.noise
    };
    let exact = noise_of(points.clone());
    assert_eq!((exact.deviation, exact.kind), (0.0, Some(Kind::Exact)));
    let turn = UnitQuaternion::from_euler_angles(0.3, 0.5, 0.7);
    let round = |x: f64| (x * 10.0).round() / 10.0;
    let rounded = points.iter().map(|point| (turn * point).map(round));
    let rounded = noise_of(rounded.collect());
    assert_eq!((rounded.step, rounded.kind), (0.1, Some(Kind::Rounded)));
}

#[test]
fn noise_as_large_as_the_cloud_is_refused() {
    let cloud = Cloud::new(boss_on_a_plate());
    let mut parameters = Parameters::default();
    parameters.set("noise", 100.0).unwrap();
    let refused = fit(&cloud, Method::Hough, &parameters, 1, &mut ());
    assert!(matches!(refused, Err(FitError::Parameter(_))));
    // There is nothing that it could be larger than.
    assert!(fit(&Cloud::default(), Method::Hough, &parameters, 1, &mut ()).is_ok());
}

#[test]
fn uniform_points_are_on_nothing_whatever_noise_is_told() {
    let mut random = Random::new(2, 0);
    let mut at = || random.unit();
    let points = (0..3000).map(|_| Point::new(at(), at(), at()));
    let cloud = Cloud::new(points.collect());
    for noise in [1e-6, 0.002, 0.01] {
        let mut parameters = Parameters::default();
        parameters.set("noise", noise).unwrap();
        let fit = fit(&cloud, Method::Hough, &parameters, 1, &mut ()).unwrap();
        let found: usize = fit
            .segmentation
            .primitives
            .iter()
            .map(|it| it.points.len())
            .sum();
        assert!(found < 60, "{noise}: {found}");
    }
}

#[test]
fn surfaces_of_noisy_faces_are_as_near_the_truth_as_their_standard_errors_say() {
    let points = noisy_boss(0.05);
    let cloud = Cloud::new(points.clone());
    let found = fitted(&points, Method::Hough, 1);
    let boss = found.primitives.iter().find_map(|it| match it.surface {
        Some(Surface::Cylinder(cylinder)) => Some((it, cylinder)),
        _ => None,
    });
    let (primitive, cylinder) = boss.unwrap();
    let errors = least_squares::StandardErrors::of_primitive(&cloud, primitive);
    let error = errors.radius.unwrap();
    assert!(error < 0.01, "{error}");
    assert!(
        (cylinder.radius - 5.0).abs() < 4.0 * error,
        "{cylinder:?} {error}"
    );
}
