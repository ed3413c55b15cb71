use super::shown;
use crate::format::{SurfaceEntry, SurfaceFile, read_surfaces};
use crate::model::Coefficients;
use crate::surface::{Form, SurfaceType};

fn surfaces(text: &str) -> (Vec<SurfaceEntry>, Vec<String>) {
    let (file, diagnostics) = read_surfaces("PC1_implicit.txt", text.as_bytes(), Form::Implicit);
    match file {
        SurfaceFile::Entries(entries) => (entries, shown(&diagnostics)),
        SurfaceFile::Absent => (Vec::new(), shown(&diagnostics)),
    }
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
