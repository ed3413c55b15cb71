//! What the generated parts promise: exact truth, shared edges, even spacing, options that do what
//! they say.

#![allow(clippy::expect_used, reason = "helpers of tests")]

use std::collections::BTreeMap;

use fit4cad::cloud::Point;
use fit4cad::model::{Model, Primitive};
use fit4cad::sample::blocks::{Loop, Outline, Part, Solid};
use fit4cad::sample::{Options, SampleError, build, generate, opening, parts};
use fit4cad::surface::{Surface, SurfaceType};

/// Coarser than the default, to be quick.
const COARSE: Options = Options {
    seed: 1,
    spacing: 0.015,
    noise: 0.0,
    outliers: 0.0,
    missing: 0.0,
};

fn truth(model: &Model) -> &[Primitive] {
    &model
        .truth
        .as_ref()
        .expect("a generated model has a truth")
        .primitives
}

fn every_part(options: &Options) -> impl Iterator<Item = Model> {
    parts()
        .iter()
        .map(|part| generate(part.name, options).expect(part.name))
}

/// How many primitives list each point.
fn multiplicity(model: &Model) -> Vec<usize> {
    let mut counts = vec![0; model.cloud.len()];
    for &index in truth(model).iter().flat_map(|primitive| &primitive.points) {
        counts[index as usize] += 1;
    }
    counts
}

fn kinds(model: &Model) -> BTreeMap<SurfaceType, usize> {
    let mut counts = BTreeMap::new();
    for primitive in truth(model) {
        *counts.entry(primitive.kind.expect("a type")).or_default() += 1;
    }
    counts
}

/// The distance of each point to its nearest neighbour, ascending.
fn nearest(points: &[Point]) -> Vec<f64> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut distances: Vec<f64> = (0..sorted.len())
        .map(|k| {
            let mut best = f64::INFINITY;
            let mut look = |j: usize| {
                best = best.min((sorted[k] - sorted[j]).norm());
                (sorted[k].x - sorted[j].x).abs() < best
            };
            let _ = (0..k).rev().take_while(|&j| look(j)).count();
            let _ = (k + 1..sorted.len()).take_while(|&j| look(j)).count();
            best
        })
        .collect();
    distances.sort_by(f64::total_cmp);
    distances
}

#[test]
fn every_listed_point_lies_on_its_surface() {
    for model in every_part(&COARSE) {
        let diagonal = model.cloud.bounds().diagonal();
        for primitive in truth(&model) {
            let surface = primitive.surface.expect("a surface");
            for &index in &primitive.points {
                let distance = surface.distance(&model.cloud.points()[index as usize]);
                assert!(
                    distance <= 1e-12 * diagonal,
                    "{} {}: {distance}",
                    model.name,
                    primitive.number
                );
            }
        }
    }
}

#[test]
fn lists_are_ascending_numbered_and_within_the_cloud() {
    for model in every_part(&COARSE) {
        for (position, primitive) in truth(&model).iter().enumerate() {
            assert_eq!(primitive.number as usize, position + 1);
            assert!(primitive.points.windows(2).all(|pair| pair[0] < pair[1]));
            assert!(
                primitive
                    .points
                    .last()
                    .is_some_and(|&i| (i as usize) < model.cloud.len())
            );
        }
    }
}

#[test]
fn both_vectors_give_the_surface_back() {
    for model in every_part(&COARSE) {
        let diagonal = model.cloud.bounds().diagonal();
        for primitive in truth(&model) {
            let kind = primitive.kind.expect("a type");
            let parametric = primitive.parametric.values().expect("a vector");
            let implicit = primitive.implicit.values().expect("a vector");
            for form in [
                Surface::from_parametric(kind, parametric),
                Surface::from_implicit(kind, implicit),
            ] {
                let surface = form.expect("a member of its family").surface;
                for &index in &primitive.points {
                    let distance = surface.distance(&model.cloud.points()[index as usize]);
                    assert!(distance < 1e-6 * diagonal, "{}: {distance}", model.name);
                }
            }
        }
    }
}

#[test]
fn points_lie_apart_at_about_the_spacing() {
    for model in every_part(&Options::default()) {
        let diagonal = model.cloud.bounds().diagonal();
        let distances = nearest(model.cloud.points());
        let median = distances[distances.len() / 2] / diagonal;
        assert!(
            (median / 0.0077 - 1.0).abs() < 0.06,
            "{}: {median}",
            model.name
        );
        // As in the benchmark: 98 of 100 points between three quarters and four thirds.
        let quantile = |share: usize| distances[distances.len() * share / 100] / diagonal / median;
        assert!(quantile(1) > 0.6, "{}: {}", model.name, quantile(1));
        assert!(quantile(99) < 1.4, "{}: {}", model.name, quantile(99));
        // No point comes twice.
        assert!(
            distances[0] > 1e-5 * diagonal,
            "{}: {}",
            model.name,
            distances[0]
        );
    }
}

