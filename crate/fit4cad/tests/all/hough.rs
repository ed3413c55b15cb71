//! The Hough-transform fitter from cloud to segmentation.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::fit::hough::family::Rung;
use fit4cad::fit::trace::Event;
use fit4cad::fit::{Method, Observer, Parameters, fit};
use fit4cad::model::Segmentation;
use fit4cad::random::Random;
use fit4cad::surface::{Surface, SurfaceType};
use nalgebra::Rotation3;

const STEP: f64 = 0.04;

fn found(points: Vec<Point>) -> Segmentation {
    let fit = fit(
        &Cloud::new(points),
        Method::Hough,
        &Parameters::default(),
        1,
        &mut (),
    );
    fit.unwrap().segmentation
}

/// An oblique frame, so that nothing is parallel to an axis.
fn place(x: f64, y: f64, z: f64) -> Point {
    let turn = Rotation3::new(Vector::new(0.3, -0.5, 0.7));
    Point::new(1.0, -2.0, 0.5) + turn * Vector::new(x, y, z)
}

/// Points at (ρ, z) turned about the axis over `angle` radians, spaced evenly.
fn turned(profile: impl Iterator<Item = [f64; 2]>, angle: f64) -> Vec<Point> {
    let mut points = Vec::new();
    for [radius, height] in profile {
        let count = (radius * angle / STEP).ceil().max(1.0) as u32;
        for i in 0..=count {
            let (sin, cos) = (angle * f64::from(i) / f64::from(count)).sin_cos();
            points.push(place(radius * cos, radius * sin, height));
        }
    }
    points
}

fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let count = ((to - from) / STEP).round() as u32;
    (0..=count).map(move |i| from + (to - from) * f64::from(i) / f64::from(count))
}

/// The only surface found, and that it holds all points.
fn only(points: Vec<Point>) -> Surface {
    let count = points.len();
    let segmentation = found(points);
    assert_eq!(segmentation.primitives.len(), 1);
    assert_eq!(segmentation.primitives[0].points.len(), count);
    segmentation.primitives[0].surface.unwrap()
}

/// The bowl of a box with a hole: two planes and a cylinder, 1,800 points.
fn plate() -> Vec<Point> {
    let mut points = Vec::new();
    for x in steps(-1.0, 1.0) {
        for y in steps(-1.0, 1.0) {
            if x.hypot(y) > 0.5 + 0.3 * STEP {
                points.push(place(x, y, 0.0));
                points.push(place(x, y, 0.6));
            }
        }
    }
    points.extend(turned(steps(0.0, 0.6).map(|z| [0.5, z]), 6.2));
    points
}

#[test]
fn exact_points_of_a_plane_give_its_parameters() {
    let grid = steps(0.0, 1.0).flat_map(|x| steps(0.0, 1.0).map(move |y| place(x, y, 0.3)));
    let Surface::Plane(plane) = only(grid.collect()) else {
        unreachable!()
    };
    let normal = place(0.0, 0.0, 1.0) - place(0.0, 0.0, 0.0);
    assert!(plane.normal.cross(&normal).norm() < 1e-9);
    assert!((plane.normal.dot(&place(0.0, 0.0, 0.3).coords) - plane.offset).abs() < 1e-9);
}

#[test]
fn exact_points_of_thirty_degrees_of_a_cylinder_give_its_parameters() {
    let points = turned(steps(0.0, 1.0).map(|z| [1.5, z]), 30_f64.to_radians());
    let Surface::Cylinder(cylinder) = only(points) else {
        unreachable!()
    };
    assert!((cylinder.radius - 1.5).abs() < 1e-9);
    let axis = place(0.0, 0.0, 1.0) - place(0.0, 0.0, 0.0);
    assert!(cylinder.axis.cross(&axis).norm() < 1e-9);
}

#[test]
fn exact_points_of_part_of_a_cone_give_its_parameters() {
    let points = turned(steps(0.6, 1.6).map(|z| [0.5 * z, z]), 2.0);
    let Surface::Cone(cone) = only(points) else {
        unreachable!()
    };
    assert!((cone.half_angle.tan() - 0.5).abs() < 1e-9);
    assert!((cone.apex - place(0.0, 0.0, 0.0)).norm() < 1e-9);
}

#[test]
fn exact_points_of_part_of_a_sphere_give_its_parameters() {
    let points = turned(steps(-0.4, 0.6).map(|t| [t.cos(), t.sin()]), 2.0);
    let Surface::Sphere(sphere) = only(points) else {
        unreachable!()
    };
    assert!((sphere.radius - 1.0).abs() < 1e-9);
    assert!((sphere.centre - place(0.0, 0.0, 0.0)).norm() < 1e-9);
}

