//! What must hold of every score, whatever the data.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::metrics::{Measure, Measures, Protocol, Report, ScoreError, evaluate, score};
use fit4cad::model::{Model, Primitive, Segmentation};
use fit4cad::surface::{Cylinder, Plane, Sphere, Surface, SurfaceType};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use proptest::prelude::*;

const POINTS: u32 = 40;

fn primitive(number: u32, points: Vec<u32>, surface: Surface) -> Primitive {
    Primitive::on(surface, number, points)
}

fn plane(height: f64) -> Surface {
    Surface::Plane(Plane::new(Point::new(0.0, 0.0, height), Vector::z()))
}

/// A row of points along x at height 0.
fn row(count: u32) -> Cloud {
    Cloud::new(
        (0..count)
            .map(|x| Point::new(f64::from(x), 0.0, 0.0))
            .collect(),
    )
}

fn close(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-9,
        (a, b) => a == b,
    }
}

fn same(a: &Measures, b: &Measures, but: &[Measure]) -> bool {
    let measures = Measure::ALL
        .into_iter()
        .filter(|measure| !but.contains(measure));
    measures
        .into_iter()
        .all(|measure| close(a.get(measure), b.get(measure)))
}

#[test]
fn a_small_case_scores_as_computed_by_hand() {
    // Ten points; truth {0..4}, {4..8}; prediction {0..6} one above, {8, 9} on the surface.
    let truth = Segmentation {
        primitives: vec![
            primitive(1, vec![0, 1, 2, 3], plane(0.0)),
            primitive(2, vec![4, 5, 6, 7], plane(0.0)),
        ],
    };
    let prediction = Segmentation {
        primitives: vec![
            primitive(1, vec![0, 1, 2, 3, 4, 5], plane(1.0)),
            primitive(
                2,
                vec![8, 9],
                Surface::Sphere(Sphere::new(Point::new(8.5, 0.0, 0.0), 0.5)),
            ),
        ],
    };
    let report = evaluate(&row(10), &truth, &prediction, Protocol::Definition);
    // Against the first: TP 4, FP 2, FN 0, TN 4. Against the second: TP 2, FP 4, FN 2, TN 2.
    let expected = [
        (Measure::Dsc, (8.0 / 10.0 + 4.0 / 10.0) / 2.0),
        (Measure::Ppv, (4.0 / 6.0 + 2.0 / 6.0) / 2.0),
        (Measure::Tpr, (1.0 + 0.5) / 2.0),
        (Measure::Tnr, (4.0 / 6.0 + 2.0 / 6.0) / 2.0),
        (Measure::Npv, (1.0 + 2.0 / 4.0) / 2.0),
        (Measure::Acc, (8.0 / 10.0 + 4.0 / 10.0) / 2.0),
        // Distance 1 over a diagonal of 5, and 0.
        (Measure::Mfe, 0.1),
        (Measure::DHaus, 0.1),
        // (0, 0, 1, 0) against (0, 0, 1, −1)/√2; the second prediction meets no true primitive.
        (Measure::D1, 1.0),
    ];
    for (measure, value) in expected {
        assert!(
            close(report.mean.get(measure), Some(value)),
            "{measure} {:?}",
            report.mean
        );
    }
    assert_eq!(report.hidden.merged, [0, 1]);
    assert_eq!(report.hidden.spurious, [1]);
    assert_eq!(report.hidden.missed, [0; 0]);
    assert_eq!(report.hidden.prediction_dsc, Some(0.4));
    assert_eq!(report.hidden.labelled, Some(0.8));
    assert_eq!(report.hidden.truth_labelled, Some(0.8));
    assert_eq!(report.type_errors, 0);

    // The first prediction is the match of both and meets the first most: d1 is the first's alone.
    let of_place = |place: usize| report.measures_of(place).unwrap();
    let found = [0, 1].map(|place| [of_place(place)[Measure::Mfe], of_place(place)[Measure::D1]]);
    assert!(close(found[0][0], Some(0.2)) && close(found[0][1], Some(1.0)));
    assert_eq!(found[1], [found[0][0], None]);
    assert_eq!(report.measures_of(2), None);

    // Published: points 8 and 9 do not exist, so TN is 2 and 0; headings swapped.
    let report = evaluate(&row(10), &truth, &prediction, Protocol::Published);
    assert!(close(report.mean[Measure::Ppv], Some(0.75)));
    assert!(close(report.mean[Measure::Tpr], Some(0.5)));
    assert!(close(report.mean[Measure::Tnr], Some((1.0 + 0.0) / 2.0)));
    assert!(close(
        report.mean[Measure::Npv],
        Some((2.0 / 4.0 + 0.0) / 2.0)
    ));
    assert!(close(report.mean[Measure::D1], Some(0.5)));
}

