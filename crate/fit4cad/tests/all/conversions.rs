//! The three forms of a surface agree: canonical, parametric, implicit.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use fit4cad::cloud::{Point, Vector};
use fit4cad::surface::{
    Cone, Conversion, ConversionError, Cylinder, Defect, Plane, Sphere, Surface, SurfaceType, Torus,
};
use proptest::prelude::*;

const TILTED: Vector = Vector::new(1.0, -2.0, 0.5);

fn surfaces_at(centre: Point) -> [Surface; 5] {
    [
        Surface::Plane(Plane::new(centre, TILTED)),
        Surface::Cylinder(Cylinder::new(centre, TILTED, 2.0)),
        Surface::Cone(Cone::new(centre, TILTED, 0.4)),
        Surface::Sphere(Sphere::new(centre, 3.0)),
        Surface::Torus(Torus::new(centre, TILTED, 5.0, 1.5)),
    ]
}

/// Largest distance between points of one surface and the other surface.
fn apart(a: &Surface, b: &Surface) -> f64 {
    let mut worst: f64 = 0.0;
    for (u, v) in [(0.1, -0.7), (1.0, 0.4), (2.0, 1.3), (3.5, 2.9), (5.0, -2.0)] {
        let point = fit4cad::surface::parametric_point(a.kind(), &a.to_parametric(), u, v);
        worst = worst.max(b.distance(&point.unwrap()));
    }
    worst
}

#[test]
fn every_family_returns_from_its_parametric_form() {
    for surface in surfaces_at(Point::new(3.0, 1.0, -2.0)) {
        let back = Surface::from_parametric(surface.kind(), &surface.to_parametric()).unwrap();
        assert!(apart(&surface, &back.surface) < 1e-13, "{surface:?}");
        assert!(back.misfit < 1e-13, "{surface:?}: {}", back.misfit);
    }
}

#[test]
fn every_family_returns_from_its_implicit_form() {
    for surface in surfaces_at(Point::new(3.0, 1.0, -2.0)) {
        let back = Surface::from_implicit(surface.kind(), &surface.to_implicit()).unwrap();
        assert!(apart(&surface, &back.surface) < 1e-12, "{surface:?}");
        assert!(back.misfit < 1e-12, "{surface:?}: {}", back.misfit);
    }
}

#[test]
fn norm_and_sign_of_an_implicit_vector_do_not_matter() {
    for surface in surfaces_at(Point::new(3.0, 1.0, -2.0)) {
        let vector: Vec<f64> = surface
            .to_implicit()
            .iter()
            .map(|value| value * -7.5)
            .collect();
        let back = Surface::from_implicit(surface.kind(), &vector).unwrap();
        assert!(apart(&surface, &back.surface) < 1e-12, "{surface:?}");
    }
}

#[test]
fn a_frame_turned_backwards_is_a_cylinder_with_a_positive_radius() {
    let vector = [
        -8.0, 0.0, 0.0, 0.0, -8.0, 0.0, 0.0, 0.0, -1.0, 1.0, 2.0, 9.0,
    ];
    let Conversion { surface, misfit } =
        Surface::from_parametric(SurfaceType::Cylinder, &vector).unwrap();
    let expected = Cylinder::new(Point::new(1.0, 2.0, 0.0), Vector::z(), 8.0);
    assert_eq!(surface, Surface::Cylinder(expected));
    assert!(misfit < 1e-15);
}

