use super::{NONE, shown};
use crate::cloud::{Point, PointNumber};
use crate::format::{CloudFile, Segment, limits, read_cloud, read_primitives};

fn cloud(text: &str) -> (Vec<[f64; 3]>, Vec<String>) {
    let (text, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    (points_of(&text), shown(&diagnostics))
}

fn points_of(file: &CloudFile) -> Vec<[f64; 3]> {
    let points = file.cloud.points().iter();
    points.map(|&point| point.into()).collect()
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
fn rows_are_read_whatever_separates_them() {
    for text in [
        "1 2 3\n-4.5 0 60\n",
        "  1   2 3\n\n -4.5 0  6e1",
        "1\t2\t3\r\n-4.5\t0\t60\r\n",
        "1,2,3\n-4.5,0,60\n",
        "1, 2, 3\r-4.5, 0, 60\r",
        "1;2;3\n-4.5;0;60\n",
        "1,0;2,0;3,0\n-4,5;0;60\n",
        "1,0 2,0 3,0\n-4,5 0,0 60,0\n",
        "\"1\",\"2\",\"3\"\n\"-4.5\",\"0\",\"60\"\n",
        "(1, 2, 3)\n(-4.5, 0, 60)\n",
        "{1 2 3}\n{-4.5 0 60}\n",
        "1 2 3;\n-4.5 0 60;\n",
        "2\n1 2 3\n-4.5 0 60\n",
        "# from a scanner\n1 2 3 # first\n// between\n-4.5 0 60\n",
        "x y z\n1 2 3\n-4.5 0 60\n",
        "//X,Y,Z\n1,2,3\n-4.5,0,60\n",
        "\"Points:0\";\"Points:1\";\"Points:2\"\n1;2;3\n-4.5;0;60\n",
        "y,x,z\n2,1,3\n0,-4.5,60\n",
        "Y [m],X [m],Z [m]\n2,1,3\n0,-4.5,60\n",
        "Y [m]\tX [m]\tZ [m]\n2\t1\t3\n0\t-4.5\t60\n",
        "1|2|3\n-4.5|0|60\n",
        "y | x | z\n2 | 1 | 3\n0 | -4.5 | 60\n",
    ] {
        assert_eq!(cloud(text), (ONE_TWO.to_vec(), NONE.to_vec()), "{text:?}");
        let utf_16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        for bytes in [&utf_16[..], &[&[0xFF, 0xFE], &utf_16[..]].concat()] {
            let (read, findings) = read_cloud("a.xyz", bytes);
            assert_eq!(
                (points_of(&read), findings),
                (ONE_TWO.to_vec(), vec![]),
                "{text:?}"
            );
        }
    }
}

#[test]
fn columns_beside_the_coordinates_are_told_and_the_labels_among_them_kept() {
    let rows = |row: fn(i32) -> String| (0..40).map(row).collect::<Vec<_>>().join("\n");
    let named = rows(|i| format!("{i},0,1,{},0,0", i / 20));
    for (text, labels, found) in [
        (
            rows(|i| format!("{i} 0 1 {}.000000", i / 10)),
            [0, 3],
            "labels in 4",
        ),
        (
            rows(|i| format!("{i} 0 1 {}", i * 7 % 40)),
            [9, 9],
            "something not used in 4",
        ),
        (
            format!("x,y,z,label,nx,ny\n{named}"),
            [0, 1],
            "labels in 4, normals in 5 to 6",
        ),
        (
            rows(|i| format!("{i} 0 1 0.6 0.8 0 255 0 {i} {}", i / 10 - 1)),
            [-1, 2],
            "normals in 4 to 6, colours in 7 to 9, labels in 10",
        ),
    ] {
        let (read, diagnostics) = read_cloud("a.xyz", text.as_bytes());
        assert_eq!(read.cloud.len(), 40);
        assert_eq!(diagnostics.len(), 1, "{diagnostics:?}");
        assert_eq!(diagnostics[0].found, found);
        let of = |segments: &[Segment], index: u32| {
            let segment = segments.iter().find(|it| it.points.contains(&index));
            segment.map_or(-1, |segment| segment.number as i32)
        };
        let ends = read
            .segments
            .map(|segments| [of(&segments, 0), of(&segments, 39)]);
        assert_eq!(ends, (labels != [9, 9]).then_some(labels), "{found}");
    }
    let one = rows(|i| format!("{i} 0 1 0.000000"));
    let (read, _) = read_cloud("a.xyzc", one.as_bytes());
    let segments = read.segments.unwrap();
    assert_eq!((segments.len(), segments[0].points.len()), (1, 40));
}

#[test]
fn what_is_wrong_with_rows_is_one_finding_and_rows_keep_their_numbers() {
    let rows: String = (0..50)
        .map(|i| match i % 5 {
            1 => "nan nan nan\n".to_owned(),
            3 => format!("{i} x 0\n"),
            _ => format!("{i} 0 0\n"),
        })
        .collect();
    let (read, diagnostics) = read_cloud("a.xyz", format!("x y z\n{rows}the end\n").as_bytes());
    assert_eq!(
        shown(&diagnostics),
        ["3:1 error `nan`", "52:1 warning `the end`"]
    );
    assert_eq!(
        diagnostics[0].message,
        "A point could not be read (20 of 50 rows, this is the first)"
    );
    assert_eq!(read.cloud.numbering().rows(), 50);
    assert_eq!(read.cloud.numbering().number(3), 6);
    let (read, diagnostics) = read_cloud("a.pts", b"3\n1 2 3\n4 5 6\n7 8\n1e31 0 0\n");
    assert_eq!(read.cloud.len(), 2);
    let found: Vec<&str> = diagnostics.iter().map(|it| &it.found[..]).collect();
    assert_eq!(found, ["2 numbers", "`1e31 0 0`", "3 said, 4 found"]);
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
    let read = read.cloud;
    assert_eq!(read.points()[1], Point::new(-4.5, 0.0, 60.0));
    assert_eq!(shown(&diagnostics), ["3:5 error `x`"]);
    assert_eq!(read.numbering().rows(), 3);
    assert_eq!(read.numbering().resolve(1), PointNumber::Index(0));
    assert_eq!(read.numbering().resolve(2), PointNumber::Broken);
    assert_eq!(read.numbering().resolve(3), PointNumber::Index(1));
    assert_eq!(read.numbering().resolve(0), PointNumber::Outside);
    assert_eq!(read.numbering().resolve(4), PointNumber::Outside);
    let (lists, findings) = read_primitives(
        "PC1_primitives.txt",
        b"Primitive1:=[1 2 3];",
        read.numbering(),
    );
    assert_eq!(lists[0].points, [0, 1]);
    assert_eq!(shown(&findings), ["1:16 warning 2"]);
}

#[test]
fn a_count_before_the_first_point_takes_no_number() {
    for text in [
        "2\n1 2 3\n-4.5 0 60\n",
        "2 \r\n[1, 2, 3]\r\n[-4.5, 0, 60]",
        "Points:=[\n2\n[1, 2, 3],\n[-4.5, 0, 60]];",
    ] {
        assert_eq!(cloud(text).0, ONE_TWO, "{text}");
        let (read, _) = read_cloud("PC1.txt", text.as_bytes());
        assert_eq!(read.cloud.numbering().rows(), 2, "{text}");
    }
    // After the first point it is a row that lacks two numbers.
    let (read, _) = read_cloud("PC1.txt", b"1 2 3\n2\n-4.5 0 60\n");
    assert_eq!(read.cloud.numbering().number(1), 3);
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
    let (_, diagnostics) = read_cloud("PC1.txt", b"PK\x03\x04 and so on");
    assert!(diagnostics[0].message.contains("not text"));
}

#[test]
fn thousands_of_like_findings_are_counted_rather_than_listed() {
    let text = format!("Points:=[\n{}[1, 2, 3]];", "[1, 2],\n".repeat(10_000));
    let (read, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    assert_eq!(read.cloud.len(), 1);
    assert_eq!(diagnostics.len(), 1);
    assert_eq!(
        diagnostics[0].message,
        "A point could not be read (10000 of 10001 rows, this is the first)"
    );
}

#[test]
fn too_many_points_are_an_error_and_not_read() {
    let text = format!("Points:=[{}", "[1,2,3],".repeat(limits::MAX_POINTS + 5));
    let (text, diagnostics) = read_cloud("PC1.txt", text.as_bytes());
    assert_eq!(text.cloud.len(), limits::MAX_POINTS);
    assert_eq!(diagnostics[0].expected, "at most 10,000,000 points");
}
