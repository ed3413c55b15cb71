//! Which points belong together, in forms other than the benchmark's.

use super::shown;
use crate::format::{Role, SourceFile, read_model};

/// Three faces of a cube, 16 points each, a label for each face.
fn rows() -> Vec<([f64; 3], i32)> {
    (0..48)
        .map(|i: i32| {
            let (u, v) = (f64::from(i % 4) + 0.5, f64::from(i / 4 % 4) + 0.5);
            match i / 16 {
                0 => ([u, v, 0.0], 0),
                1 => ([u, 0.0, v], 1),
                _ => ([0.0, u, v], 7),
            }
        })
        .collect()
}

fn xyz(labels: bool) -> String {
    let line = |&([x, y, z], label): &([f64; 3], i32)| match labels {
        true => format!("{x} {y} {z} {label}\n"),
        false => format!("{x} {y} {z}\n"),
    };
    rows().iter().map(line).collect()
}

/// Number and size of each primitive.
type Sizes = Vec<(u32, usize)>;

/// What is found of the truth and of a method: number and size of each primitive.
fn read(cloud: &str, truth: Option<&str>, method: Option<&str>) -> (Sizes, Sizes, Vec<String>) {
    let mut files = vec![("PC1.xyz", Role::Cloud, None, cloud)];
    files.extend(truth.map(|text| ("PC1_labels.txt", Role::Primitives, None, text)));
    files.extend(method.map(|text| ("Net/PC1.seg", Role::Primitives, Some("Net"), text)));
    let files: Vec<SourceFile<'_>> = files
        .iter()
        .map(|&(path, role, method, text)| SourceFile {
            path,
            role,
            method,
            bytes: text.as_bytes(),
        })
        .collect();
    let (model, diagnostics) = read_model("PC1", &files);
    let sizes = |segmentation: Option<&crate::model::Segmentation>| {
        let primitives = segmentation.iter().flat_map(|it| &it.primitives);
        primitives.map(|it| (it.number, it.points.len())).collect()
    };
    let submission = model.submissions.first().map(|it| &it.segmentation);
    (
        sizes(model.truth.as_ref()),
        sizes(submission),
        shown(&diagnostics),
    )
}

const FACES: [(u32, usize); 3] = [(0, 16), (1, 16), (7, 16)];

#[test]
fn a_column_of_labels_is_the_truth_and_a_sidecar_overrides_it() {
    let (truth, _, findings) = read(&xyz(true), None, None);
    assert_eq!(truth, FACES);
    assert_eq!(findings, ["1:1 note labels in 4"]);
    let (truth, _, _) = read(&xyz(true), Some(&"3\n".repeat(48)), None);
    assert_eq!(truth, [(3, 48)]);
}

#[test]
fn a_label_a_line_is_read_as_truth_and_as_result() {
    let labels: Vec<String> = rows().iter().map(|(_, label)| label.to_string()).collect();
    let joined = labels.join("\r\n");
    for text in [
        joined.clone(),
        format!("48\n{joined}"),
        format!("label\n{joined}\n"),
        format!("# of a network\n{}", labels.join(".0\n")),
        labels.join("\n") + "\n",
    ] {
        let (truth, found, findings) = read(&xyz(false), Some(&text), Some(&text));
        assert_eq!((truth, found), (FACES.to_vec(), FACES.to_vec()), "{text}");
        assert!(findings.is_empty(), "{findings:?}");
    }
    // -1 belongs to none, and what is no label is one finding.
    let (truth, _, findings) = read(
        &xyz(false),
        Some(&("-1\nx\n2.5\n".to_owned() + &"4\n".repeat(45))),
        None,
    );
    assert_eq!(
        (truth, findings),
        (vec![(4, 45)], vec!["2:1 warning x".to_owned()])
    );
    let (truth, _, findings) = read(&xyz(false), Some("1\n2\n3\n"), None);
    assert_eq!(
        (truth, findings),
        (vec![], vec!["error 3 labels for 48 rows".to_owned()])
    );
}

#[test]
fn labels_are_of_rows_also_where_some_are_broken() {
    let cloud = format!("nan nan nan\n{}", xyz(false));
    let labels: String = rows()
        .iter()
        .map(|(_, label)| format!("{label}\n"))
        .collect();
    let (truth, _, _) = read(&cloud, Some(&format!("5\n{labels}")), None);
    assert_eq!(truth, FACES);
}

#[test]
fn a_labelled_cloud_is_a_result_by_its_rows_or_by_where_its_points_are() {
    let (_, found, _) = read(&xyz(false), None, Some(&xyz(true)));
    assert_eq!(found, FACES);
    // Another order, in single precision, without a face.
    let moved: String = rows()
        .iter()
        .rev()
        .filter(|(_, label)| *label != 1)
        .map(|([x, y, z], label)| format!("{} {} {} {label}\n", *x as f32, *y as f32, *z as f32))
        .collect();
    let (_, found, findings) = read(&xyz(false), None, Some(&moved));
    assert_eq!(found, [(0, 16), (7, 16)], "{findings:?}");
    let elsewhere: String = rows()
        .iter()
        .map(|([x, y, z], label)| format!("{} {y} {z} {label}\n", x + 20.0))
        .collect();
    let (_, found, findings) = read(&xyz(false), None, Some(&elsewhere));
    assert_eq!(found, []);
    assert_eq!(findings.last().unwrap(), "error 48 points, 48 in the cloud");
    // A name that tells nothing leaves it to the values, another does not.
    let (_, found, _) = read(&xyz(false), None, Some(&format!("x y z w\n{}", xyz(true))));
    assert_eq!(found, FACES);
    let other = format!("x y z intensity\n{}", xyz(true));
    let (_, _, findings) = read(&xyz(false), None, Some(&other));
    assert_eq!(findings.last().unwrap(), "error 48 points");
}