#[test]
fn the_cone_of_the_format_s_example_has_its_apex_where_the_rings_close() {
    // Radius 13.5 at z = 26.5, narrowing upwards at 45°: apex at z = 40.
    let s = FRAC_1_SQRT_2;
    let vector = [
        -13.5, 0., 0., 0., 13.5, 0., -s, 0., 0., 0., s, 0., 0., 0., -s, 0., 0., 26.5,
    ];
    let parametric = Surface::from_parametric(SurfaceType::Cone, &vector).unwrap();
    let implicit = [1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 40.0, -1600.0];
    let implicit = Surface::from_implicit(SurfaceType::Cone, &implicit).unwrap();
    for conversion in [parametric, implicit] {
        let Surface::Cone(cone) = conversion.surface else {
            panic!("{conversion:?}")
        };
        assert!((cone.apex - Point::new(0.0, 0.0, 40.0)).norm() < 1e-13);
        assert!((cone.half_angle - FRAC_PI_4).abs() < 1e-15);
        assert!(conversion.misfit < 1e-15);
    }
}

#[test]
fn an_oblique_section_of_a_circular_cylinder_is_no_misfit() {
    let vector = [2.0, 0.0, 5.0, 0.0, 2.0, -3.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0];
    let conversion = Surface::from_parametric(SurfaceType::Cylinder, &vector).unwrap();
    let expected = Cylinder::new(Point::origin(), Vector::z(), 2.0);
    assert_eq!(conversion.surface, Surface::Cylinder(expected));
    assert!(conversion.misfit < 1e-15);
}

#[test]
fn unequal_radii_are_measured_as_misfit() {
    // Half-axes 9 and 11: mean radius 10, off by a tenth.
    let mut vector = [9.0, 0.0, 0.0, 0.0, 11.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let conversion = Surface::from_parametric(SurfaceType::Cylinder, &vector).unwrap();
    assert!((conversion.misfit - 0.1).abs() < 1e-12);
    vector[4] = 9.0;
    let round = Surface::from_parametric(SurfaceType::Cylinder, &vector).unwrap();
    assert!(round.misfit < 1e-15);
}

#[test]
fn skew_frames_are_measured_as_misfit() {
    // The rings of this sphere, cone and torus lean by a tenth.
    let cases = [
        (
            SurfaceType::Sphere,
            vec![1., 0., 0., 0.1, 1., 0., 0., 0., 1., 0., 0., 0.],
        ),
        (
            SurfaceType::Cone,
            vec![
                1., 0., 0., 0., 1., 0., 1., 0., 0., 0., 1., 0., 0.1, 0., 1., 0., 0., 0.,
            ],
        ),
        (
            SurfaceType::Torus,
            vec![
                5., 0., 0., 0., 5., 0., 1., 0., 0., 0., 1., 0., 0.1, 0., 1., 0., 0., 0.,
            ],
        ),
    ];
    for (kind, vector) in cases {
        let conversion = Surface::from_parametric(kind, &vector).unwrap();
        let misfit = conversion.misfit;
        assert!((0.02..0.2).contains(&misfit), "{kind}: {misfit}");
    }
}

#[test]
fn a_quadric_of_another_family_is_measured_as_misfit() {
    // An ellipsoid with half-axes 1, 1 and 1/√1.44.
    let ellipsoid = [1.0, 1.0, 1.44, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0];
    let conversion = Surface::from_implicit(SurfaceType::Sphere, &ellipsoid).unwrap();
    assert!(conversion.misfit > 0.05, "{}", conversion.misfit);
    // A paraboloid z = x² + y² − 1, read as a cylinder.
    let paraboloid = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, -1.0];
    let conversion = Surface::from_implicit(SurfaceType::Cylinder, &paraboloid).unwrap();
    assert!(conversion.misfit > 0.2, "{}", conversion.misfit);
    // A hyperboloid of one sheet, read as a cone.
    let hyperboloid = [1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5];
    let conversion = Surface::from_implicit(SurfaceType::Cone, &hyperboloid).unwrap();
    assert!(conversion.misfit > 0.1, "{}", conversion.misfit);
}

