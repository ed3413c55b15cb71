use super::{NONE, shown};
use crate::cloud::Numbering;
use crate::format::read_primitives;

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

#[test]
fn a_cloud_is_told_apart_from_primitives() {
    let (_, findings) = lists("Points:=[\n[1, 2, 3]];");
    assert_eq!(findings, ["1:1 error `Points:=[`", "error"]);
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
fn an_index_cut_short_by_the_end_of_the_file_is_one_finding() {
    let (read, findings) = lists("Primitive1:=[4 5 4");
    assert_eq!(read, [(1, vec![3, 4])]);
    assert_eq!(findings, ["1:18 error `4`"]);
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
