use crate::cloud::Point;
use crate::diagnostics::{Diagnostic, Severity};
use crate::format::{Role, SourceFile, read_model};
use crate::model::{Model, Segmentation};
use crate::surface::SurfaceType;

/// Points of a corner of three faces, by face, on no lattice.
fn faces() -> [Vec<Point>; 3] {
    let face = |face: usize| {
        let points = (0..150).map(|i| {
            let (u, v) = (f64::from(i % 15) / 15.0, f64::from(i / 15) / 10.0);
            // Differently far apart everywhere, so that no part looks like another moved.
            let (u, v) = (u + 0.03 * u * v + 0.001, v + 0.05 * u * u + 0.002);
            match face {
                0 => Point::new(u, v, 0.0),
                1 => Point::new(u, 0.0, v),
                _ => Point::new(0.0, u, v),
            }
        });
        points.collect()
    };
    [face(0), face(1), face(2)]
}

fn all() -> Vec<Point> {
    faces().into_iter().flatten().collect()
}

const KINDS: [&str; 3] = [
    "Plane_0001.txt",
    "Cylinder_0001.txt",
    "PLANE_0002_cloud.txt",
];

fn rows<'p>(
    points: impl IntoIterator<Item = &'p Point>,
    write: impl Fn(&Point) -> String,
) -> String {
    points
        .into_iter()
        .map(|point| write(point) + "\n")
        .collect()
}

fn whole(point: &Point) -> String {
    format!("{} {} {}", point.x, point.y, point.z)
}

/// As single precision leaves it, moved first.
fn single(point: &Point, shift: [f64; 3]) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| (point[axis] + shift[axis]) as f32);
    format!("{x} {y} {z}")
}

fn read(files: &[(&str, Role, Option<&str>, String)]) -> (Model, Vec<Diagnostic>) {
    let sources = files.iter().map(|(path, role, method, text)| SourceFile {
        path,
        role: *role,
        method: *method,
        bytes: text.as_bytes(),
    });
    read_model("part", &sources.collect::<Vec<_>>())
}

fn pieces(shift: [f64; 3], extra: &str) -> Vec<(&'static str, Role, Option<&'static str>, String)> {
    let texts = faces().map(|points| rows(&points, |point| single(point, shift)));
    let files = KINDS.into_iter().zip(texts);
    files
        .map(|(path, text)| (path, Role::Primitives, Some("CC"), text + extra))
        .collect()
}

fn told(segmentation: &Segmentation) -> Vec<(u32, Option<SurfaceType>, Vec<u32>)> {
    let primitives = segmentation.primitives.iter();
    primitives
        .map(|it| (it.number, it.kind, it.points.clone()))
        .collect()
}

fn expected() -> Vec<(u32, Option<SurfaceType>, Vec<u32>)> {
    vec![
        (1, Some(SurfaceType::Plane), (0..150).collect()),
        (2, Some(SurfaceType::Cylinder), (150..300).collect()),
        (3, Some(SurfaceType::Plane), (300..450).collect()),
    ]
}

#[test]
fn points_in_single_precision_are_found_again_with_the_types_of_their_names() {
    let cloud = rows(&all(), whole);
    let mut files = vec![("part.txt", Role::Cloud, None, cloud)];
    files.extend(pieces([0.0; 3], ""));
    // What was left over belongs to none.
    files.push((
        "Leftovers.txt",
        Role::Primitives,
        Some("CC"),
        "0.5 0.5 0\n".to_owned(),
    ));
    let (model, findings) = read(&files);
    assert_eq!(
        told(&model.submissions[0].segmentation),
        expected(),
        "{findings:?}"
    );
    assert!(findings.is_empty(), "{findings:?}");
    assert!(model.truth.is_none());
}

