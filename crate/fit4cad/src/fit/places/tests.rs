use std::collections::BTreeSet;

use super::*;
use crate::cloud::Vector;
use crate::fit::{Fit, Method, Observer, Parameters, fit, trace::Event};
use crate::metrics::{Measure, Protocol, evaluate};
use crate::random::Random;
use crate::sample;

const METHODS: [Method; 2] = [Method::Hough, Method::Growing];

fn bracket() -> Cloud {
    let options = sample::Options {
        spacing: 0.012,
        ..sample::Options::default()
    };
    sample::generate("bracket", &options).unwrap().cloud
}

fn fitted(cloud: &Cloud, method: Method) -> Fit {
    fit(cloud, method, &Parameters::default(), 1, &mut ()).unwrap()
}

/// Each point so many times in a row, the copies where `copy` puts them.
fn repeated(cloud: &Cloud, times: u32, copy: impl Fn(&Point, u32) -> Point) -> Cloud {
    let points = cloud.points().iter();
    let copies = points.flat_map(|point| (0..times).map(|i| copy(point, i)).collect::<Vec<_>>());
    Cloud::new(copies.collect())
}

#[test]
fn a_cloud_whose_points_are_listed_many_times_is_fitted_as_if_each_were_listed_once() {
    let cloud = bracket();
    for (times, method) in [(5, METHODS[0]), (5, METHODS[1]), (100, METHODS[0])] {
        let once = fitted(&cloud, method).segmentation.primitives;
        let many = fitted(&repeated(&cloud, times, |point, _| *point), method);
        let expected: Vec<Vec<u32>> = once
            .iter()
            .map(|primitive| {
                let copies = |&index: &u32| times * index..times * (index + 1);
                primitive.points.iter().flat_map(copies).collect()
            })
            .collect();
        let primitives = many.segmentation.primitives.into_iter();
        let found: Vec<Vec<u32>> = primitives.map(|primitive| primitive.points).collect();
        assert!(
            once.len() > 15 && found == expected,
            "{times} times, {method:?}"
        );
    }
}

/// Clean and noisy clouds, and one that lists its points twice, a little apart.
#[test]
fn points_listed_in_another_order_are_fitted_to_the_same_digits() {
    let mut random = Random::new(1, 0);
    let elbow = sample::generate("elbow", &sample::Options::default()).unwrap();
    let bracket = bracket();
    let noise = 1e-3 * bracket.bounds().diagonal();
    let noisy = bracket.points().iter().map(|point| {
        let off = [(); 3].map(|()| noise * random.normal());
        point + Vector::from(off)
    });
    let clouds = [
        elbow.cloud,
        Cloud::new(noisy.collect()),
        repeated(&bracket, 2, |point, i| {
            point + Vector::repeat(1e-6 * f64::from(i))
        }),
    ];
    for cloud in clouds {
        let mut order: Vec<u32> = (0u32..).take(cloud.len()).collect();
        random.shuffle(&mut order);
        let shuffled = order.iter().map(|&index| cloud.points()[index as usize]);
        let shuffled = Cloud::new(shuffled.collect());
        for method in METHODS {
            let listed = fitted(&cloud, method);
            let mut other = fitted(&shuffled, method);
            for primitive in &mut other.segmentation.primitives {
                for index in &mut primitive.points {
                    *index = order[*index as usize];
                }
                primitive.points.sort_unstable();
            }
            assert!(listed.segmentation.primitives.len() > 3);
            assert_eq!(other, listed, "{method:?}");
        }
    }
}

#[test]
fn rows_repeated_beside_each_other_do_not_hide_the_faces() {
    let cloud = bracket();
    let spacing = fitted(&cloud, Method::Growing).scale.spacing;
    for method in METHODS {
        let once = fitted(&cloud, method).segmentation.primitives.len();
        for gap in [1e-2, 1e-3, 1e-4, 1e-6] {
            // Of the faces across y the copies are a little off them.
            let shift = |point: &Point, i: u32| {
                let step = gap * spacing * f64::from(i);
                Point::new(point.x, point.y + step, point.z)
            };
            let twice = fitted(&repeated(&cloud, 2, shift), method);
            let found = twice.segmentation.primitives.len();
            assert!(
                found.abs_diff(once) <= 3,
                "{method:?}, {gap}: {found}, not {once}"
            );
        }
    }
}

#[test]
fn the_two_sides_of_a_foil_are_no_copies() {
    let sheet = |z: f64| (0..900).map(move |i| Point::new(f64::from(i % 30), f64::from(i / 30), z));
    let foil = Cloud::new(sheet(0.0).chain(sheet(0.02)).collect());
    assert_eq!(Places::of(&foil, usize::MAX).0.cloud().len(), foil.len());
    let beside = sheet(0.0).map(|p| Point::new(p.x + 0.02, p.y, p.z));
    let twice = Cloud::new(sheet(0.0).chain(beside).collect());
    assert_eq!(Places::of(&twice, usize::MAX).0.cloud().len(), 900);
}