#[test]
fn a_quartic_that_is_no_torus_is_measured_as_misfit() {
    let torus = Surface::Torus(Torus::new(Point::new(1.0, 0.0, 2.0), TILTED, 5.0, 1.5));
    let mut quartic = torus.to_implicit();
    let before = Surface::from_implicit(SurfaceType::Torus, &quartic).unwrap();
    assert!(before.misfit < 1e-12);
    quartic[0] *= 1.3;
    let after = Surface::from_implicit(SurfaceType::Torus, &quartic).unwrap();
    assert!(after.misfit > Conversion::TOLERANCE, "{}", after.misfit);
}

#[test]
fn vectors_without_any_surface_say_what_is_missing() {
    use SurfaceType::{Cone, Cylinder, Plane, Sphere, Torus};
    let defect = |kind, conversion| match conversion {
        Err(ConversionError::Degenerate { kind: of, defect }) if of == kind => defect,
        other => panic!("{kind}: {other:?}"),
    };
    let parametric =
        |kind: SurfaceType, values: &[f64]| defect(kind, Surface::from_parametric(kind, values));
    let implicit =
        |kind: SurfaceType, values: &[f64]| defect(kind, Surface::from_implicit(kind, values));
    let parallel = [1.0, 2.0, 3.0, -2.0, -4.0, -6.0, 0.0, 0.0, 0.0];
    assert_eq!(parametric(Plane, &parallel), Defect::NoNormal);
    assert_eq!(parametric(Cylinder, &[0.0; 12]), Defect::NoAxis);
    assert_eq!(parametric(Cone, &[0.0; 18]), Defect::NoOpening);
    assert_eq!(parametric(Sphere, &[0.0; 12]), Defect::NoRadius);
    assert_eq!(parametric(Torus, &[0.0; 18]), Defect::NoAxis);
    assert_eq!(implicit(Plane, &[0.0, 0.0, 0.0, 1.0]), Defect::NoNormal);
    assert_eq!(implicit(Torus, &[0.0; 35]), Defect::NoLeadingTerms);
    let imaginary = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0];
    assert_eq!(
        implicit(Sphere, &imaginary),
        Defect::Imaginary { square: -4.0 }
    );
    // x² + y² + z²: all eigenvalues alike, so no nappes.
    let point = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(implicit(Cone, &point), Defect::Imaginary { square: -1.0 });
}

#[test]
fn wrong_lengths_and_infinities_are_told_apart() {
    assert_eq!(
        Surface::from_implicit(SurfaceType::Cylinder, &[1.0; 9]),
        Err(ConversionError::WrongLength {
            kind: SurfaceType::Cylinder,
            expected: 10,
            found: 9
        })
    );
    let vector = [1.0, 0.0, 0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(
        Surface::from_parametric(SurfaceType::Plane, &vector),
        Err(ConversionError::NotFinite { position: 5 })
    );
}

#[test]
fn a_radius_of_half_a_million_survives_both_forms() {
    let large = 577_350.0;
    let centre = Point::new(0.0, large - 3.0, 12.0);
    for surface in [
        Surface::Cylinder(Cylinder::new(centre, Vector::x(), large)),
        Surface::Sphere(Sphere::new(centre, large)),
        Surface::Torus(Torus::new(centre, Vector::x(), large, 20.0)),
    ] {
        let kind = surface.kind();
        let parametric = Surface::from_parametric(kind, &surface.to_parametric()).unwrap();
        let implicit = Surface::from_implicit(kind, &surface.to_implicit()).unwrap();
        assert!(apart(&surface, &parametric.surface) < 1e-9, "{kind}");
        assert!(apart(&surface, &implicit.surface) < 1e-3, "{kind}");
    }
}

#[test]
fn a_narrow_cone_with_its_apex_far_away_survives_both_forms() {
    let cone = Surface::Cone(Cone::new(Point::new(4.0, -3.0, 3000.0), Vector::z(), 0.004));
    let parametric = Surface::from_parametric(SurfaceType::Cone, &cone.to_parametric()).unwrap();
    let implicit = Surface::from_implicit(SurfaceType::Cone, &cone.to_implicit()).unwrap();
    let near_origin = Point::new(16.0, -3.0, 0.0);
    let expected = cone.distance(&near_origin);
    for conversion in [parametric, implicit] {
        let distance = conversion.surface.distance(&near_origin);
        assert!((distance - expected).abs() < 1e-10, "{conversion:?}");
    }
}

#[test]
fn vectors_too_long_or_short_to_be_squared_still_have_a_direction() {
    for length in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
        let vector = [1.0, 2.0, 2.0, -3.0].map(|value| value * length);
        let plane = Surface::from_implicit(SurfaceType::Plane, &vector).unwrap();
        let distance = plane.surface.distance(&Point::origin());
        assert!((distance - 1.0).abs() < 1e-15, "{length:e}: {distance}");
        let spanned = [length, 0.0, 0.0, 0.0, length, 0.0, 0.0, 0.0, 5.0];
        let plane = Surface::from_parametric(SurfaceType::Plane, &spanned).unwrap();
        assert_eq!(plane.surface.distance(&Point::origin()), 5.0, "{length:e}");
        let along = [
            2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, length, 0.0, 0.0, 0.0,
        ];
        let cylinder = Surface::from_parametric(SurfaceType::Cylinder, &along).unwrap();
        let expected = Cylinder::new(Point::origin(), Vector::z(), 2.0);
        assert_eq!(cylinder.surface, Surface::Cylinder(expected), "{length:e}");
        assert!(
            plane.misfit < 1e-15 && cylinder.misfit < 1e-15,
            "{length:e}"
        );
    }
}