#[test]
fn exact_points_of_part_of_a_torus_give_its_parameters() {
    let points = turned(
        steps(-1.2, 1.2).map(|t| [1.0 + 0.4 * t.cos(), 0.4 * t.sin()]),
        3.0,
    );
    let Surface::Torus(torus) = only(points) else {
        unreachable!()
    };
    assert!((torus.major_radius - 1.0).abs() < 1e-9);
    assert!((torus.minor_radius - 0.4).abs() < 1e-9);
    assert!((torus.centre - place(0.0, 0.0, 0.0)).norm() < 1e-9);
}

#[test]
fn a_torus_that_cuts_its_own_axis_is_left_unsegmented() {
    let apple = turned(steps(0.0, 2.4).map(|t| [0.5 + t.cos(), t.sin()]), 3.0);
    assert_eq!(found(apple).primitives, []);
}

/// For every point the set of types of the primitives it belongs to.
fn labels(segmentation: &Segmentation, count: usize) -> Vec<Vec<SurfaceType>> {
    let mut labels = vec![Vec::new(); count];
    for primitive in &segmentation.primitives {
        for &index in &primitive.points {
            labels[index as usize].extend(primitive.kind);
        }
    }
    for of_point in &mut labels {
        of_point.sort_unstable();
    }
    labels
}

#[test]
fn motion_scale_and_order_change_hardly_a_label() {
    let points = plate();
    let before = labels(&found(points.clone()), points.len());
    assert_eq!(found(points.clone()).primitives.len(), 3);
    let turn = Rotation3::new(Vector::new(-1.1, 0.4, 0.9));
    let moved = points
        .iter()
        .map(|p| Point::from(turn * p.coords * 250.0 + Vector::repeat(40.0)));
    let after = labels(&found(moved.collect()), points.len());
    let changed = before.iter().zip(&after).filter(|(a, b)| a != b).count();
    assert!(200 * changed <= points.len(), "{changed} labels changed");

    let mut order: Vec<usize> = (0..points.len()).collect();
    Random::new(5, 0).shuffle(&mut order);
    let shuffled = order.iter().map(|&index| points[index]).collect();
    let after = labels(&found(shuffled), points.len());
    let changed = order
        .iter()
        .zip(&after)
        .filter(|&(&index, label)| &before[index] != label)
        .count();
    assert!(200 * changed <= points.len(), "{changed} labels changed");
}

#[test]
fn the_same_seed_gives_the_same_answer() {
    assert_eq!(found(plate()), found(plate()));
}

#[test]
fn clouds_too_small_or_broken_give_no_primitive() {
    assert!(found(Vec::new()).primitives.is_empty());
    assert!(found(vec![Point::origin(); 50]).primitives.is_empty());
    assert!(
        found(vec![Point::new(f64::NAN, 0.0, 0.0); 50])
            .primitives
            .is_empty()
    );
}

/// Keeps the trace.
#[derive(Default)]
struct Listener(Vec<Event>);

impl Observer for Listener {
    fn wants_trace(&self) -> bool {
        true
    }

    fn trace(&mut self, event: Event) {
        self.0.push(event);
    }
}

#[test]
fn the_trace_holds_the_accumulator_in_which_the_planes_stand_out() {
    let mut listener = Listener::default();
    let cloud = Cloud::new(plate());
    fit(
        &cloud,
        Method::Hough,
        &Parameters::default(),
        1,
        &mut listener,
    )
    .unwrap();
    let first = listener.0.iter().find_map(|event| match event {
        Event::Hough(snapshot) => Some(snapshot),
        _ => None,
    });
    let first = first.unwrap();
    assert_eq!(
        (first.kind, first.rung),
        (SurfaceType::Plane, Rung::Direction)
    );
    // Both planes have one direction: a single peak stands above the threshold.
    let high = first
        .pairs
        .iter()
        .filter(|[birth, death]| birth - death >= first.threshold);
    assert_eq!(high.count(), 1);
    let peak = first.cells[first.peaks[0] as usize];
    let normal = place(0.0, 0.0, 1.0) - place(0.0, 0.0, 0.0);
    assert!(Vector::from(peak.centre).dot(&normal).abs() > 0.999);
    let accepted = listener
        .0
        .iter()
        .filter(|event| matches!(event, Event::Accepted { .. }));
    assert_eq!(accepted.count(), 3);
}