#[test]
fn a_cuboid_has_six_faces_twelve_edges_and_eight_corners() {
    let part = Part::new().join(Solid::cuboid([0.0; 3], [3.0, 2.0, 1.0]));
    let model = build("cuboid", &part, &COARSE).expect("a cuboid");
    assert_eq!(kinds(&model), BTreeMap::from([(SurfaceType::Plane, 6)]));
    let counts = multiplicity(&model);
    let spacing = 0.015 * 14f64.sqrt() * 1.24;
    let along = |length: f64| (length / spacing).round() as usize - 1;
    let inner = 4 * (along(3.0) + along(2.0) + along(1.0));
    assert_eq!(counts.iter().filter(|&&count| count == 3).count(), 8);
    assert_eq!(counts.iter().filter(|&&count| count == 2).count(), inner);
    for (point, count) in model.cloud.points().iter().zip(&counts) {
        let faces = [(point.x, 3.0), (point.y, 2.0), (point.z, 1.0)];
        let on = faces
            .iter()
            .filter(|(x, end)| *x == 0.0 || x == end)
            .count();
        assert_eq!(on, *count, "{point}");
    }
}

#[test]
fn two_crossing_bars_share_the_curves_in_which_they_meet() {
    let along_x = Solid::rod([-4.0, 0.0, 0.0], 1.0, 8.0);
    let part = Part::new()
        .join(Solid::rod([0.0, 0.0, -4.0], 1.5, 8.0))
        .join(along_x.facing([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    let model = build("cross", &part, &COARSE).expect("a cross");
    // The thinner bar is left as two stubs: two patches of one surface.
    let expected = BTreeMap::from([(SurfaceType::Plane, 4), (SurfaceType::Cylinder, 3)]);
    assert_eq!(kinds(&model), expected);
    let counts = multiplicity(&model);
    let meets =
        |p: &Point| (p.x.hypot(p.y) - 1.5).abs() < 1e-12 && (p.y.hypot(p.z) - 1.0).abs() < 1e-12;
    let shared: Vec<bool> = model.cloud.points().iter().map(meets).collect();
    assert!(shared.iter().filter(|&&on| on).count() > 50);
    assert!(
        shared
            .iter()
            .zip(&counts)
            .all(|(&on, &count)| !on || count == 2)
    );
    // Nothing is left of either bar inside the other.
    for point in model.cloud.points() {
        let inside = |radius: f64, across: f64, along: f64| {
            across < radius - 1e-9 && along.abs() < 4.0 - 1e-9
        };
        assert!(!inside(1.5, point.x.hypot(point.y), point.z));
        assert!(!inside(1.0, point.y.hypot(point.z), point.x));
    }
}

#[test]
fn flush_solids_make_one_face() {
    let part = Part::new()
        .join(Solid::cuboid([0.0; 3], [2.0, 1.0, 1.0]))
        .join(Solid::cuboid([1.0, 0.0, 0.0], [3.0, 1.0, 1.0]));
    let model = build("flush", &part, &COARSE).expect("a bar");
    assert_eq!(truth(&model).len(), 6);
}

#[test]
fn coplanar_tops_that_do_not_touch_are_two_primitives() {
    let model = generate("towers", &COARSE).expect("towers");
    let tops = truth(&model)
        .iter()
        .filter(|primitive| match primitive.surface {
            Some(Surface::Plane(plane)) => plane.normal.z == 1.0 && plane.offset == 50.0,
            _ => false,
        });
    assert_eq!(tops.count(), 2);
}

#[test]
fn primitives_are_as_many_and_of_the_types_that_the_part_has() {
    use SurfaceType::{Cone, Cylinder, Plane, Sphere, Torus};
    let expected: [(&str, &[(SurfaceType, usize)]); 4] = [
        (
            "flange",
            &[(Plane, 3), (Cylinder, 9), (Cone, 1), (Torus, 2)],
        ),
        ("towers", &[(Plane, 16), (Cylinder, 1)]),
        ("shaft", &[(Plane, 8), (Cylinder, 6), (Cone, 2)]),
        ("elbow", &[(Plane, 4), (Cylinder, 14), (Torus, 2)]),
    ];
    for (name, counts) in expected {
        let model = generate(name, &COARSE).expect(name);
        assert_eq!(kinds(&model), counts.iter().copied().collect(), "{name}");
    }
    let all: Vec<_> = every_part(&COARSE).collect();
    for kind in [Cone, Sphere, Torus] {
        assert!(
            all.iter().any(|model| kinds(model).contains_key(&kind)),
            "{kind}"
        );
    }
    assert!(all.iter().any(|model| truth(model).len() > 80));
}

#[test]
fn a_free_form_region_belongs_to_no_primitive() {
    let model = generate("knob", &COARSE).expect("knob");
    let counts = multiplicity(&model);
    let free = counts.iter().filter(|&&count| count == 0).count();
    assert!(
        free * 3 > model.cloud.len(),
        "{free} of {}",
        model.cloud.len()
    );
    for model in every_part(&COARSE).filter(|model| model.name != "knob") {
        assert!(
            multiplicity(&model).iter().all(|&count| count > 0),
            "{}",
            model.name
        );
    }
}

#[test]
fn one_seed_gives_one_model() {
    let options = Options {
        noise: 0.001,
        outliers: 0.1,
        missing: 0.1,
        ..COARSE
    };
    let make = |seed| generate("bracket", &Options { seed, ..options }).expect("bracket");
    assert_eq!(make(3), make(3));
    assert_ne!(make(3).cloud, make(4).cloud);
}

#[test]
fn noise_has_the_deviation_asked_for() {
    let clean = generate("flange", &COARSE).expect("flange");
    let noise = 0.002;
    let noisy = generate("flange", &Options { noise, ..COARSE }).expect("flange");
    let pairs = clean.cloud.points().iter().zip(noisy.cloud.points());
    let square: f64 = pairs.map(|(a, b)| (a - b).norm_squared()).sum();
    let deviation = (square / (3.0 * clean.cloud.len() as f64)).sqrt();
    let asked = noise * clean.cloud.bounds().diagonal();
    assert!(
        (deviation / asked - 1.0).abs() < 0.03,
        "{deviation} for {asked}"
    );
    assert_eq!(clean.truth, noisy.truth);
}

#[test]
fn outliers_follow_the_points_and_belong_to_nothing() {
    let clean = generate("flange", &COARSE).expect("flange");
    let outliers = 0.25;
    let model = generate("flange", &Options { outliers, ..COARSE }).expect("flange");
    let count = clean.cloud.len();
    assert_eq!(
        model.cloud.len(),
        count + (count as f64 * outliers).round() as usize
    );
    assert_eq!(&model.cloud.points()[..count], clean.cloud.points());
    assert_eq!(clean.truth, model.truth);
}

#[test]
fn missing_data_is_the_share_asked_for_and_the_rest_keeps_its_truth() {
    let clean = generate("housing", &COARSE).expect("housing");
    let missing = 0.3;
    let model = generate("housing", &Options { missing, ..COARSE }).expect("housing");
    let left = clean.cloud.len() - (clean.cloud.len() as f64 * missing).round() as usize;
    assert_eq!(model.cloud.len(), left);
    assert!(multiplicity(&model).iter().all(|&count| count > 0));
    let diagonal = clean.cloud.bounds().diagonal();
    for primitive in truth(&model) {
        let surface = primitive.surface.expect("a surface");
        let points = primitive
            .points
            .iter()
            .map(|&i| &model.cloud.points()[i as usize]);
        assert!(
            points
                .map(|p| surface.distance(p))
                .all(|d| d < 1e-12 * diagonal)
        );
    }
}

#[test]
fn bad_requests_say_what_would_be_right() {
    let unknown = generate("teapot", &COARSE)
        .expect_err("no teapot")
        .to_string();
    assert!(
        unknown.contains("teapot") && unknown.contains("flange"),
        "{unknown}"
    );
    for (option, options) in [
        (
            "spacing",
            Options {
                spacing: 0.0,
                ..COARSE
            },
        ),
        (
            "spacing",
            Options {
                spacing: f64::NAN,
                ..COARSE
            },
        ),
        (
            "noise",
            Options {
                noise: -0.1,
                ..COARSE
            },
        ),
        (
            "outliers",
            Options {
                outliers: 2.0,
                ..COARSE
            },
        ),
        (
            "missing",
            Options {
                missing: 1.0,
                ..COARSE
            },
        ),
    ] {
        match generate("flange", &options) {
            Err(SampleError::OutOfRange { option: named, .. }) => assert_eq!(named, option),
            other => panic!("{option}: {other:?}"),
        }
    }
}

#[test]
fn descriptions_that_make_no_solid_are_refused() {
    let across = Outline::rectangle([-1.0, 0.0], [1.0, 1.0]);
    let nan = Outline::new(Loop::polygon(&[[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]]));
    for solid in [
        Solid::revolve(across),
        Solid::extrude(nan, 1.0),
        Solid::extrude(Outline::default(), 1.0),
        Solid::extrude(Outline::disc([0.0; 2], 1.0), -1.0),
        Solid::rod([0.0; 3], 1.0, 1.0).facing([0.0; 3], [1.0, 0.0, 0.0]),
    ] {
        let refused = build("bad", &Part::new().join(solid), &COARSE);
        assert!(matches!(
            refused,
            Err(SampleError::InvalidPart { feature: 1, .. })
        ));
    }
    assert!(build("nothing", &Part::new(), &COARSE).is_err());
}

#[test]
fn the_primitives_do_not_depend_on_the_spacing() {
    for (coarse, fine) in every_part(&COARSE).zip(every_part(&Options::default())) {
        assert_eq!(kinds(&coarse), kinds(&fine), "{}", coarse.name);
    }
}

#[test]
fn what_the_page_opens_with_is_the_first_part_of_the_catalogue() {
    let first = generate(parts()[0].name, &Options::default());
    assert_eq!(opening(), first);
}