#[test]
fn a_shift_of_all_points_is_found_from_the_data() {
    let far = [412_345.25, 5_412_345.5, 120.0];
    let moved: Vec<Point> = all()
        .iter()
        .map(|point| point + crate::cloud::Vector::from(far))
        .collect();
    let mut files = vec![("part.txt", Role::Cloud, None, rows(&moved, whole))];
    files.extend(pieces([0.0, 0.0, 0.0], ""));
    let (model, findings) = read(&files);
    assert_eq!(
        told(&model.submissions[0].segmentation),
        expected(),
        "{findings:?}"
    );
    let [note] = &findings[..] else {
        panic!("{findings:?}")
    };
    assert_eq!(note.severity, Severity::Note);
    let by: Vec<f64> = note.found[3..]
        .split(", ")
        .map(|it| it.parse().unwrap())
        .collect();
    for (found, far) in by.iter().zip(far) {
        assert!((found + far).abs() < 1e-6, "{}", note.found);
    }
    // Moved back before it was saved, it is where the cloud is, up to what was lost near the origin.
    let back = |point: &Point| {
        let [x, y, z] = [0, 1, 2].map(|axis| f64::from(point[axis] as f32) + far[axis]);
        format!("{x:.8} {y:.8} {z:.8}")
    };
    let texts = faces().map(|points| rows(&points, back));
    files.truncate(1);
    files.extend(
        KINDS
            .into_iter()
            .zip(texts)
            .map(|(path, text)| (path, Role::Primitives, None, text)),
    );
    let (model, findings) = read(&files);
    assert_eq!(told(&model.truth.unwrap()), expected());
    assert!(findings.is_empty(), "{findings:?}");
}

#[test]
fn points_of_several_files_are_members_of_each_and_points_of_none_are_told_once() {
    let cloud = rows(&all(), whole);
    let mut files = vec![("part.txt", Role::Cloud, None, cloud)];
    // In each the first point of the cloud, and one that is in no cloud.
    let first = single(&faces()[0][0], [0.0; 3]);
    files.extend(pieces([0.0; 3], &format!("{first}\n7 7 7\n")));
    let (model, findings) = read(&files);
    let found = told(&model.submissions[0].segmentation);
    assert_eq!(
        found[1].2,
        [0].into_iter().chain(150..300).collect::<Vec<u32>>()
    );
    assert_eq!(
        found[2].2,
        [0].into_iter().chain(300..450).collect::<Vec<u32>>()
    );
    let [one] = &findings[..] else {
        panic!("{findings:?}")
    };
    assert_eq!(one.found, "3 of 456, the first in Plane_0001.txt");
}

#[test]
fn twins_in_the_cloud_are_both_members() {
    let [a, b, _] = faces();
    let cloud = rows(a.iter().chain(&b).chain(&a[..5]), whole);
    let mut files = vec![("part.txt", Role::Cloud, None, cloud)];
    files.extend(pieces([0.0; 3], "").into_iter().take(2));
    let (model, _) = read(&files);
    let found = told(&model.submissions[0].segmentation);
    assert_eq!(found[0].2, (0..150).chain(300..305).collect::<Vec<u32>>());
}

#[test]
fn files_of_another_cloud_are_an_error_that_names_how_many() {
    let cloud = "0 0 0\n1 5 0\n7 1 3\n9 9 9\n".repeat(30);
    let mut files = vec![("part.txt", Role::Cloud, None, cloud)];
    files.extend(pieces([0.0; 3], ""));
    let (model, findings) = read(&files);
    assert!(model.submissions.is_empty());
    let [one] = &findings[..] else {
        panic!("{findings:?}")
    };
    assert_eq!(
        (one.severity, one.found.as_str()),
        (Severity::Error, "3 files of 450 points, 120 in the cloud")
    );
}

#[test]
fn without_a_cloud_the_files_are_one_in_their_order() {
    let [a, b, c] = faces().map(|points| rows(&points, whole));
    let files = [
        ("x/Cylinder_0001.txt", Role::Cloud, None, a),
        (
            "x/Leftovers.txt",
            Role::Cloud,
            None,
            "5 5 5\nnan 1 1\n6 6 6\n".to_owned(),
        ),
        ("x/Plane_0001.txt", Role::Cloud, None, b),
        ("x/Plane_0002.txt", Role::Cloud, None, c),
    ];
    let (model, findings) = read(&files);
    assert_eq!(model.cloud.len(), 452);
    // A row that cannot be read keeps its number.
    assert_eq!(model.cloud.numbering().rows(), 453);
    assert_eq!(model.cloud.numbering().number(152), 154);
    let found = told(&model.truth.unwrap());
    let kinds = [
        SurfaceType::Cylinder,
        SurfaceType::Plane,
        SurfaceType::Plane,
    ]
    .map(Some);
    assert_eq!(found.iter().map(|it| it.1).collect::<Vec<_>>(), kinds);
    let ends: Vec<(u32, u32)> = found.iter().map(|it| (it.2[0], it.2[149])).collect();
    assert_eq!(ends, [(0, 149), (152, 301), (302, 451)]);
    let [one] = &findings[..] else {
        panic!("{findings:?}")
    };
    assert_eq!(one.file, "x/Leftovers.txt");
}
