//! How points are spread.

use crate::made::{Made, import};
use fit4cad::cloud::Point;
use fit4cad::cloud::neighbours::KdTree;
use fit4cad_step::{Amount, Document, Options, Spread};

const Z: [f64; 3] = [0.0, 0.0, 1.0];
const X: [f64; 3] = [1.0, 0.0, 0.0];

/// A can: a cylinder in two halves between a disc below and, of the disc above, a strip as thin as a hair.
fn can() -> String {
    let mut made = Made::new();
    let frame = made.frame([0.0; 3], Z, Some(X));
    let cylinder = made.add(&format!("CYLINDRICAL_SURFACE('',#{frame},10.)"));
    let corner = |z: f64, side: f64| [10.0 * side, 0.0, z];
    let vertices = [
        corner(0.0, 1.0),
        corner(0.0, -1.0),
        corner(20.0, 1.0),
        corner(20.0, -1.0),
    ]
    .map(|at| made.vertex(at));
    let circles = [0.0, 20.0].map(|z| made.circle([0.0, 0.0, z], Z, X, 10.0));
    let arcs: Vec<usize> = [(0, 1, 0), (1, 0, 0), (2, 3, 1), (3, 2, 1)]
        .iter()
        .map(|&(from, to, circle)| made.edge(vertices[from], vertices[to], circles[circle], true))
        .collect();
    let lines = [1.0, -1.0].map(|side| made.line(corner(0.0, side), corner(20.0, side)));
    let right = made.edge(vertices[0], vertices[2], lines[0], true);
    let left = made.edge(vertices[1], vertices[3], lines[1], true);
    let mut faces = Vec::new();
    for ring in [
        [
            (arcs[0], true),
            (left, true),
            (arcs[2], false),
            (right, false),
        ],
        [
            (arcs[1], true),
            (right, true),
            (arcs[3], false),
            (left, false),
        ],
    ] {
        let ring = made.ring(&ring);
        let bound = made.bound(ring, true);
        faces.push(made.face(&[bound], cylinder, true));
    }
    let plane = made.add(&format!("PLANE('',#{frame})"));
    let ring = made.ring(&[(arcs[0], true), (arcs[1], true)]);
    let bound = made.bound(ring, true);
    faces.push(made.face(&[bound], plane, true));
    let top = made.frame([0.0, 0.0, 20.0], Z, Some(X));
    let top = made.add(&format!("PLANE('',#{top})"));
    let strip = [
        [-5.0, 0.0, 20.0],
        [5.0, 0.0, 20.0],
        [5.0, 0.02, 20.0],
        [-5.0, 0.02, 20.0],
    ];
    faces.push(made.polygon(top, &[&strip], true));
    made.shell(&faces);
    made.text()
}

fn nearest(points: &[Point]) -> Vec<f64> {
    let tree = KdTree::new(points);
    let mut found = Vec::new();
    let mut distances: Vec<f64> = (0_u32..)
        .zip(points)
        .map(|(index, point)| {
            tree.nearest(point, 1, f64::INFINITY, |other| other != index, &mut found);
            found[0].distance_squared.sqrt()
        })
        .collect();
    distances.sort_by(f64::total_cmp);
    distances
}

#[test]
fn even_points_are_as_many_as_asked_for_and_all_about_one_distance_apart() {
    let options = Options {
        amount: Amount::Points(3000),
        least: 0,
        ..Options::default()
    };
    let found = import(can().as_bytes(), &options);
    assert_eq!(found.model.cloud.len(), 3000);
    let distances = nearest(found.model.cloud.points());
    // But for a handful on the strip, which stand by themselves.
    let (least, median, most) = (distances[0], distances[1500], distances[2970]);
    assert!(
        least > 0.7 * median && most < 1.4 * median,
        "{least} {median} {most}"
    );
    assert!(
        (median / found.report.spacing - 1.0).abs() < 0.1,
        "{median} {}",
        found.report.spacing
    );
}

#[test]
fn a_spacing_is_about_the_median_distance() {
    let options = Options {
        amount: Amount::Spacing(0.8),
        ..Options::default()
    };
    let found = import(can().as_bytes(), &options);
    let distances = nearest(found.model.cloud.points());
    let median = distances[distances.len() / 2];
    assert!((median / 0.8 - 1.0).abs() < 0.1, "{median}");
}

/// Chi-squared over rings of equal height and sectors: every place of a cylinder is as likely.
#[test]
fn random_points_fall_evenly_on_equal_areas() {
    let options = Options {
        amount: Amount::Points(20_000),
        spread: Spread::Random,
        least: 0,
        ..Options::default()
    };
    let found = import(can().as_bytes(), &options);
    let mut counts = [0.0; 64];
    let mut total = 0.0;
    for point in found
        .model
        .cloud
        .points()
        .iter()
        .filter(|p| p.z > 0.0 && p.z < 20.0)
    {
        let angle = (point.y.atan2(point.x) / std::f64::consts::TAU + 1.0).fract();
        let cell = (angle * 8.0) as usize * 8 + (point.z / 2.5) as usize;
        counts[cell.min(63)] += 1.0;
        total += 1.0;
    }
    let expected: f64 = total / 64.0;
    let chi: f64 = counts
        .iter()
        .map(|count: &f64| (count - expected).powi(2) / expected)
        .sum();
    // 63 degrees of freedom: one in ten thousand is beyond.
    assert!(chi < 112.0, "{chi}");
}

#[test]
fn thin_faces_have_their_least_number_and_a_warning_says_so() {
    let found = import(can().as_bytes(), &Options::default());
    assert_eq!(found.report.faces[3].points, 5);
    assert!(
        found.report.warnings[0].starts_with("1 of 4 faces"),
        "{:?}",
        found.report.warnings
    );
}

#[test]
fn faces_of_one_surface_that_touch_are_one_primitive_or_several() {
    let joined = import(can().as_bytes(), &Options::default());
    assert_eq!(joined.model.truth.unwrap().primitives.len(), 3);
    assert_eq!(
        joined.report.faces[0].primitive,
        joined.report.faces[1].primitive
    );
    let options = Options {
        join: false,
        ..Options::default()
    };
    let apart = import(can().as_bytes(), &options);
    assert_eq!(apart.model.truth.unwrap().primitives.len(), 4);
}

#[test]
fn a_seed_gives_the_same_points_again_and_another_gives_others() {
    let document = Document::read(can().as_bytes(), &mut |_| {}).unwrap();
    let sample = |seed| {
        let options = Options {
            seed,
            amount: Amount::Points(500),
            ..Options::default()
        };
        document.sample("x", &options, &mut |_| {}).unwrap().model
    };
    assert_eq!(sample(3), sample(3));
    assert_ne!(sample(3), sample(4));
}
