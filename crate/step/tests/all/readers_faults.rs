//! What the scene of the reader crate gets wrong and this crate, which takes its syntax alone, must not.
//! Each test is the smallest file that shows it.

use std::f64::consts::PI;

use crate::made::{Made, list, near};
use fit4cad::surface::{Surface, SurfaceType};

/// A closed edge against its curve: read without its sense, a fillet of two full circles is empty.
#[test]
fn a_fillet_of_full_circles_against_their_curves_is_whole() {
    let (major, minor) = (6.5, 1.5);
    for reversed in [false, true] {
        let mut made = Made::new();
        let frame = made.frame([0.0; 3], [0.0, 0.0, 1.0], Some([1.0, 0.0, 0.0]));
        let surface = made.add(&format!(
            "TOROIDAL_SURFACE('',#{frame},{major:?},{minor:?})"
        ));
        let outer = [major + minor, 0.0, 0.0];
        let upper = [major, 0.0, minor];
        let (a, b) = (made.vertex(outer), made.vertex(upper));
        // Turned over, the curve runs the other way and the edge says so.
        let z = [0.0, 0.0, if reversed { -1.0 } else { 1.0 }];
        let low = made.circle([0.0; 3], z, [1.0, 0.0, 0.0], major + minor);
        let high = made.circle([0.0, 0.0, minor], z, [1.0, 0.0, 0.0], major);
        let low = made.edge(a, a, low, !reversed);
        let high = made.edge(b, b, high, !reversed);
        let (low, high) = (made.ring(&[(low, true)]), made.ring(&[(high, false)]));
        let bounds = [made.bound(low, true), made.bound(high, true)];
        let face = made.face(&bounds, surface, true);
        made.shell(&[face]);
        let import = made.import();
        let expected = 2.0 * PI * minor * (major * PI / 2.0 + minor);
        assert!(
            near(import.report.area, expected, 1e-4),
            "{}",
            import.report.area
        );
    }
}

/// An axis along x and no first direction: the standard then takes y.
#[test]
fn an_axis_parallel_to_the_omitted_direction_is_a_placement() {
    for x in [1.0, -1.0] {
        let mut made = Made::new();
        let frame = made.frame([1.0, 2.0, 3.0], [x, 0.0, 0.0], None);
        let surface = made.add(&format!("CYLINDRICAL_SURFACE('',#{frame},4.)"));
        let bounds = [0.0, 5.0].map(|at| {
            made.round(
                [1.0 + at, 2.0, 3.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                4.0,
                true,
            )
        });
        let face = made.face(&bounds, surface, true);
        made.shell(&[face]);
        let import = made.import();
        assert!(near(import.report.area, 2.0 * PI * 4.0 * 5.0, 1e-6));
        let truth = import.model.truth.unwrap();
        let Some(Surface::Cylinder(cylinder)) = truth.primitives[0].surface else {
            panic!("no cylinder");
        };
        assert!((cylinder.axis.x - 1.0).abs() < 1e-15);
        assert!((cylinder.centre.y - 2.0).abs() < 1e-12 && (cylinder.centre.z - 3.0).abs() < 1e-12);
    }
}

fn sphere(made: &mut Made, centre: [f64; 3], radius: f64) -> usize {
    let frame = made.frame(centre, [0.0, 0.0, 1.0], Some([1.0, 0.0, 0.0]));
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},{radius:?})"));
    let pole = made.vertex([centre[0], centre[1], centre[2] + radius]);
    let ring = made.add(&format!("VERTEX_LOOP('',#{pole})"));
    let bound = made.bound(ring, true);
    let face = made.face(&[bound], surface, true);
    made.add(&format!("CLOSED_SHELL('',(#{face}))"))
}

#[test]
fn the_faces_around_a_void_are_faces_of_the_solid() {
    let mut made = Made::new();
    let (outer, inner) = (
        sphere(&mut made, [0.0; 3], 10.0),
        sphere(&mut made, [1.0, 0.0, 0.0], 3.0),
    );
    let void = made.add(&format!("ORIENTED_CLOSED_SHELL('',*,#{inner},.F.)"));
    let solid = made.add(&format!("BREP_WITH_VOIDS('',#{outer},(#{void}))"));
    let context = made.context;
    made.representation("ADVANCED_BREP_SHAPE_REPRESENTATION", &[solid], context);
    let import = made.import();
    assert_eq!(import.report.faces.len(), 2);
    assert!(near(import.report.area, 4.0 * PI * 109.0, 1e-5));
}

/// One part in inches, the other in millimetres, in one file.
#[test]
fn every_context_has_its_own_units() {
    let mut made = Made::new();
    let millimetre = made.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
    let radian = made.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    let inch = made.converted("LENGTH", "INCH", 25.4, millimetre);
    let inches = made.units(inch, radian);
    let (first, second) = (
        sphere(&mut made, [0.0; 3], 10.0),
        sphere(&mut made, [5.0, 0.0, 0.0], 1.0),
    );
    let millimetres = made.context;
    for (shell, context) in [(first, millimetres), (second, inches)] {
        let solid = made.add(&format!("MANIFOLD_SOLID_BREP('',#{shell})"));
        let items = [solid];
        made.add(&format!(
            "ADVANCED_BREP_SHAPE_REPRESENTATION('',({}),#{context})",
            list(&items)
        ));
    }
    let import = made.import();
    let radii: Vec<f64> = import
        .model
        .truth
        .unwrap()
        .primitives
        .iter()
        .map(|it| match it.surface {
            Some(Surface::Sphere(sphere)) => sphere.radius,
            _ => 0.0,
        })
        .collect();
    assert_eq!(radii, [10.0, 25.4]);
}

#[test]
fn angles_may_be_in_degrees() {
    let mut made = Made::new();
    let millimetre = made.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
    let radian = made.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    let degree = made.converted("PLANE_ANGLE", "DEGREE", PI / 180.0, radian);
    made.context = made.units(millimetre, degree);
    let frame = made.frame([0.0; 3], [0.0, 0.0, 1.0], Some([1.0, 0.0, 0.0]));
    let surface = made.add(&format!("CONICAL_SURFACE('',#{frame},2.,45.)"));
    let bounds = [(0.0, 2.0), (3.0, 5.0)].map(|(z, radius)| {
        made.round(
            [0.0, 0.0, z],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            radius,
            true,
        )
    });
    let face = made.face(&bounds, surface, true);
    made.shell(&[face]);
    let import = made.import();
    assert!(near(
        import.report.area,
        PI * 7.0 * 3.0 * 2.0_f64.sqrt(),
        1e-5
    ));
    let primitive = &import.model.truth.unwrap().primitives[0];
    assert_eq!(primitive.kind, Some(SurfaceType::Cone));
    let Some(Surface::Cone(cone)) = primitive.surface else {
        panic!("no cone");
    };
    assert!((cone.half_angle - PI / 4.0).abs() < 1e-15);
    assert!((cone.apex.z + 2.0).abs() < 1e-12);
}
