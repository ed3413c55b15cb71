use std::borrow::Cow;

use crate::cloud::Point;
use crate::diagnostics::{Diagnostic, Severity};
use crate::format::limits::{MAX_FILE_BYTES, MAX_MODEL_BYTES};
use crate::format::{Role, Source, SourceFile, read_model, write_primitives};
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

/// A file that states a size.
struct Stated {
    path: &'static str,
    role: Role,
    method: Option<&'static str>,
    size: u64,
    content: Result<&'static [u8], &'static str>,
}

impl Source for Stated {
    fn path(&self) -> &str {
        self.path
    }

    fn role(&self) -> Role {
        self.role
    }

    fn method(&self) -> Option<&str> {
        self.method
    }

    fn size(&self) -> u64 {
        self.size
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        assert!(self.size <= MAX_FILE_BYTES, "{} is asked for", self.path);
        self.content.map(Cow::Borrowed).map_err(str::to_owned)
    }
}

fn cloud_of(size: u64) -> Stated {
    Stated {
        path: "PC1.txt",
        role: Role::Cloud,
        method: None,
        size,
        content: Ok(b"Points:=[[0, 0, 0], [1, 0, 0]];"),
    }
}

fn result_of(method: &'static str, size: u64) -> Stated {
    Stated {
        path: method,
        role: Role::Primitives,
        method: Some(method),
        size,
        content: Ok(b"Primitive1:=[1 2];"),
    }
}

#[test]
fn a_file_too_large_is_refused_by_its_size_and_the_others_are_read() {
    let files = [
        cloud_of(31),
        result_of("A", MAX_FILE_BYTES + 1),
        result_of("B", 18),
    ];
    let (model, diagnostics) = read_model("PC1", &files);
    assert_eq!(model.submissions.len(), 1);
    assert_eq!(model.submissions[0].method, "B");
    let [diagnostic] = &diagnostics[..] else {
        panic!("{diagnostics:?}")
    };
    assert_eq!(diagnostic.file, "A");
    assert_eq!(
        (&diagnostic.found[..], &diagnostic.expected[..]),
        ("513 MiB", "at most 512 MiB")
    );
    let (model, diagnostics) = read_model("PC1", &[cloud_of(u64::MAX)]);
    assert!(model.cloud.is_empty());
    assert_eq!(diagnostics.len(), 1);
}

#[test]
fn a_model_is_read_up_to_its_limit() {
    let methods = ["A", "B", "C", "D", "E"];
    let mut files = vec![cloud_of(31)];
    files.extend(methods.map(|method| result_of(method, MAX_MODEL_BYTES / 4)));
    let (model, diagnostics) = read_model("PC1", &files);
    let read: Vec<&str> = model
        .submissions
        .iter()
        .map(|each| &each.method[..])
        .collect();
    assert_eq!(read, ["A", "B", "C"]);
    let told: Vec<&str> = diagnostics.iter().map(|each| &each.file[..]).collect();
    assert_eq!(told, ["D", "E"]);
    assert_eq!(
        diagnostics[0].expected,
        "at most 1024 MiB in all files of a model"
    );
}

#[test]
fn a_content_that_cannot_be_had_is_told() {
    let broken = Stated {
        content: Err("its checksum is wrong"),
        ..result_of("A", 18)
    };
    let (model, diagnostics) = read_model("PC1", &[cloud_of(31), broken]);
    assert_eq!((model.cloud.len(), model.submissions.len()), (2, 0));
    let message = "The file could not be read: its checksum is wrong";
    assert_eq!(diagnostics[0].message, message);
    assert_eq!(diagnostics[0].severity, Severity::Error);
}

#[test]
fn point_lists_are_written_by_the_numbers_they_were_read_by() {
    let file = |path, role, bytes: &'static str| SourceFile {
        path,
        role,
        method: None,
        bytes: bytes.as_bytes(),
    };
    let cloud = "[NaN, NaN, NaN],\n[0, 0, 0],\n[1, 0],\n[1, 0, 0],\n[0, 1, 0]];";
    let lists = "Primitive1:=[2 5];\nPrimitive2:=[4];\n";
    let files = [
        file("PC1.txt", Role::Cloud, cloud),
        file("PC1_primitives.txt", Role::Primitives, lists),
    ];
    let (model, _) = read_model("PC1", &files);
    let truth = model.truth.unwrap();
    assert_eq!(truth.primitives[0].points, [0, 2]);
    assert_eq!(write_primitives(&truth, model.cloud.numbering()), lists);
}
