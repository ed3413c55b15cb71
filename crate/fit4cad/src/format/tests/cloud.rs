use super::{NONE, shown};
use crate::cloud::Point;
use crate::format::{PointNumber, limits, read_cloud, read_primitives};

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

const ONE_TWO: [[f64; 3]; 2] = [[1.0, 2.0, 3.0], [-4.5, 0.0, 60.0]];

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
