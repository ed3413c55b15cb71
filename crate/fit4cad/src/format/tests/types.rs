//! Types of points beside the labels that they are of.

use crate::diagnostics::Diagnostic;
use crate::format::{Role, SourceFile, read_model};
use crate::surface::SurfaceType::{self, Cone, Cylinder, Plane};

/// Six points, one of them broken, in two segments.
const CLOUD: &str = "0 0 0\n1 0 0\nnan 0 0\n0 1 0\n5 5 1\n5 5 2\n5 6 3\n";
const LABELS: &str = "3\n3\n3\n3\n8\n8\n8\n";

/// What is said of each finding.
fn said(findings: &[Diagnostic]) -> Vec<String> {
    findings.iter().map(Diagnostic::to_string).collect()
}

fn file<'a>(path: &'a str, role: Role, bytes: &'a [u8]) -> SourceFile<'a> {
    SourceFile {
        path,
        role,
        method: None,
        bytes,
    }
}

/// The types of the true segments, and what is wrong.
fn read(types: &[u8], path: &str) -> (Vec<Option<SurfaceType>>, Vec<String>) {
    let files = [
        file("A.xyz", Role::Cloud, CLOUD.as_bytes()),
        file("A_inst.txt", Role::Primitives, LABELS.as_bytes()),
        file(path, Role::Types, types),
    ];
    let (model, findings) = read_model("A", &files);
    let primitives = model.truth.iter().flat_map(|truth| &truth.primitives);
    let findings = findings.into_iter().filter(|it| it.file == path);
    (
        primitives.map(|it| it.kind).collect(),
        said(&findings.collect::<Vec<_>>()),
    )
}

fn text(types: &str) -> (Vec<Option<SurfaceType>>, Vec<String>) {
    read(types.as_bytes(), "A_type.txt")
}

#[test]
fn a_segment_is_of_the_type_that_most_of_its_points_have() {
    // The row that is no point is not counted.
    let (kinds, findings) = text("1\n1\n4\n4\n4\n4\n1\n");
    assert_eq!(kinds, [Some(Plane), Some(Cylinder)]);
    assert_eq!(findings.len(), 1);
    assert!(
        findings[0].contains("as ParseNet and HPNet number them"),
        "{findings:?}"
    );
    // As NumPy writes them, with a name before; no number beyond SPFN's.
    let (kinds, findings) = text("type\n1e0\n1e0\n1e0\n1e0\n2.0\n2.0\n-1\n");
    assert_eq!(kinds, [Some(Plane), Some(Cylinder)]);
    assert!(findings[0].contains("as SPFN numbers them"), "{findings:?}");
}

#[test]
fn types_may_be_names() {
    let (kinds, findings) = text("\"plane\"\nPlane\nPlane\nCone\nCone\ncone\nCone\n");
    assert_eq!(kinds, [Some(Plane), Some(Cone)]);
    assert_eq!(findings, [""; 0]);
    let (kinds, findings) = text("Plane\nPlane\nPlane\nPlane\nBSpline\nBSpline\nBSpline\n");
    assert_eq!(kinds[0], Some(Plane));
    assert!(
        findings[0].contains("none of the five (3 of 7 rows"),
        "{findings:?}"
    );
}

#[test]
fn an_array_of_numpy_tells_types_too() {
    let head = "{'descr': '|u1', 'fortran_order': False, 'shape': (7,), }\n";
    let mut npy = b"\x93NUMPY\x01\x00".to_vec();
    npy.extend((head.len() as u16).to_le_bytes());
    npy.extend(head.bytes());
    npy.extend([1, 1, 1, 1, 4, 4, 4]);
    let (kinds, _) = read(&npy, "A_type.npy");
    assert_eq!(kinds, [Some(Plane), Some(Cylinder)]);
}

#[test]
fn types_that_cannot_be_used_are_told_and_left() {
    for (types, told) in [
        ("1\n1\n1\n", "3 types for 7 rows"),
        ("1\n1\n1\n1\n44\n44\n44\n", "numbers up to 44"),
        ("0 0 0 1\n1 0 0 1\n", "8 types for 7 rows"),
        (
            "1\n1\n1\n?\n?\n?\n?\n",
            "A type could not be read (4 of 7 rows",
        ),
    ] {
        let (_, findings) = text(types);
        assert!(findings.iter().any(|it| it.contains(told)), "{findings:?}");
    }
    let alone = [
        file("A.xyz", Role::Cloud, CLOUD.as_bytes()),
        file("A_type.txt", Role::Types, b"1\n1\n1\n1\n1\n1\n1\n"),
    ];
    let (model, findings) = read_model("A", &alone);
    assert_eq!(model.truth, None);
    let told = said(&findings);
    assert!(
        told.iter()
            .any(|it| it.contains("no segments that they would be of")),
        "{told:?}"
    );
}

#[test]
fn what_the_surfaces_say_comes_before() {
    let files = [
        file("A.xyz", Role::Cloud, CLOUD.as_bytes()),
        file(
            "A_primitives.txt",
            Role::Primitives,
            b"Primitive1:=[1 2 4];\nPrimitive2:=[5 6 7];\n",
        ),
        file(
            "A_implicit.txt",
            Role::Implicit,
            b"Primitive1:=[Plane, [0 0 1 0]];\n",
        ),
        file("A_type.txt", Role::Types, b"4\n4\n4\n4\n4\n4\n4\n"),
    ];
    let (model, _) = read_model("A", &files);
    let truth = model.truth.unwrap();
    let kinds: Vec<_> = truth.primitives.iter().map(|it| it.kind).collect();
    assert_eq!(kinds, [Some(Plane), Some(Cylinder)]);
}

#[test]
fn one_number_a_row_is_no_cloud() {
    for (path, text) in [
        ("A.txt", "0\n0\n1\n1\n"),
        ("A.csv", "label\n-1\n3\n"),
        ("A.xyz", "Plane\nCone\n"),
    ] {
        let files = [file(path, Role::Cloud, text.as_bytes())];
        let (model, findings) = read_model("A", &files);
        assert!(model.cloud.is_empty());
        let told = said(&findings);
        assert!(
            told.len() == 1 && told[0].contains("for each point of one"),
            "{told:?}"
        );
    }
}
