//! Distance, foot point and normal are exact, also on axes, in centres and inside spindle tori.

use std::f64::consts::FRAC_PI_4;

use fit4cad::cloud::{Point, Vector};
use fit4cad::surface::{
    Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, sample_parametric,
};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use proptest::prelude::*;

const AT: Point = Point::new(1.0, 2.0, 3.0);

#[test]
fn a_surface_of_numbers_that_are_none_is_out_of_range() {
    let z = Vector::z();
    for value in [f64::NAN, f64::INFINITY, 1e31] {
        for place in 0..3 {
            let mut at = AT;
            at[place] = value;
            for surface in [
                Surface::Plane(Plane::new(at, Vector::new(1.0, 2.0, 3.0))),
                Surface::Cylinder(Cylinder::new(at, Vector::new(1.0, 2.0, 3.0), 2.0)),
                Surface::Cone(Cone::new(at, z, 0.5)),
                Surface::Sphere(Sphere::new(at, 2.0)),
                Surface::Torus(Torus::new(at, z, 5.0, 1.0)),
            ] {
                assert!(!surface.is_in_range(), "{surface:?}");
            }
        }
        assert!(!Surface::Sphere(Sphere::new(AT, value)).is_in_range());
    }
}

#[test]
fn only_finite_points_are_spread_over_a_vector() {
    for size in [1.0, 1e100, 1e160, 1e300, f64::MAX] {
        let vector = [
            size, 0.0, 0.0, 0.0, size, 0.0, 0.0, 0.0, size, 0.0, 0.0, 0.0,
        ];
        for kind in [SurfaceType::Sphere, SurfaceType::Cylinder] {
            let points = sample_parametric(kind, &vector);
            assert!(
                points
                    .iter()
                    .flat_map(|point| point.iter())
                    .all(|x| x.is_finite())
            );
            assert_eq!(points.is_empty(), size > 1e30, "{kind} of {size}");
        }
    }
}

#[test]
fn known_points_have_known_distances() {
    let z = Vector::z();
    let cases = [
        // Signed distance along the normal.
        (Surface::Plane(Plane::new(AT, z)), [7.0, -5.0, 1.0], -2.0),
        // 3-4-5 triangles about the axis and the centre.
        (
            Surface::Cylinder(Cylinder::new(AT, z, 2.0)),
            [4.0, 6.0, 99.0],
            3.0,
        ),
        (
            Surface::Cylinder(Cylinder::new(AT, z, 2.0)),
            [1.0, 2.0, -5.0],
            -2.0,
        ),
        (Surface::Sphere(Sphere::new(AT, 7.0)), [1.0, 5.0, 7.0], -2.0),
        (Surface::Sphere(Sphere::new(AT, 7.0)), [1.0, 2.0, 3.0], -7.0),
        // Half-angle 45°: 4 across at height 0 is √8 away, 4 up on the axis −√8.
        (
            Surface::Cone(Cone::new(AT, z, FRAC_PI_4)),
            [5.0, 2.0, 3.0],
            8f64.sqrt(),
        ),
        (
            Surface::Cone(Cone::new(AT, z, FRAC_PI_4)),
            [1.0, 2.0, 7.0],
            -(8f64.sqrt()),
        ),
        (
            Surface::Cone(Cone::new(AT, z, FRAC_PI_4)),
            [1.0, 2.0, -1.0],
            -(8f64.sqrt()),
        ),
        (
            Surface::Cone(Cone::new(AT, z, FRAC_PI_4)),
            [1.0, 2.0, 3.0],
            0.0,
        ),
        // The tube's centre line, beside the tube, and the centre of the hole.
        (
            Surface::Torus(Torus::new(AT, z, 5.0, 1.0)),
            [6.0, 2.0, 3.0],
            -1.0,
        ),
        (
            Surface::Torus(Torus::new(AT, z, 5.0, 1.0)),
            [9.0, 2.0, 7.0],
            4.0,
        ),
        (
            Surface::Torus(Torus::new(AT, z, 5.0, 1.0)),
            [1.0, 2.0, 3.0],
            4.0,
        ),
    ];
    for (surface, [x, y, z], expected) in cases {
        let distance = surface.signed_distance(&Point::new(x, y, z));
        assert!(
            (distance - expected).abs() < 1e-14,
            "{surface:?}: {distance}"
        );
    }
}