fn coordinate() -> impl Strategy<Value = f64> {
    -100.0..100.0
}

fn any_surface() -> impl Strategy<Value = Surface> {
    let point = [coordinate(), coordinate(), coordinate()].prop_map(Point::from);
    let axis = [-1.0..1.0, -1.0..1.0, -1.0..1.0f64]
        .prop_map(Vector::from)
        .prop_filter("long enough to have a direction", |axis| axis.norm() > 0.1);
    let (large, small, angle) = (5.0..50.0, 1.0..60.0, 0.1..1.4);
    (0..5, point, axis, large, small, angle).prop_map(|(kind, at, axis, large, small, angle)| {
        match kind {
            0 => Surface::Plane(Plane::new(at, axis)),
            1 => Surface::Cylinder(Cylinder::new(at, axis, small)),
            2 => Surface::Cone(Cone::new(at, axis, angle)),
            3 => Surface::Sphere(Sphere::new(at, small)),
            _ => Surface::Torus(Torus::new(at, axis, large, small)),
        }
    })
}

proptest! {
    #[test]
    fn all_forms_of_any_surface_agree(surface in any_surface()) {
        let kind = surface.kind();
        let parametric = Surface::from_parametric(kind, &surface.to_parametric()).unwrap();
        let implicit = Surface::from_implicit(kind, &surface.to_implicit()).unwrap();
        prop_assert!(apart(&surface, &parametric.surface) < 1e-10);
        prop_assert!(parametric.misfit < 1e-10);
        prop_assert!(apart(&surface, &implicit.surface) < 1e-6);
        prop_assert!(implicit.misfit < 1e-6);
    }

    #[test]
    fn no_numbers_whatever_make_a_conversion_panic(
        kind in prop::sample::select(SurfaceType::ALL.to_vec()),
        values in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::ZERO | prop::num::f64::SUBNORMAL, 35),
    ) {
        for conversion in [
            Surface::from_parametric(kind, &values[..kind.parametric_len()]),
            Surface::from_implicit(kind, &values[..kind.implicit_len()]),
        ].into_iter().flatten() {
            let surface = conversion.surface;
            prop_assert!(surface.is_in_range());
            prop_assert!(conversion.misfit >= 0.0);
            for vector in [surface.to_parametric(), surface.to_implicit()] {
                prop_assert!(vector.iter().all(|value| value.is_finite()), "{surface:?}: {vector:?}");
            }
        }
    }
}
