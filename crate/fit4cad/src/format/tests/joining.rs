use crate::cloud::Point;
use crate::diagnostics::{Diagnostic, Severity};
use crate::format::{Role, SourceFile, read_model};
use crate::model::{Coefficients, Segmentation};
use crate::surface::SurfaceType;

/// Reads a model of nine points whose truth has the given three files, where they are there.
fn truth(
    primitives: &str,
    parametric: Option<&str>,
    implicit: Option<&str>,
) -> (Segmentation, Vec<Diagnostic>) {
    let cloud = format!("Points:=[{}];", ["[0, 0, 0]"; 9].join(","));
    let file = |path, role, bytes| SourceFile {
        path,
        role,
        method: None,
        bytes,
    };
    let mut files = vec![
        file("PC1.txt", Role::Cloud, cloud.as_bytes()),
        file(
            "PC1_primitives.txt",
            Role::Primitives,
            primitives.as_bytes(),
        ),
    ];
    files.extend(
        parametric.map(|text| file("PC1_parametric.txt", Role::Parametric, text.as_bytes())),
    );
    files.extend(implicit.map(|text| file("PC1_implicit.txt", Role::Implicit, text.as_bytes())));
    let (model, diagnostics) = read_model("PC1", &files);
    (model.truth.unwrap(), diagnostics)
}

fn plane(number: u32, offset: i32) -> String {
    format!("Primitive{number}:=[Plane, [0 0 1 {offset}]];\n")
}

fn offsets(truth: &Segmentation) -> Vec<Option<f64>> {
    truth
        .primitives
        .iter()
        .map(|primitive| primitive.implicit.values().map(|values| values[3]))
        .collect()
}

const THREE: &str = "Primitive1:=[1];Primitive2:=[2];Primitive7:=[3];";

#[test]
fn surfaces_belong_to_the_primitives_of_their_numbers() {
    let (truth, diagnostics) = truth(THREE, None, Some(&(plane(7, 70) + &plane(1, 10))));
    assert_eq!(offsets(&truth), [Some(10.0), None, Some(70.0)]);
    assert_eq!(truth.primitives[1].implicit, Coefficients::Missing);
    assert_eq!(diagnostics.len(), 1);
    assert_eq!(diagnostics[0].found, "none for Primitive2");
}

#[test]
fn surfaces_of_other_numbers_belong_by_position_if_there_are_as_many() {
    let (truth, diagnostics) = truth(
        THREE,
        None,
        Some(&(plane(1, 1) + &plane(2, 2) + &plane(3, 3))),
    );
    assert_eq!(offsets(&truth), [Some(1.0), Some(2.0), Some(3.0)]);
    assert_eq!(diagnostics[0].severity, Severity::Note);
}

#[test]
fn surfaces_that_cannot_be_told_to_their_primitives_are_an_error_that_names_both_files() {
    let (truth, diagnostics) = truth(THREE, None, Some(&(plane(1, 1) + &plane(3, 3))));
    assert_eq!(offsets(&truth), [None; 3]);
    let error = diagnostics[0].to_string();
    assert!(error.starts_with("PC1_implicit.txt: error"), "{error}");
    assert!(error.contains("PC1_primitives.txt"), "{error}");
}

#[test]
fn a_missing_or_empty_file_is_converted_from_the_other() {
    let cylinder = "Primitive1:=[Cylinder, [-8 0 0 0 -8 0 0 0 1 0 0 5]];";
    for implicit in [None, Some(""), Some(" \r\n% nothing\n")] {
        let (truth, _) = truth("Primitive1:=[1 2];", Some(cylinder), implicit);
        let primitive = &truth.primitives[0];
        let values = primitive.implicit.values().unwrap();
        assert_eq!(values.len(), 10);
        assert!((values[9] / values[0] + 64.0).abs() < 1e-9, "{values:?}");
        assert!(
            (primitive
                .surface
                .unwrap()
                .distance(&Point::new(10.0, 0.0, 3.0))
                - 2.0)
                .abs()
                < 1e-12
        );
    }
    let (truth, _) = truth("Primitive1:=[1 2];", Some(""), Some(&plane(1, -3)));
    assert_eq!(
        truth.primitives[0].parametric.values().map(<[f64]>::len),
        Some(9)
    );
    assert_eq!(
        truth.primitives[0]
            .surface
            .unwrap()
            .distance(&Point::origin()),
        3.0
    );
}

#[test]
fn an_entry_missing_or_malformed_in_a_file_that_is_there_stays_so() {
    let parametric = "Primitive1:=[Plane, [1 0 0 0 1 0 0 0 0]];Primitive2:=[Plane, [1]];";
    let (truth, _) = truth(
        THREE,
        Some(parametric),
        Some(&(plane(1, 0) + &plane(2, 0) + &plane(7, 0))),
    );
    assert!(truth.primitives[0].surface.is_some());
    assert_eq!(truth.primitives[1].parametric, Coefficients::Malformed);
    assert_eq!(truth.primitives[1].surface, None);
    assert_eq!(truth.primitives[2].parametric, Coefficients::Missing);
    assert_eq!(truth.primitives[2].surface, None);
    assert_eq!(truth.primitives[2].kind, Some(SurfaceType::Plane));
}

#[test]
fn a_vector_that_is_no_member_of_its_family_is_reported_with_its_misfit() {
    let ellipse = "\nPrimitive1:=[Cylinder, [8 0 0 0 7 0 0 0 1 0 0 5]];";
    let (truth, diagnostics) = truth("Primitive1:=[1];", Some(ellipse), None);
    assert!(truth.primitives[0].surface.is_some());
    assert_eq!(diagnostics[0].position.map(|at| at.line), Some(2));
    assert!(diagnostics[0].found.contains('%'), "{}", diagnostics[0]);
}