#[test]
fn predicting_nothing_does_not_pay() {
    let truth = Segmentation {
        primitives: vec![primitive(7, vec![0, 1], plane(0.0))],
    };
    let report = evaluate(
        &row(4),
        &truth,
        &Segmentation::default(),
        Protocol::Definition,
    );
    assert_eq!(report.primitives[0].classification[Measure::Ppv], None);
    assert_eq!(report.mean[Measure::Ppv], Some(0.0));
    assert_eq!(report.mean[Measure::Dsc], Some(0.0));
    assert_eq!(
        (report.mean[Measure::Mfe], report.mean[Measure::D1]),
        (None, None)
    );
    assert_eq!(report.hidden.missed, [0]);
    assert_eq!(report.hidden.prediction_dsc, None);
}

#[test]
fn a_wrong_type_has_no_coefficient_distance_and_is_counted() {
    let cylinder = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::x(), 1.0));
    let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
    let truth = Segmentation {
        primitives: vec![primitive(1, vec![0, 1, 2], cylinder)],
    };
    let prediction = Segmentation {
        primitives: vec![primitive(1, vec![0, 1, 2], sphere)],
    };
    let report = evaluate(&row(3), &truth, &prediction, Protocol::Definition);
    assert_eq!((report.type_errors, report.mean[Measure::D1]), (1, None));
    use fit4cad::metrics::hidden::MatchedType;
    let matched = MatchedType::Type(SurfaceType::Sphere);
    assert_eq!(
        report
            .hidden
            .types
            .count(Some(SurfaceType::Cylinder), matched),
        1
    );
    // The authors' script looks at the length alone, and both have ten.
    let published = evaluate(&row(3), &truth, &prediction, Protocol::Published);
    assert!(published.mean[Measure::D1].is_some());
}

#[test]
fn a_model_without_truth_or_submission_says_which_is_missing() {
    let mut model = Model {
        name: "PC1".to_owned(),
        ..Model::default()
    };
    let outcome = score(&model, "HT", Protocol::Definition);
    assert!(matches!(outcome, Err(ScoreError::NoTruth { .. })));
    model.truth = Some(Segmentation::default());
    let outcome = score(&model, "HT", Protocol::Definition);
    assert!(matches!(outcome, Err(ScoreError::NoSubmission { .. })));
}

#[test]
fn empty_segmentations_of_an_empty_cloud_have_no_measures() {
    let nothing = Segmentation::default();
    for protocol in Protocol::ALL {
        let report = evaluate(&Cloud::default(), &nothing, &nothing, protocol);
        assert_eq!(report.mean, Measures::default());
        assert_eq!(report.hidden.labelled, None);
    }
}

fn cloud() -> impl Strategy<Value = Vec<Point>> {
    let point = [-10.0..10.0, -10.0..10.0, -10.0..10.0f64].prop_map(Point::from);
    prop::collection::vec(point, POINTS as usize)
}

fn segmentation() -> impl Strategy<Value = Segmentation> {
    let points = prop::collection::btree_set(0..POINTS, 1..15);
    let surface = (0..3, -5.0..5.0, 1.0..5.0).prop_map(|(kind, at, radius)| {
        let (centre, axis) = (Point::new(at, 1.0, -at), Vector::new(1.0, at, 2.0));
        match kind {
            0 => Surface::Plane(Plane::new(centre, axis)),
            1 => Surface::Cylinder(Cylinder::new(centre, axis, radius)),
            _ => Surface::Sphere(Sphere::new(centre, radius)),
        }
    });
    prop::collection::vec((points, surface), 1..6).prop_map(|entries| Segmentation {
        primitives: (1..)
            .zip(entries)
            .map(|(number, (points, surface))| {
                primitive(number, points.into_iter().collect(), surface)
            })
            .collect(),
    })
}

/// The segmentation with its surfaces, and their vectors, replaced.
fn with_surfaces(
    segmentation: &Segmentation,
    change: impl Fn(&Surface) -> Surface,
) -> Segmentation {
    let primitives = segmentation.primitives.iter();
    Segmentation {
        primitives: primitives
            .map(|old| {
                primitive(
                    old.number,
                    old.points.clone(),
                    change(&old.surface.unwrap()),
                )
            })
            .collect(),
    }
}

/// Whether every best overlap is the only best one, so that order cannot matter.
fn is_untied(one: &Segmentation, other: &Segmentation) -> bool {
    one.primitives.iter().all(|primitive| {
        let mut shared: Vec<usize> = other
            .primitives
            .iter()
            .map(|other| {
                other
                    .points
                    .iter()
                    .filter(|p| primitive.points.contains(p))
                    .count()
            })
            .collect();
        shared.sort_unstable_by(|a, b| b.cmp(a));
        shared.len() < 2 || shared[0] > shared[1] || shared[0] == 0
    })
}

fn reports(cloud: &[Point], truth: &Segmentation, prediction: &Segmentation) -> [Report; 2] {
    let cloud = Cloud::new(cloud.to_vec());
    Protocol::ALL.map(|protocol| evaluate(&cloud, truth, prediction, protocol))
}

