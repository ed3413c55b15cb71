//! Clouds of single primitives.

use super::*;

#[test]
fn clouds_of_single_primitives_are_segments_of_the_cloud_beside_them() {
    let truth = [
        "s/part.txt: s/part.txt; s/Cylinder_0001.txt Primitives truth; s/Plane_0001.txt Primitives truth; \
         s/Plane_0002.txt Primitives truth",
    ];
    let truth = truth.map(|it| it.replacen("s/part.txt", "part", 1));
    let files = [
        "s/part.txt",
        "s/Plane_0002.txt",
        "s/Plane_0001.txt",
        "s/Cylinder_0001.txt",
    ];
    assert_eq!(shown(&files), truth);
    // In a folder of their own they are a method's, unless it says otherwise or is the model's.
    for (folder, method) in [("RANSAC", "RANSAC"), ("gt", "truth"), ("part", "truth")] {
        let file = format!("s/{folder}/part_PLANE_0001_cloud.ply");
        assert_eq!(
            shown(&["s/part.txt", &file]),
            [format!("part: s/part.txt; {file} Primitives {method}")]
        );
    }
    // Of several clouds the one that names or folders tell.
    assert_eq!(
        shown(&[
            "a.txt",
            "b.txt",
            "a_Plane_0001.txt",
            "CC/b/Plane_0001.txt",
            "CC/b/Leftovers.txt",
            "Sphere_0001.txt",
            "b_primitives.txt",
            "b_Cone_0001.txt",
        ]),
        [
            "a: a.txt; a_Plane_0001.txt Primitives truth",
            "b: b.txt; b_primitives.txt Primitives truth; CC/b/Leftovers.txt Primitives CC; \
             CC/b/Plane_0001.txt Primitives CC; b_Cone_0001.txt Primitives submission",
            "? Sphere_0001.txt: it is unclear to which cloud it belongs: a.txt or b.txt",
        ]
    );
}

#[test]
fn clouds_of_single_primitives_without_a_cloud_are_one() {
    assert_eq!(
        shown(&[
            "scan/Plane_0001.txt",
            "scan/Plane_0001.ply",
            "scan/Leftovers.txt",
            "scan/Cone_0001.txt"
        ]),
        [
            "scan: scan/Cone_0001.txt; scan/Leftovers.txt; scan/Plane_0001.txt",
            "? scan/Plane_0001.ply: scan/Plane_0001.txt already gives the same",
        ]
    );
    assert_eq!(
        shown(&[
            "a_Plane_0001.txt",
            "a_Plane_0002.txt",
            "b_Plane_0001.txt",
            "b_Torus_0001.txt",
            "HT/b_labels.txt"
        ]),
        [
            "a: a_Plane_0001.txt; a_Plane_0002.txt",
            "b: b_Plane_0001.txt; b_Torus_0001.txt; HT/b_labels.txt Primitives HT",
        ]
    );
    assert_eq!(
        shown(&["Plane_0001.txt", "Plane_0002.txt"]),
        ["shapes: Plane_0001.txt; Plane_0002.txt"]
    );
}

#[test]
fn models_that_are_only_named_like_single_primitives_stay_models() {
    assert_eq!(shown(&["Plane_0001.txt"]), ["Plane_0001: Plane_0001.txt"]);
    assert_eq!(shown(&["Leftovers.txt"]), ["Leftovers: Leftovers.txt"]);
    assert_eq!(
        shown(&["plane_0001.txt", "plane_0002.txt"]),
        ["plane_0001: plane_0001.txt", "plane_0002: plane_0002.txt"]
    );
    assert_eq!(
        shown(&[
            "Plane_0001.txt",
            "Plane_0002.txt",
            "HT/Plane_0001_primitives.txt",
            "Plane_0002_labels.txt"
        ]),
        [
            "Plane_0001: Plane_0001.txt; HT/Plane_0001_primitives.txt Primitives HT",
            "Plane_0002: Plane_0002.txt; Plane_0002_labels.txt Primitives truth",
        ]
    );
    let said = |role, model: Option<&str>| Override {
        role,
        model: model.map(str::to_owned),
        ..Override::default()
    };
    let overrides = BTreeMap::from([
        ("x/Plane_0001.txt".to_owned(), said(Some(Role::Cloud), None)),
        ("x/Plane_0002.txt".to_owned(), said(None, Some("a"))),
    ]);
    assert_eq!(
        shown_with(
            &["a.txt", "b.txt", "x/Plane_0001.txt", "x/Plane_0002.txt"],
            &overrides
        ),
        [
            "a: a.txt; x/Plane_0002.txt Primitives x",
            "b: b.txt",
            "Plane_0001: x/Plane_0001.txt",
        ]
    );
}