#[test]
fn even_and_random_points_are_all_kept() {
    assert_eq!(
        Places::of(&bracket(), usize::MAX).0.cloud().len(),
        bracket().len()
    );
    let mut random = Random::new(1, 0);
    let points = (0..2000).map(|_| Point::new(random.unit(), random.unit(), 0.0));
    let cloud = Cloud::new(points.collect());
    assert_eq!(Places::of(&cloud, usize::MAX).0.cloud().len(), cloud.len());
}

#[test]
fn points_that_are_not_finite_have_no_label_and_disturb_no_other() {
    let cloud = bracket();
    let mut points = cloud.points().to_vec();
    points.push(Point::new(f64::NAN, 0.0, 0.0));
    points.push(Point::new(0.0, f64::INFINITY, 0.0));
    for method in METHODS {
        let without = fitted(&cloud, method).segmentation;
        let with = fitted(&Cloud::new(points.clone()), method).segmentation;
        assert_eq!(with, without);
    }
}

#[test]
fn a_cloud_of_one_place_or_none_is_nothing_to_fit() {
    let one = Cloud::new(vec![Point::new(1.0, 2.0, 3.0); 30_000]);
    let nowhere = Cloud::new(vec![Point::new(f64::NAN, 0.0, 0.0); 30]);
    assert_eq!(Places::of(&one, usize::MAX).0.cloud().len(), 1);
    assert_eq!(Places::of(&nowhere, usize::MAX).0.cloud().len(), 0);
    for method in METHODS {
        for cloud in [&one, &nowhere, &Cloud::default()] {
            assert!(fitted(cloud, method).segmentation.primitives.is_empty());
        }
    }
}

#[test]
fn the_trace_speaks_of_the_points_of_the_whole_cloud() {
    struct Keeper(Vec<Event>);
    impl Observer for Keeper {
        fn wants_trace(&self) -> bool {
            true
        }

        fn trace(&mut self, event: Event) {
            self.0.push(event);
        }
    }
    let cloud = repeated(&bracket(), 2, |point, _| *point);
    let mut keeper = Keeper(Vec::new());
    let parameters = Parameters::default();
    fit(&cloud, Method::Growing, &parameters, 1, &mut keeper).unwrap();
    let mut accepted = 0;
    for event in keeper.0 {
        match event {
            Event::SurfaceVariation { values, .. } => assert_eq!(values.len(), cloud.len()),
            Event::Regions(regions) => assert_eq!(regions.len(), cloud.len()),
            Event::Accepted { surface, support } => {
                accepted += 1;
                for pair in support.chunks(2) {
                    assert_eq!(pair[0] + 1, pair[1]);
                    assert!(surface.distance(&cloud.points()[pair[0] as usize]) < 1e-2);
                }
            }
            _ => {}
        }
    }
    assert!(accepted > 10);
}

#[test]
fn of_a_large_cloud_so_many_points_are_fitted_and_all_are_labelled() {
    let options = sample::Options {
        spacing: 0.005,
        ..sample::Options::default()
    };
    let model = sample::generate("flange", &options).unwrap();
    let truth = model.truth.unwrap();
    let parameters = Parameters {
        subsample: (model.cloud.len() / 5) as f64,
        ..Parameters::default()
    };
    for method in METHODS {
        let found = fit(&model.cloud, method, &parameters, 1, &mut ()).unwrap();
        assert_eq!(found.thinned, Some(model.cloud.len() / 5));
        assert_eq!(
            found.title(method),
            format!("{} on {} points", method.title(), model.cloud.len() / 5)
        );
        let report = evaluate(
            &model.cloud,
            &truth,
            &found.segmentation,
            Protocol::Definition,
        );
        let dsc = report.mean[Measure::Dsc].unwrap();
        assert!(dsc > 0.97, "{method:?}: {dsc}");
        let labelled: BTreeSet<u32> = found
            .segmentation
            .primitives
            .iter()
            .flat_map(|primitive| primitive.points.iter().copied())
            .collect();
        assert!(labelled.len() as f64 > 0.99 * model.cloud.len() as f64);
    }
    // A cloud that has no more is fitted whole, and its answer says nothing else.
    let small = bracket();
    let parameters = Parameters {
        subsample: small.len() as f64,
        ..Parameters::default()
    };
    let found = fit(&small, Method::Hough, &parameters, 1, &mut ()).unwrap();
    assert_eq!(found, fitted(&small, Method::Hough));
    assert_eq!(found.title(Method::Hough), "HT");
}