#[test]
fn feet_and_normals_of_known_points_are_known() {
    let z = Vector::z();
    let cylinder = Surface::Cylinder(Cylinder::new(AT, z, 2.0));
    let outside = Point::new(5.0, 2.0, 8.0);
    assert_eq!(cylinder.foot(&outside), Point::new(3.0, 2.0, 8.0));
    assert_eq!(cylinder.normal(&outside).into_inner(), Vector::x());
    let cone = Surface::Cone(Cone::new(AT, z, FRAC_PI_4));
    let across = Point::new(5.0, 2.0, 3.0);
    assert!((cone.foot(&across) - Point::new(3.0, 2.0, 5.0)).norm() < 1e-14);
    let torus = Surface::Torus(Torus::new(AT, z, 5.0, 1.0));
    let above = Point::new(1.0, 7.0, 6.0);
    assert!((torus.foot(&above) - Point::new(1.0, 7.0, 4.0)).norm() < 1e-14);
    assert_eq!(torus.normal(&above).into_inner(), z);
}

#[test]
fn inside_a_spindle_torus_the_inner_sheet_counts_too() {
    // Circles of radius 2 about (±1, 0): the axis is met at heights ±√3, the inner sheet lies
    // between them and reaches out to radius 1.
    let torus = Surface::Torus(Torus::new(Point::origin(), Vector::z(), 1.0, 2.0));
    assert!((torus.distance(&Point::origin()) - 1.0).abs() < 1e-15);
    assert!(torus.distance(&Point::new(0.0, 0.0, 3f64.sqrt())) < 1e-15);
    assert!(torus.distance(&Point::new(1.0, 0.0, 0.0)) < 1e-15);
    assert!((torus.distance(&Point::new(0.5, 0.0, 0.0)) - 0.5).abs() < 1e-15);
    let foot = torus.foot(&Point::new(0.5, 0.0, 0.0));
    assert!((foot - Point::new(1.0, 0.0, 0.0)).norm() < 1e-14);
}

#[test]
fn an_axis_has_one_sign_and_a_cylinder_one_centre() {
    let one = Cylinder::new(Point::new(1.0, 2.0, 3.0), -Vector::z(), -4.0);
    let other = Cylinder::new(Point::new(1.0, 2.0, -9.0), Vector::z() * 5.0, 4.0);
    assert_eq!(one, other);
    assert_eq!(one.centre, Point::new(1.0, 2.0, 0.0));
}

fn vector(range: f64) -> impl Strategy<Value = Vector> {
    [-range..range, -range..range, -range..range].prop_map(Vector::from)
}

fn any_surface() -> impl Strategy<Value = Surface> {
    let axis = vector(1.0).prop_filter("a direction", |axis| axis.norm() > 0.1);
    let (major, minor, angle) = (0.0..20.0, 0.1..20.0, 0.05..1.5);
    (0..5, vector(50.0), axis, major, minor, angle).prop_map(
        |(kind, at, axis, major, minor, angle)| {
            let at = Point::from(at);
            match kind {
                0 => Surface::Plane(Plane::new(at, axis)),
                1 => Surface::Cylinder(Cylinder::new(at, axis, minor)),
                2 => Surface::Cone(Cone::new(at, axis, angle)),
                3 => Surface::Sphere(Sphere::new(at, minor)),
                _ => Surface::Torus(Torus::new(at, axis, major, minor)),
            }
        },
    )
}

proptest! {
    #[test]
    fn the_foot_lies_on_the_surface_as_far_away_as_the_distance_says(
        surface in any_surface(),
        point in vector(100.0),
    ) {
        let point = Point::from(point);
        let foot = surface.foot(&point);
        prop_assert!(surface.distance(&foot) < 1e-11);
        prop_assert!(((point - foot).norm() - surface.distance(&point)).abs() < 1e-11);
        prop_assert!((surface.normal(&point).norm() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn no_sampled_point_of_the_surface_is_nearer_than_the_foot(
        surface in any_surface(),
        point in vector(100.0),
    ) {
        let point = Point::from(point);
        let distance = surface.distance(&point);
        let samples =
            sample_parametric(surface.kind(), &surface.to_parametric());
        prop_assert!(!samples.is_empty());
        for sample in samples {
            prop_assert!((point - sample).norm() > distance - 1e-10);
        }
    }

    #[test]
    fn distances_move_and_scale_with_space(
        surface in any_surface(),
        point in vector(100.0),
        turn in vector(3.0),
        shift in vector(100.0),
        factor in 0.01..100.0,
    ) {
        let point = Point::from(point);
        let distance = surface.distance(&point);
        let motion = Isometry3::from_parts(
            Translation3::from(shift),
            UnitQuaternion::from_scaled_axis(turn),
        );
        let moved = surface.moved(&motion).distance(&(motion * point));
        prop_assert!((moved - distance).abs() < 1e-10);
        let scaled = surface.scaled(factor).distance(&(point * factor));
        prop_assert!((scaled - distance * factor).abs() < 1e-10 * factor);
    }
}
