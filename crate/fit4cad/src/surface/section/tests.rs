use std::f64::consts::{FRAC_PI_4, FRAC_PI_6, TAU};

use super::*;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Torus};

fn grid(at: impl Fn(f64, f64) -> Point, s: (f64, f64), t: (f64, f64)) -> Vec<Point> {
    let step = |(low, high): (f64, f64), k: u32| low + (high - low) * f64::from(k) / 40.0;
    (0..41)
        .flat_map(|i| (0..41).map(move |j| (i, j)))
        .map(|(i, j)| at(step(s, i), step(t, j)))
        .collect()
}

fn length(chains: &[Vec<Point>]) -> f64 {
    let pieces = chains.iter().flat_map(|chain| chain.windows(2));
    pieces
        .map(|pair| nalgebra::distance(&pair[0], &pair[1]))
        .sum()
}

/// What is traced lies on both, and is as long as it should be.
fn check(surface: &Surface, points: &[Point], plane: &CuttingPlane, expected: f64) {
    let chains = trace(surface, points, plane);
    for place in chains.iter().flatten() {
        assert!(plane.height(place).abs() < 1e-9, "{place} is off the plane");
        assert!(surface.distance(place) < 1e-9, "{place} is off the surface");
    }
    let found = length(&chains);
    assert!(
        (found - expected).abs() < 2e-3 * expected,
        "length {found} for {expected}"
    );
}

#[test]
fn a_square_across_the_plane_is_met_in_a_line_as_long_as_its_points_reach() {
    let wall = Surface::Plane(Plane::new(Point::new(1.0, 0.0, 0.0), Vector::x()));
    let points = grid(|y, z| Point::new(1.0, y, z), (0.0, 3.0), (0.0, 2.0));
    let plane = CuttingPlane::across(2, 0.7);
    check(&wall, &points, &plane, 3.0);
    let chains = trace(&wall, &points, &plane);
    assert_eq!((chains.len(), chains[0].len()), (1, 2));
    assert_eq!(Meeting::of(&wall, &plane), Meeting::Line);
    assert!(trace(&wall, &points, &CuttingPlane::across(2, 2.5)).is_empty());
    let along = CuttingPlane::across(0, 1.0);
    assert_eq!(Meeting::of(&wall, &along), Meeting::Nothing);
}

#[test]
fn a_quarter_of_a_cylinder_is_met_in_a_quarter_of_a_circle() {
    let cylinder = Cylinder::new(Point::new(5.0, 0.0, 0.0), Vector::z(), 2.0);
    let surface = Surface::Cylinder(cylinder);
    let at = |z: f64, t: f64| Point::new(5.0 + 2.0 * t.cos(), 2.0 * t.sin(), z);
    let points = grid(at, (0.0, 1.0), (0.0, TAU / 4.0));
    let plane = CuttingPlane::across(2, 0.5);
    check(&surface, &points, &plane, TAU / 2.0);
    assert_eq!(Meeting::of(&surface, &plane), Meeting::Circle(2.0));
    let lengthwise = CuttingPlane::across(1, 0.5);
    check(&surface, &points, &lengthwise, 1.0);
    assert_eq!(Meeting::of(&surface, &lengthwise), Meeting::Lines);
}

#[test]
fn a_cylinder_met_at_a_slant_is_an_ellipse() {
    let axis = Vector::new(0.0, 1.0, 1.0);
    let surface = Surface::Cylinder(Cylinder::new(Point::origin(), axis, 1.0));
    let along = axis.normalize();
    let (u, v) = (Vector::x(), along.cross(&Vector::x()));
    let at = |s: f64, t: f64| Point::from(along * s + u * t.cos() + v * t.sin());
    let points = grid(at, (-3.0, 3.0), (0.0, TAU));
    let plane = CuttingPlane::across(2, 0.1);
    let Meeting::Ellipse(large, small) = Meeting::of(&surface, &plane) else {
        panic!("an ellipse");
    };
    assert!((large - 2.0_f64.sqrt()).abs() < 1e-12 && (small - 1.0).abs() < 1e-12);
    // Ramanujan's perimeter.
    let h = ((large - small) / (large + small)).powi(2);
    let perimeter = TAU / 2.0 * (large + small) * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()));
    check(&surface, &points, &plane, perimeter);
}

