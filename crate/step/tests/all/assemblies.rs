//! Parts where assemblies put them.

use crate::made::Made;
use fit4cad::surface::Surface;
use fit4cad_step::{Document, Import};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A ball of a radius at (1, 0, 0), as a representation of its own.
fn ball(made: &mut Made, radius: f64, context: usize) -> usize {
    let frame = made.frame(X, Z, None);
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},{radius:?})"));
    let face = made.face(&[], surface, true);
    let shell = made.add(&format!("CLOSED_SHELL('',(#{face}))"));
    let solid = made.add(&format!("MANIFOLD_SOLID_BREP('ball',#{shell})"));
    made.representation("ADVANCED_BREP_SHAPE_REPRESENTATION", &[solid], context)
}

/// Puts a component into an assembly, from one frame to another; `swapped` writes the assembly first.
fn put(
    made: &mut Made,
    part: (usize, usize),
    whole: (usize, usize),
    frames: [usize; 2],
    swapped: bool,
) {
    let [mut from, mut to] = frames;
    let (mut first, mut second) = (part.1, whole.1);
    if swapped {
        (first, second) = (second, first);
        (from, to) = (to, from);
    }
    let map = made.add(&format!("ITEM_DEFINED_TRANSFORMATION('','',#{from},#{to})"));
    let relation = made.add(&format!(
        "(REPRESENTATION_RELATIONSHIP('','',#{first},#{second}) REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{map}) SHAPE_REPRESENTATION_RELATIONSHIP())"
    ));
    let occurrence = made.add(&format!(
        "NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','','',#{},#{},$)",
        whole.0, part.0
    ));
    let shape = made.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{occurrence})"));
    made.add(&format!(
        "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{shape})"
    ));
}

fn centres(import: &Import) -> Vec<[f64; 3]> {
    let primitives = &import.model.truth.as_ref().unwrap().primitives;
    let mut centres: Vec<[f64; 3]> = primitives
        .iter()
        .map(|it| match it.surface {
            Some(Surface::Sphere(sphere)) => sphere.centre.coords.into(),
            _ => [f64::NAN; 3],
        })
        .map(|centre: [f64; 3]| centre.map(|x| (x * 1e9).round() / 1e9 + 0.0))
        .collect();
    centres.sort_by(|a, b| a.partial_cmp(b).unwrap());
    centres
}

/// A ball twice in an assembly, and that twice, turned, in another: four balls, whichever of the two
/// representations is written first.
#[test]
fn nested_instances_are_there_once_each() {
    for swapped in [false, true] {
        let mut made = Made::new();
        let context = made.context;
        let origin = made.frame([0.0; 3], Z, Some(X));
        let aside = made.frame([0.0, 5.0, 0.0], Z, Some(X));
        let turned = made.frame([0.0, 0.0, 20.0], Z, Some(Y));
        let solid = ball(&mut made, 0.5, context);
        // The shape of a part is most often a representation of its own, joined to that of the solid.
        let shape = made.representation("SHAPE_REPRESENTATION", &[origin], context);
        made.add(&format!(
            "SHAPE_REPRESENTATION_RELATIONSHIP('','',#{shape},#{solid})"
        ));
        let inner = made.representation("SHAPE_REPRESENTATION", &[origin, aside], context);
        let outer = made.representation("SHAPE_REPRESENTATION", &[origin, turned], context);
        let parts = [("ball", shape), ("pair", inner), ("all", outer)]
            .map(|(name, shape)| (made.product(name, shape), shape));
        for place in [origin, aside] {
            put(&mut made, parts[0], parts[1], [origin, place], swapped);
        }
        for place in [origin, turned] {
            put(&mut made, parts[1], parts[2], [origin, place], swapped);
        }
        let found = made.import();
        let expected = [
            [-5.0, 1.0, 20.0],
            [0.0, 1.0, 20.0],
            [1.0, 0.0, 0.0],
            [1.0, 5.0, 0.0],
        ];
        assert_eq!(centres(&found), expected, "{swapped}");
        assert_eq!((found.report.bodies, found.report.instances), (1, 4));
    }
}

/// An assembly in inches of a part in millimetres: every placement is in the units of its own.
#[test]
fn placements_have_the_units_of_their_representations() {
    let mut made = Made::new();
    let millimetre = made.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
    let radian = made.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    let inch = made.converted("LENGTH", "INCH", 25.4, millimetre);
    let inches = made.units(inch, radian);
    let context = made.context;
    let solid = ball(&mut made, 0.5, context);
    let origin = made.frame([0.0; 3], Z, Some(X));
    let place = made.frame([2.0, 0.0, 0.0], Z, Some(X));
    let whole = made.representation("SHAPE_REPRESENTATION", &[place], inches);
    let parts =
        [("ball", solid), ("all", whole)].map(|(name, shape)| (made.product(name, shape), shape));
    put(&mut made, parts[0], parts[1], [origin, place], false);
    assert_eq!(centres(&made.import()), [[51.8, 0.0, 0.0]]);
}

