//! Every quirk of real files, each by example.

use super::*;
use crate::cloud::Point;
use crate::diagnostics::{Diagnostic, Severity};
use crate::model::{Coefficients, Segmentation};
use crate::surface::SurfaceType;

fn cloud(text: &str) -> (Vec<[f64; 3]>, Vec<String>) {
    let (text, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    let points = text
        .cloud
        .points()
        .iter()
        .map(|&point| point.into())
        .collect();
    (points, shown(&diagnostics))
}

fn lists(text: &str) -> (Vec<(u32, Vec<u32>)>, Vec<String>) {
    let (lists, diagnostics) =
        read_primitives("PC1_primitives.txt", text.as_bytes(), &Numbering::of(9));
    (
        lists
            .into_iter()
            .map(|list| (list.number, list.points))
            .collect(),
        shown(&diagnostics),
    )
}

fn surfaces(text: &str) -> (Vec<SurfaceEntry>, Vec<String>) {
    let (file, diagnostics) = read_surfaces("PC1_implicit.txt", text.as_bytes(), Form::Implicit);
    match file {
        SurfaceFile::Entries(entries) => (entries, shown(&diagnostics)),
        SurfaceFile::Absent => (Vec::new(), shown(&diagnostics)),
    }
}

/// `line:column severity`, and what was found, of each diagnostic.
fn shown(diagnostics: &[Diagnostic]) -> Vec<String> {
    diagnostics
        .iter()
        .map(|diagnostic| {
            let place = diagnostic
                .position
                .map_or(String::new(), |at| format!("{}:{} ", at.line, at.column));
            format!("{place}{} {}", diagnostic.severity, diagnostic.found)
                .trim_end()
                .to_owned()
        })
        .collect()
}

const ONE_TWO: [[f64; 3]; 2] = [[1.0, 2.0, 3.0], [-4.5, 0.0, 60.0]];
const NONE: [String; 0] = [];

#[test]
fn a_cloud_in_the_papers_form_reads_without_findings() {
    let text = "Points:=[\n[1.000, 2, 3], \n[-4.5, -0, 6e1] \n ];\n";
    assert_eq!(cloud(text), (ONE_TWO.to_vec(), NONE.to_vec()));
}

#[test]
fn line_ends_tabs_and_a_byte_order_mark_do_not_matter() {
    for text in [
        "Points:=[\r\n[1, 2, 3], \r\n[-4.5, -0, 6e1] \r\n ];\r\n",
        "Points:=[\r[1, 2, 3], \r[-4.5, -0, 6e1] \r ];\r",
        "\u{FEFF}Points:=[\n\t[1,\t2,\t3],\n[-4.5,-0,6e1]];",
        "Points := [ [1,2,3],[-4.5,+.0,60.],\n];",
        "% from a scanner\nPoints:=[\n# two points\n[1,2,3],\n[-4.5,0,60]];",
    ] {
        assert_eq!(cloud(text), (ONE_TWO.to_vec(), NONE.to_vec()), "{text:?}");
    }
}

#[test]
fn matlab_writes_rows_without_brackets_and_commas() {
    for text in [
        "Points=[1 2 3;\n-4.5 0 60];",
        "Points=[1, 2, 3\n-4.5, 0, 60\n];",
        "Points=[\n1 2 3\n-4.5 0 60\n];",
    ] {
        let (points, findings) = cloud(text);
        assert_eq!(points, ONE_TWO, "{text:?}");
        assert!(
            findings.iter().all(|finding| finding.contains("note")),
            "{findings:?}"
        );
    }
}

#[test]
fn bare_columns_are_read_as_points() {
    let (points, findings) = cloud("1 2 3\n-4.5 0 60\n");
    assert_eq!(points, ONE_TWO);
    assert!(
        findings.contains(&"1:1 warning `1 2 3`".to_owned()),
        "{findings:?}"
    );
}

#[test]
fn a_missing_end_is_a_warning() {
    let (points, findings) = cloud("Points:=[\n[1, 2, 3], \n[-4.5, -0, 6e1] \n");
    assert_eq!(
        (points, findings),
        (
            ONE_TWO.to_vec(),
            vec!["4:1 warning the end of the file".to_owned()]
        )
    );
}

#[test]
fn a_point_cut_off_by_the_end_of_the_file_is_left_out() {
    let (points, findings) = cloud("Points:=[\n[1, 2, 3], \n[-4.5, -0, 6");
    assert_eq!(points, ONE_TWO[..1]);
    assert_eq!(findings[0], "3:2 error `-4.5, -0, 6`");
}

#[test]
fn a_broken_row_keeps_its_number() {
    let text = "Points:=[\n[1, 2, 3],\n[1, x, 3],\n[-4.5, 0, 60]];";
    let (read, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    assert_eq!(read.cloud.points()[1], Point::new(-4.5, 0.0, 60.0));
    assert_eq!(shown(&diagnostics), ["3:5 error `x`"]);
    assert_eq!(read.numbering.rows(), 3);
    assert_eq!(read.numbering.resolve(1), PointNumber::Index(0));
    assert_eq!(read.numbering.resolve(2), PointNumber::Broken);
    assert_eq!(read.numbering.resolve(3), PointNumber::Index(1));
    assert_eq!(read.numbering.resolve(0), PointNumber::Outside);
    assert_eq!(read.numbering.resolve(4), PointNumber::Outside);
    let (lists, findings) = read_primitives(
        "PC1_primitives.txt",
        b"Primitive1:=[1 2 3];",
        &read.numbering,
    );
    assert_eq!(lists[0].points, [0, 1]);
    assert_eq!(shown(&findings), ["1:16 warning 2"]);
}

#[test]
fn coordinates_that_are_not_three_finite_numbers_break_the_row() {
    for (row, finding) in [
        ("[NaN, 1, 2]", "2:2 error `NaN`"),
        ("[1, -inf, 2]", "2:5 error `-inf`"),
        ("[1, 1e999, 2]", "2:5 error `1e999`"),
        ("[1, 2]", "2:2 error 2 numbers"),
        ("[1, 2, 3, 4]", "2:2 error 4 numbers"),
        ("[1,5, 2,5, 3,5]", "2:2 error 6 numbers"),
        ("[1,, 2]", "2:4 error `,`"),
        ("[]", "2:2 error 0 numbers"),
    ] {
        let (points, findings) = cloud(&format!("Points:=[\n{row},\n[1, 2, 3],\n[-4.5, 0, 60]];"));
        assert_eq!(points, ONE_TWO, "{row}");
        assert_eq!(findings, [finding], "{row}");
    }
}

#[test]
fn a_missing_bracket_spoils_no_other_point() {
    let (points, findings) = cloud("Points:=[\n[1, 2, 3,\n[-4.5, 0, 60]];");
    assert_eq!(
        (points, findings),
        (ONE_TWO.to_vec(), vec!["2:2 warning `1, 2, 3,`".to_owned()])
    );
}

#[test]
fn text_of_another_kind_is_told_apart() {
    assert_eq!(cloud(""), (vec![], vec!["error".to_owned()]));
    assert_eq!(
        cloud("Primitive1:=[1 2];").1[0],
        "1:1 error `Primitive1:=[1 2];`"
    );
    let utf_16: Vec<u8> = "Points".encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [&utf_16[..], &[&[0xFF, 0xFE], &utf_16[..]].concat()] {
        let (text, diagnostics) = read_cloud("PC1.txt", bytes);
        assert!(text.cloud.is_empty());
        assert!(diagnostics[0].message.contains("UTF-16"), "{diagnostics:?}");
    }
    let (_, diagnostics) = read_cloud("PC1.txt", b"PK\x03\x04 and so on");
    assert!(diagnostics[0].message.contains("not text"));
    let (_, findings) = lists("Points:=[\n[1, 2, 3]];");
    assert_eq!(findings, ["1:1 error `Points:=[`", "error"]);
}

#[test]
fn thousands_of_like_findings_are_counted_rather_than_listed() {
    let text = format!("Points:=[\n{}[1, 2, 3]];", "[1, 2],\n".repeat(10_000));
    let (text, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    assert_eq!(text.cloud.len(), 1);
    assert_eq!(diagnostics.len(), limits::MAX_SIMILAR_DIAGNOSTICS);
    let last = &diagnostics.last().unwrap().message;
    assert!(
        last.ends_with("; 9992 more like this in the file"),
        "{last}"
    );
}

#[test]
fn too_many_points_are_an_error_and_not_read() {
    let text = format!("Points:=[{}", "[1,2,3],".repeat(limits::MAX_POINTS + 5));
    let (text, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    assert_eq!(text.cloud.len(), limits::MAX_POINTS);
    assert_eq!(diagnostics[0].expected, "at most 10,000,000 points");
}

#[test]
fn headers_may_be_spaced_lack_the_equals_sign_or_be_matlabs() {
    for header in [
        "Primitive7:=[",
        "Primitive7 :=[",
        "Primitive7:[",
        "Primitive7=[",
        "primitive 7 = [",
        "Primitive{7}=[",
    ] {
        let (read, findings) = lists(&format!("{header}3 1 2];\n\n"));
        assert_eq!(
            (read, findings),
            (vec![(7, vec![0, 1, 2])], NONE.to_vec()),
            "{header}"
        );
    }
}

#[test]
fn padded_columns_commas_and_several_lines_are_one_list() {
    for list in [
        "5   261",
        "5, 261",
        "5\n261\n",
        "5 ...\n 261",
        "5;261",
        "\t5\r\n\t261",
        "5.0 2.61e2",
    ] {
        let (read, diagnostics) = read_primitives(
            "PC1_primitives.txt",
            format!("Primitive1:=[{list}];Primitive2:=[1]").as_bytes(),
            &Numbering::of(300),
        );
        assert_eq!(read[0].points, [4, 260], "{list:?}");
        assert_eq!(read[1].points, [0]);
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
    }
}

#[test]
fn several_primitives_may_list_a_point() {
    let (read, findings) = lists("Primitive1:=[1 2];\nPrimitive2:=[2 3];");
    assert_eq!(
        (read, findings),
        (vec![(1, vec![0, 1]), (2, vec![1, 2])], NONE.to_vec())
    );
}

#[test]
fn indices_without_a_point_and_repetitions_are_left_out() {
    let (read, findings) = lists("Primitive1:=[0 2 10 2 -3 4x 99999999999999999999 1.5 9];");
    assert_eq!(read, [(1, vec![1, 8])]);
    assert_eq!(
        findings,
        [
            "1:14 error `0`",
            "1:18 error `10`",
            "1:21 warning 2",
            "1:23 error `-3`",
            "1:26 error `4x`",
            "1:29 error `99999999999999999999`",
            "1:50 error `1.5`",
        ]
    );
}

#[test]
fn a_list_that_is_not_closed_ends_with_the_next() {
    let (read, findings) = lists("Primitive1:=[1 2\nPrimitive2:=[3;\nPrimitive3:=[4 5");
    assert_eq!(read, [(1, vec![0, 1]), (2, vec![2]), (3, vec![3])]);
    assert_eq!(
        findings,
        [
            "2:1 warning `Primitive2:=[3;`",
            "2:15 warning `;`",
            "3:16 error `5`"
        ]
    );
}

#[test]
fn junk_between_entries_is_skipped() {
    let (read, findings) =
        lists("hello\nPrimitive1:=[1];;\n]x Primitive2:=[2];\nPrimitiveX:=[3];\n% end");
    assert_eq!(read, [(1, vec![0]), (2, vec![1])]);
    assert_eq!(
        findings,
        [
            "1:1 warning `hello`",
            "3:2 warning `x Primitive2:=[2];`",
            "4:1 error `PrimitiveX:=[3];`"
        ]
    );
}

#[test]
fn an_empty_list_is_a_primitive_without_points() {
    let (read, findings) = lists("Primitive1:=[];\nPrimitive2:=[1];");
    assert_eq!(read, [(1, vec![]), (2, vec![0])]);
    assert_eq!(findings, ["1:1 warning `Primitive1:=[];`"]);
}

#[test]
fn a_type_written_twice_is_read_once() {
    let (entries, findings) =
        surfaces("Primitive1:=[Plane, [Plane, [1 0 0\n -2]];\nPrimitive2:=[plane, [0 0 1 1]];");
    assert_eq!(findings, ["1:22 note `Plane, [1 0 0`"]);
    assert_eq!(
        entries[0].coefficients,
        Coefficients::Given(vec![1.0, 0.0, 0.0, -2.0])
    );
    assert_eq!(
        (entries[1].number, entries[1].kind),
        (2, Some(SurfaceType::Plane))
    );
}

#[test]
fn a_bspline_has_neither_type_nor_vector() {
    let (entries, findings) = surfaces("Primitive4:=[BSpline, []];\n\n");
    assert_eq!((entries[0].number, entries[0].kind), (4, None));
    assert_eq!(entries[0].coefficients, Coefficients::Malformed);
    assert_eq!(findings, ["1:14 warning `BSpline`"]);
}

#[test]
fn a_vector_that_is_not_as_many_finite_numbers_as_its_type_asks_for_is_malformed() {
    for (vector, finding) in [
        ("Cylinder, [1 1 0 0 0 0 0 0 -37.5]", "1:14 error 9 numbers"),
        ("Plane, [1 2 3 4 5]", "1:14 error 5 numbers"),
        ("Plane, [1 2 NaN 4]", "1:26 error `NaN`"),
        ("Plane, [1 2 1e400 4]", "1:26 error `1e400`"),
        ("Plane, [0 0 -0 0]", "1:14 error"),
        ("Plane, []", "1:14 error 0 numbers"),
        ("[1 2 3 4]", "1:1 error `Primitive1:=[[1 2 3 4]];`"),
    ] {
        let (entries, findings) = surfaces(&format!(
            "Primitive1:=[{vector}];\nPrimitive2:=[Plane, [0 0 1 0]];"
        ));
        assert_eq!(entries[0].coefficients, Coefficients::Malformed, "{vector}");
        assert!(entries[1].coefficients.values().is_some(), "{vector}");
        assert_eq!(findings, [finding], "{vector}");
    }
}

#[test]
fn an_entry_cut_off_by_the_end_of_the_file_is_malformed() {
    let (entries, findings) = surfaces("Primitive1:=[Plane, [0 0 1 3");
    assert_eq!(entries[0].coefficients, Coefficients::Malformed);
    assert_eq!(findings, ["1:29 error the end of the file"]);
}

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