proptest! {
    #[test]
    fn measures_stay_in_their_ranges(
        cloud in cloud(), truth in segmentation(), prediction in segmentation(),
    ) {
        for report in reports(&cloud, &truth, &prediction) {
            let rows = report.primitives.iter().map(|row| row.classification[Measure::Dsc]);
            prop_assert!(rows.flatten().all(|dsc| (0.0..=1.0).contains(&dsc)));
            for measure in Measure::ALL {
                if let Some(value) = report.mean.get(measure) {
                    prop_assert!(value >= 0.0, "{measure} {value}");
                    let most = measure.info().most;
                    prop_assert!(most.is_none_or(|most| value <= most), "{measure} {value}");
                }
            }
            let (mfe, largest) = (report.mean[Measure::Mfe], report.mean[Measure::DHaus]);
            prop_assert!(close(mfe.zip(largest).map(|(mean, largest)| mean.min(largest)), mfe));
        }
    }

    #[test]
    fn a_perfect_prediction_scores_one_and_its_coefficients_zero(
        cloud in cloud(), truth in segmentation(),
    ) {
        // Two true primitives with the same points would be matched with the first of them.
        prop_assume!(is_untied(&truth, &truth));
        for report in reports(&cloud, &truth, &truth) {
            for measure in Measure::ALL {
                match measure {
                    Measure::Mfe | Measure::DHaus => {}
                    Measure::D1 => prop_assert_eq!(report.mean[Measure::D1], Some(0.0)),
                    Measure::Tnr | Measure::Npv if truth.primitives.len() == 1 => {}
                    _ => prop_assert_eq!(report.mean.get(measure), Some(1.0)),
                }
            }
            prop_assert_eq!(report.type_errors, 0);
            prop_assert!(report.hidden.missed.is_empty() && report.hidden.spurious.is_empty());
            prop_assert!(report.hidden.merged.is_empty());
        }
    }

    #[test]
    fn renumbering_the_points_changes_nothing(
        cloud in cloud(), truth in segmentation(), prediction in segmentation(),
        order in Just((0..POINTS).collect::<Vec<u32>>()).prop_shuffle(),
    ) {
        let mut shuffled = cloud.clone();
        for (point, &place) in cloud.iter().zip(&order) {
            shuffled[place as usize] = *point;
        }
        let renumbered = |segmentation: &Segmentation| {
            let mut segmentation = segmentation.clone();
            for primitive in &mut segmentation.primitives {
                for point in &mut primitive.points {
                    *point = order[*point as usize];
                }
                primitive.points.sort_unstable();
            }
            segmentation
        };
        let before = reports(&cloud, &truth, &prediction);
        let after = reports(&shuffled, &renumbered(&truth), &renumbered(&prediction));
        for (before, after) in before.iter().zip(&after) {
            prop_assert!(same(&before.mean, &after.mean, &[]));
            prop_assert_eq!(&before.hidden, &after.hidden);
        }
    }

    #[test]
    fn the_order_of_primitives_changes_no_mean_where_no_overlaps_are_equal(
        cloud in cloud(), truth in segmentation(), prediction in segmentation(),
    ) {
        prop_assume!(is_untied(&truth, &prediction) && is_untied(&prediction, &truth));
        let reversed = |segmentation: &Segmentation| Segmentation {
            primitives: segmentation.primitives.iter().rev().cloned().collect(),
        };
        let before = reports(&cloud, &truth, &prediction);
        let after = reports(&cloud, &reversed(&truth), &reversed(&prediction));
        for (before, after) in before.iter().zip(&after) {
            prop_assert!(same(&before.mean, &after.mean, &[]));
            prop_assert_eq!(before.type_errors, after.type_errors);
        }
    }

    #[test]
    fn scale_translation_and_quarter_turns_change_nothing_but_the_coefficients(
        cloud in cloud(), truth in segmentation(), prediction in segmentation(),
        shift in [-50.0..50.0, -50.0..50.0, -50.0..50.0f64], quarters in 0..4u8, factor in 0.1..10.0,
    ) {
        // The bounding box is axis-aligned, so only quarter turns keep its diagonal.
        let angle = f64::from(quarters) * std::f64::consts::FRAC_PI_2;
        let motion = Isometry3::from_parts(
            Translation3::from(Vector::from(shift)),
            UnitQuaternion::from_axis_angle(&Vector::y_axis(), angle),
        );
        let moved: Vec<Point> = cloud.iter().map(|point| (motion * point) * factor).collect();
        let change = |surface: &Surface| surface.moved(&motion).scaled(factor);
        let before = reports(&cloud, &truth, &prediction);
        let after = reports(
            &moved,
            &with_surfaces(&truth, change),
            &with_surfaces(&prediction, change),
        );
        for (before, after) in before.iter().zip(&after) {
            prop_assert!(same(&before.mean, &after.mean, &[Measure::D1]));
        }
    }
}