#[test]
fn mapped_copies_and_mirrored_ones_are_there() {
    let mut made = Made::new();
    let context = made.context;
    let solid = ball(&mut made, 0.5, context);
    let origin = made.frame([0.0; 3], Z, Some(X));
    let aside = made.frame([0.0, 0.0, 7.0], Z, Some(Y));
    let map = made.add(&format!("REPRESENTATION_MAP(#{origin},#{solid})"));
    let copy = made.add(&format!("MAPPED_ITEM('',#{map},#{aside})"));
    let axes = [[-1.0, 0.0, 0.0], Y, Z].map(|axis| made.direction(axis));
    let at = made.point([0.0; 3]);
    let mirror = made.add(&format!(
        "CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,#{},#{},#{at},2.,#{})",
        axes[0], axes[1], axes[2]
    ));
    let mirrored = made.add(&format!("MAPPED_ITEM('',#{map},#{mirror})"));
    made.representation("SHAPE_REPRESENTATION", &[copy, mirrored], context);
    let found = made.import();
    assert_eq!(centres(&found), [[-2.0, 0.0, 0.0], [0.0, 1.0, 7.0]]);
}

#[test]
fn a_placement_that_cannot_be_read_is_said_and_never_taken_for_none() {
    let mut made = Made::new();
    let context = made.context;
    let solid = ball(&mut made, 0.5, context);
    let other = ball(&mut made, 0.25, context);
    let origin = made.frame([0.0; 3], Z, Some(X));
    let broken = made.add("AXIS2_PLACEMENT_3D('',#999,$,$)");
    let whole = made.representation("SHAPE_REPRESENTATION", &[origin], context);
    let parts =
        [("ball", solid), ("all", whole)].map(|(name, shape)| (made.product(name, shape), shape));
    put(&mut made, parts[0], parts[1], [origin, broken], false);
    let _ = other;
    let found = made.import();
    assert_eq!(centres(&found), [[1.0, 0.0, 0.0]]);
    assert_eq!(found.report.instances, 1);
    assert!(
        found.report.left_out[0].contains("cannot be placed"),
        "{:?}",
        found.report.left_out
    );
}

#[test]
fn a_part_without_a_representation_stands_where_it_is() {
    let mut made = Made::new();
    let frame = made.frame(X, Z, None);
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},2.)"));
    let face = made.face(&[], surface, true);
    let shell = made.add(&format!("CLOSED_SHELL('',(#{face}))"));
    made.add(&format!("MANIFOLD_SOLID_BREP('',#{shell})"));
    let found = made.import();
    assert_eq!(centres(&found), [[1.0, 0.0, 0.0]]);
    assert_eq!(found.report.warnings.len(), 1);
}

/// Each assembly holds the next twice: 2⁴⁰ instances, and an assembly in itself.
#[test]
fn assemblies_that_grow_without_end_end_in_a_word() {
    let mut made = Made::new();
    let context = made.context;
    let origin = made.frame([0.0; 3], Z, Some(X));
    let mut last = ball(&mut made, 1.0, context);
    for _ in 0..40 {
        let map = made.add(&format!("REPRESENTATION_MAP(#{origin},#{last})"));
        let copies = [0, 1].map(|_| made.add(&format!("MAPPED_ITEM('',#{map},#{origin})")));
        last = made.representation("SHAPE_REPRESENTATION", &copies, context);
    }
    let error = Document::read(made.text().as_bytes(), &mut |_| {})
        .err()
        .unwrap();
    assert!(error.to_string().contains("more than"), "{error}");
}

#[test]
fn some_bodies_can_be_kept_and_others_are_named() {
    let mut made = Made::new();
    let context = made.context;
    for radius in [1.0, 2.0, 4.0] {
        ball(&mut made, radius, context);
    }
    let mut document = Document::read(made.text().as_bytes(), &mut |_| {}).unwrap();
    let whole = document.diagonal;
    let error = document.keep(&[1, 4]).unwrap_err().to_string();
    assert_eq!(
        error,
        "bodies must be of 1 (ball, 1 faces), 2 (ball, 1 faces), 3 (ball, 1 faces), not 4"
    );
    document.keep(&[2, 1]).unwrap();
    assert!(document.diagonal < 0.6 * whole);
    let options = fit4cad_step::Options::default();
    let found = document.sample("balls", &options, &mut |_| {}).unwrap();
    assert_eq!((found.report.bodies, found.report.faces.len()), (2, 2));
    assert!((found.report.area / (20.0 * std::f64::consts::PI) - 1.0).abs() < 1e-6);
}