#[test]
fn spheres_and_tori_are_met_in_circles() {
    let sphere = Surface::Sphere(Sphere {
        centre: Point::origin(),
        radius: 5.0,
    });
    let at = |z: f64, t: f64| {
        let r = (25.0 - z * z).sqrt();
        Point::new(r * t.cos(), r * t.sin(), z)
    };
    let plane = CuttingPlane::across(2, 3.0);
    check(
        &sphere,
        &grid(at, (-5.0, 5.0), (0.0, TAU)),
        &plane,
        TAU * 4.0,
    );
    assert_eq!(Meeting::of(&sphere, &plane), Meeting::Circle(4.0));
    assert_eq!(
        Meeting::of(&sphere, &CuttingPlane::across(2, 6.0)),
        Meeting::Nothing
    );

    let torus = Surface::Torus(Torus::new(Point::origin(), Vector::z(), 4.0, 1.0));
    let at = |s: f64, t: f64| {
        let r = 4.0 + s.cos();
        Point::new(r * t.cos(), r * t.sin(), s.sin())
    };
    let points = grid(at, (0.0, TAU), (0.0, TAU));
    let level = CuttingPlane::across(2, 0.6);
    assert_eq!(Meeting::of(&torus, &level), Meeting::Circles(4.8, 3.2));
    check(&torus, &points, &level, TAU * 8.0);
    let through = CuttingPlane::across(0, 0.0);
    assert_eq!(Meeting::of(&torus, &through), Meeting::Circles(1.0, 1.0));
    check(&torus, &points, &through, TAU * 2.0);
    let beside = CuttingPlane::across(0, 1.0);
    assert_eq!(Meeting::of(&torus, &beside), Meeting::Quartic);
    assert!(!trace(&torus, &points, &beside).is_empty());
}

#[test]
fn a_cone_is_met_in_every_conic() {
    let cone = |axis: Vector| Surface::Cone(Cone::new(Point::origin(), axis, FRAC_PI_6));
    let plane = CuttingPlane::across(2, 2.0);
    let Meeting::Circle(radius) = Meeting::of(&cone(Vector::z()), &plane) else {
        panic!("a circle");
    };
    assert!((radius - 2.0 * FRAC_PI_6.tan()).abs() < 1e-12);
    let tilted = Vector::new(FRAC_PI_6.sin(), 0.0, FRAC_PI_6.cos());
    let Meeting::Ellipse(large, small) = Meeting::of(&cone(tilted), &plane) else {
        panic!("an ellipse");
    };
    // The flattest generator is at 60° to the normal, the steepest along it.
    assert!((large - 3.0_f64.sqrt()).abs() < 1e-9);
    assert!((small - large * (2.0_f64 / 3.0).sqrt()).abs() < 1e-9);
    let generator = Vector::new(3.0_f64.sqrt() / 2.0, 0.0, 0.5);
    assert_eq!(Meeting::of(&cone(generator), &plane), Meeting::Parabola);
    assert_eq!(Meeting::of(&cone(Vector::x()), &plane), Meeting::Hyperbola);
    let through = CuttingPlane::across(2, 0.0);
    assert_eq!(Meeting::of(&cone(Vector::x()), &through), Meeting::Lines);

    let surface = cone(Vector::z());
    let at = |z: f64, t: f64| {
        let r = z * FRAC_PI_6.tan();
        Point::new(r * t.cos(), r * t.sin(), z)
    };
    let points = grid(at, (1.0, 3.0), (0.0, TAU));
    check(&surface, &points, &plane, TAU * radius);
}

#[test]
fn points_near_the_plane_are_within_half_the_thickness() {
    let points = [0.0, 0.9, 1.0, 1.1, 2.0].map(|z| Point::new(0.0, 0.0, z));
    let plane = CuttingPlane::across(2, 1.0);
    assert_eq!(plane.near(&points, 0.21).collect::<Vec<_>>(), [1, 2, 3]);
    assert_eq!(plane.near(&points, 0.0).collect::<Vec<_>>(), [2]);
    assert_eq!(plane.near(&points, f64::NAN).count(), 0);
    assert_eq!(plane.flat(&Point::new(3.0, 4.0, 9.0)), [3.0, 4.0]);
}

#[test]
fn words_have_five_digits_and_no_zeros_to_spare() {
    assert_eq!(Meeting::Circle(0.5).to_string(), "circle of radius 0.5");
    assert_eq!(
        Meeting::Circle(1.0 / 3.0).to_string(),
        "circle of radius 0.33333"
    );
    assert_eq!(
        Meeting::Circles(2.0, 2.0).to_string(),
        "two circles of radius 2"
    );
    assert_eq!(
        Meeting::Circle(1.5e-9).to_string(),
        "circle of radius 1.5000e-9"
    );
}

#[test]
fn nonsense_is_no_curve() {
    let sphere = Surface::Sphere(Sphere {
        centre: Point::origin(),
        radius: 1.0,
    });
    let nowhere = CuttingPlane::across(9, f64::NAN);
    assert!(trace(&sphere, &[Point::new(1.0, 0.0, 0.0)], &nowhere).is_empty());
    assert!(trace(&sphere, &[], &CuttingPlane::across(0, 0.0)).is_empty());
    let narrow = Surface::Cone(Cone::new(Point::origin(), Vector::z(), FRAC_PI_4));
    assert_eq!(
        Meeting::of(&narrow, &CuttingPlane::across(2, 0.0)),
        Meeting::Nothing
    );
}
