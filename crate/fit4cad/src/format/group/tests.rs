use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;

use super::*;

mod pieces;

/// Groups paths and writes each model as `name: path role method; …`, for reading.
fn shown(paths: &[&str]) -> Vec<String> {
    shown_with(paths, &BTreeMap::new())
}

fn shown_with(paths: &[&str], overrides: &BTreeMap<String, Override>) -> Vec<String> {
    let grouping = group(paths, overrides);
    grouping
        .models
        .iter()
        .map(|model| {
            let files: Vec<String> = model
                .files
                .iter()
                .map(|file| {
                    let method = file.method.as_deref().unwrap_or("truth");
                    match file.role {
                        Role::Cloud => file.path.clone(),
                        role => format!("{} {role:?} {method}", file.path),
                    }
                })
                .collect();
            format!("{}: {}", model.name, files.join("; "))
        })
        .chain(
            grouping
                .unplaced
                .iter()
                .map(|file| format!("? {}: {}", file.path, file.reason)),
        )
        .collect()
}

#[test]
fn all_files_of_a_set_in_one_folder_are_truth() {
    assert_eq!(
        shown(&[
            "PC1_primitives.txt",
            "PC1.txt",
            "PC1_implicit.txt",
            "PC1_parametric.txt"
        ]),
        ["PC1: PC1.txt; PC1_primitives.txt Primitives truth; \
          PC1_parametric.txt Parametric truth; PC1_implicit.txt Implicit truth"]
    );
}

#[test]
fn types_go_with_what_they_are_of_and_are_clouds_where_there_is_nothing() {
    assert_eq!(
        shown(&[
            "a/PC1.xyz",
            "a/PC1_inst.txt",
            "a/PC1_type.txt",
            "a/Net/PC1_inst.txt",
            "a/Net/PC1_types.npy",
        ]),
        [
            "PC1: a/PC1.xyz; a/PC1_inst.txt Primitives truth; a/PC1_type.txt Types truth; \
          a/Net/PC1_inst.txt Primitives Net; a/Net/PC1_types.npy Types Net"
        ]
    );
    assert_eq!(
        shown(&["bolt_type.xyz", "bolt_type_2.xyz", "type_3/nut.xyz"]),
        [
            "bolt_type: bolt_type.xyz",
            "bolt_type_2: bolt_type_2.xyz",
            "nut: type_3/nut.xyz"
        ]
    );
    assert_eq!(
        shown(&["PC1_inst.txt", "PC1_type.txt"]),
        [
            "? PC1_inst.txt: there is no cloud PC1 for it",
            "? PC1_type.txt: there is no cloud PC1 for it",
        ]
    );
    let types = Override {
        role: Some(Role::Types),
        model: Some("PC1".to_owned()),
        ..Override::default()
    };
    let said = BTreeMap::from([("dump_T.txt".to_owned(), types)]);
    assert_eq!(
        shown_with(&["PC1.xyz", "PC1_labels.txt", "dump_T.txt"], &said),
        ["PC1: PC1.xyz; PC1_labels.txt Primitives truth; dump_T.txt Types truth"]
    );
}

#[test]
fn a_folder_per_role_and_method_names_the_method() {
    assert_eq!(
        shown(&[
            "test_set/pointCloud/PC1.txt",
            "test_set/pointCloud_primitives/PC1_primitives.txt",
            "test_set/pointCloud_primitives_HT/PC1_primitives.txt",
            "test_set/pointCloud_implicit_HT/PC1_implicit.txt",
            "test_set/pointCloud_primitives_PG_v2/PC1_primitives.txt",
        ]),
        ["PC1: test_set/pointCloud/PC1.txt; \
          test_set/pointCloud_primitives/PC1_primitives.txt Primitives truth; \
          test_set/pointCloud_primitives_HT/PC1_primitives.txt Primitives HT; \
          test_set/pointCloud_implicit_HT/PC1_implicit.txt Implicit HT; \
          test_set/pointCloud_primitives_PG_v2/PC1_primitives.txt Primitives PG_v2"]
    );
}

#[test]
fn a_folder_of_results_beside_the_truth_names_its_method() {
    assert_eq!(
        shown(&[
            "set/PC1.txt",
            "set/PC1_primitives.txt",
            "MyMethod/PC1_primitives.txt"
        ]),
        [
            "PC1: set/PC1.txt; set/PC1_primitives.txt Primitives truth; \
          MyMethod/PC1_primitives.txt Primitives MyMethod"
        ]
    );
}

#[test]
fn a_folder_of_role_folders_names_its_method() {
    assert_eq!(
        shown(&[
            "test_set/pointCloud/PC1.txt",
            "test_set/pointCloud_primitives/PC1_primitives.txt",
            "Ours/pointCloud_primitives/PC1_primitives.txt",
        ]),
        ["PC1: test_set/pointCloud/PC1.txt; \
          test_set/pointCloud_primitives/PC1_primitives.txt Primitives truth; \
          Ours/pointCloud_primitives/PC1_primitives.txt Primitives Ours"]
    );
}

#[test]
fn the_method_may_stand_in_the_file_name() {
    for path in [
        "PC1_primitives_RANSAC.txt",
        "PC1_RANSAC_primitives.txt",
        "PC1-RANSAC_primitives.txt",
    ] {
        assert_eq!(
            shown(&["PC1.txt", path]),
            [format!("PC1: PC1.txt; {path} Primitives RANSAC")]
        );
    }
}

#[test]
fn a_name_with_separators_of_its_own_is_divided_where_a_model_is_left() {
    assert_eq!(
        shown(&["my_part-2.txt", "my_part-2_HT_primitives.txt"]),
        ["my_part-2: my_part-2.txt; my_part-2_HT_primitives.txt Primitives HT"]
    );
    assert_eq!(
        shown(&["a.txt", "a_b.txt", "a_b_c_d_primitives.txt"]),
        [
            "a: a.txt",
            "a_b: a_b.txt; a_b_c_d_primitives.txt Primitives c_d"
        ]
    );
}

#[test]
fn a_file_without_a_cloud_says_what_it_was_taken_for() {
    let paths = [
        "a.txt",
        "a_primitives.txt",
        "mine/lab_parametric.txt",
        "PC5-labels-HT.txt",
        "readme.txt",
        "pointCloud_primitives/b_primitives.txt",
    ];
    let grouping = group(&paths, &BTreeMap::new());
    let told: Vec<String> = grouping
        .unplaced
        .iter()
        .map(|file| match &file.recognised {
            Some(Recognised {
                role,
                model,
                method,
            }) => format!("{}: {role:?} of {model} by {method}", file.path),
            None => file.path.clone(),
        })
        .collect();
    assert_eq!(
        told,
        [
            "mine/lab_parametric.txt: Parametric of lab by mine",
            "PC5-labels-HT.txt: Primitives of PC5 by HT",
            "pointCloud_primitives/b_primitives.txt: Primitives of b by submission",
            "readme.txt",
        ]
    );
}

#[test]
fn of_many_clouds_that_a_file_may_belong_to_only_some_are_named() {
    let clouds = (1..=200).map(|set| format!("{set}/PC1.txt"));
    let paths: Vec<String> = clouds.chain(["x/PC1_primitives.txt".to_owned()]).collect();
    let grouping = group(&paths, &BTreeMap::new());
    assert_eq!(
        grouping.unplaced[0].reason,
        "it is unclear to which cloud it belongs: \
         1/PC1.txt or 2/PC1.txt or 3/PC1.txt or one of 197 more"
    );
}

#[test]
fn the_sets_of_the_public_repository_are_kept_apart() {
    let paths = [
        "Fit4CAD-main/README.md",
        "Fit4CAD-main/dataset/.DS_Store",
        "Fit4CAD-main/dataset/training_set/",
        "Fit4CAD-main/dataset/training_set/Icon\r",
        "Fit4CAD-main/dataset/training_set/PC1.txt",
        "Fit4CAD-main/dataset/training_set/PC1_primitives.txt",
        "Fit4CAD-main/dataset/training_set/PC36.txt",
        "Fit4CAD-main/dataset/test_set/pointCloud/PC1.txt",
        "Fit4CAD-main/dataset/test_set/pointCloud_primitives/PC1_primitives.txt",
        "Fit4CAD-main/MATLAB/pointCloud_primitives/PC1_primitives.txt",
        "Fit4CAD-main/MATLAB/pointCloud_primitives_HT/PC1_primitives.txt",
    ];
    assert_eq!(
        shown(&paths),
        [
            "test_set/PC1: Fit4CAD-main/dataset/test_set/pointCloud/PC1.txt; \
             Fit4CAD-main/dataset/test_set/pointCloud_primitives/PC1_primitives.txt Primitives truth; \
             Fit4CAD-main/MATLAB/pointCloud_primitives_HT/PC1_primitives.txt Primitives HT",
            "training_set/PC1: Fit4CAD-main/dataset/training_set/PC1.txt; \
             Fit4CAD-main/dataset/training_set/PC1_primitives.txt Primitives truth",
            "training_set/PC36: Fit4CAD-main/dataset/training_set/PC36.txt",
            "? Fit4CAD-main/MATLAB/pointCloud_primitives/PC1_primitives.txt: \
             Fit4CAD-main/dataset/test_set/pointCloud_primitives/PC1_primitives.txt \
             already gives the same for PC1",
            "? Fit4CAD-main/README.md: a picture, a program or a document",
        ]
    );
    assert_eq!(group(&paths, &BTreeMap::new()).ignored, 2);
}

#[test]
fn a_copy_of_the_clouds_makes_a_set_of_its_own() {
    let names: Vec<String> = group(
        &[
            "a/test_set/pointCloud/PC1.txt",
            "a/MATLAB/pointCloud/PC1.txt",
            "a/MATLAB/pointCloud/PC2.txt",
        ],
        &BTreeMap::new(),
    )
    .models
    .into_iter()
    .map(|model| model.name)
    .collect();
    assert_eq!(names, ["MATLAB/PC1", "test_set/PC1", "MATLAB/PC2"]);
}

#[test]
fn truth_may_lie_in_a_folder_that_says_so() {
    assert_eq!(
        shown(&["clouds/PC1.txt", "GroundTruth/PC1_primitives.txt"]),
        ["PC1: clouds/PC1.txt; GroundTruth/PC1_primitives.txt Primitives truth"]
    );
}

#[test]
fn backslashes_and_case_do_not_matter() {
    assert_eq!(
        shown(&[
            r"C:\Set\POINTCLOUD\pc1.TXT",
            r"C:\Set\pointcloud_PRIMITIVES_HT\PC1_Primitives.txt"
        ]),
        [
            r"pc1: C:\Set\POINTCLOUD\pc1.TXT; C:\Set\pointcloud_PRIMITIVES_HT\PC1_Primitives.txt Primitives HT"
        ]
    );
}

#[test]
fn litter_is_ignored() {
    let litter = [
        ".DS_Store",
        "a/.DS_Store",
        "Icon\r",
        "a/Icon\r",
        "__MACOSX/a/._PC1.txt",
        "Thumbs.db",
        "a/desktop.ini",
        "a/._PC1.txt",
    ];
    let grouping = group(&litter, &BTreeMap::new());
    assert_eq!(
        grouping,
        Grouping {
            ignored: litter.len(),
            ..Grouping::default()
        }
    );
}

#[test]
fn what_has_no_place_is_listed_with_the_reason() {
    assert_eq!(
        shown(&[
            "PC1_primitives.txt",
            "readme.txt",
            "a.zip",
            "script.m",
            "plot.png",
            "boxplot_colors.txt",
            "a.bin",
            "PC2.txt",
            "PC2.txt",
            "pc2.txt"
        ]),
        [
            "PC2: PC2.txt",
            "? a.bin: not of a kind that is read: .txt, .xyz, .xyzn, .xyzrgb, .csv, .tsv, .pts, .asc, \
             .dat, .xyzc, .ply, .pcd, .las, .npz, .npy, .h5, .hdf5, .vg, .obj, .stl, .seg, .labels, .fidx",
            "? a.zip: an archive within; unpack it first",
            "? boxplot_colors.txt: its name is not that of a model's file",
            "? PC1_primitives.txt: there is no cloud PC1 for it",
            "? PC2.txt: the same path was given twice",
            "? pc2.txt: PC2.txt already is the cloud PC2",
            "? plot.png: a picture, a program or a document, as is one more file",
            "? readme.txt: its name is not that of a model's file",
        ]
    );
}

#[test]
fn a_file_that_fits_two_models_is_not_guessed_at() {
    let paths = ["a/PC1.txt", "b/PC1.txt", "c/PC1_primitives.txt"];
    assert_eq!(
        shown(&paths),
        [
            "a/PC1: a/PC1.txt",
            "b/PC1: b/PC1.txt",
            "? c/PC1_primitives.txt: it is unclear to which cloud it belongs: a/PC1.txt or b/PC1.txt",
        ]
    );
    let choice = Override {
        model: Some("b/PC1".to_owned()),
        ..Override::default()
    };
    let overrides = BTreeMap::from([("c/PC1_primitives.txt".to_owned(), choice)]);
    assert_eq!(
        shown_with(&paths, &overrides),
        [
            "a/PC1: a/PC1.txt",
            "b/PC1: b/PC1.txt; c/PC1_primitives.txt Primitives c"
        ]
    );
}

#[test]
fn the_caller_decides_role_model_and_method() {
    let overrides = BTreeMap::from([
        (
            "points.xyz".to_owned(),
            Override {
                role: Some(Role::Cloud),
                model: Some("PC1".to_owned()),
                ..Override::default()
            },
        ),
        (
            "a/labels.txt".to_owned(),
            Override {
                role: Some(Role::Primitives),
                model: Some("PC1".to_owned()),
                method: Some("Net".to_owned()),
                ..Override::default()
            },
        ),
        (
            "a/PC1_primitives.txt".to_owned(),
            Override {
                method: Some(String::new()),
                ..Override::default()
            },
        ),
    ]);
    assert_eq!(
        shown_with(
            &["points.xyz", "a/labels.txt", "a/PC1_primitives.txt"],
            &overrides
        ),
        ["PC1: points.xyz; a/PC1_primitives.txt Primitives truth; a/labels.txt Primitives Net"]
    );
}

#[test]
fn methods_of_the_same_name_keep_their_folders() {
    assert_eq!(
        shown(&[
            "PC1.txt",
            "x/out/PC1_primitives.txt",
            "y/out/PC1_primitives.txt"
        ]),
        ["PC1: PC1.txt; x/out/PC1_primitives.txt Primitives x/out; \
          y/out/PC1_primitives.txt Primitives y/out"]
    );
}

#[test]
fn models_come_in_the_order_people_count() {
    let names: Vec<(String, Option<u32>)> = group(
        &["PC10.txt", "PC2.txt", "PC1.txt", "bracket.txt"],
        &BTreeMap::new(),
    )
    .models
    .into_iter()
    .map(|model| (model.name, model.number))
    .collect();
    let expected = [
        ("bracket", None),
        ("PC1", Some(1)),
        ("PC2", Some(2)),
        ("PC10", Some(10)),
    ];
    assert_eq!(
        names,
        expected.map(|(name, number)| (name.to_owned(), number))
    );
}

#[test]
fn thousands_of_namesakes_are_sorted_quickly() {
    let paths: Vec<String> = (0..4000)
        .flat_map(|n| [format!("a{n}/PC1.txt"), format!("b{n}/PC1_primitives.txt")])
        .collect();
    let grouping = group(&paths, &BTreeMap::new());
    assert_eq!(
        (grouping.models.len(), grouping.unplaced.len()),
        (4000, 4000)
    );
}

/// Paths made of the parts that mean something, joined at random.
fn paths() -> impl Strategy<Value = Vec<String>> {
    let folder = prop::sample::select(vec![
        "",
        "a/",
        "b/",
        "a/b/",
        "pointCloud/",
        "pointCloud_primitives/",
        "a\\pointCloud_primitives_HT/",
        "b/primitives/",
        "truth/",
        "A/",
        "__MACOSX/",
        "pointCloud_HT/",
    ]);
    let name = prop::sample::select(vec![
        "PC1.txt",
        "pc1.txt",
        "PC1_primitives.txt",
        "PC1_PRIMITIVES.txt",
        "PC1_implicit.txt",
        "PC1_HT_primitives.txt",
        "PC1_primitives_HT.txt",
        "PC2.txt",
        "PC10.txt",
        "PC2_parametric.txt",
        "_primitives.txt",
        ".txt",
        "Icon\r",
        "readme.txt",
        "PC1_HT.txt",
        "primitives.txt",
        "",
    ]);
    prop::collection::vec(
        (folder, name).prop_map(|(folder, name)| format!("{folder}{name}")),
        0..24,
    )
}

proptest! {
    #[test]
    fn the_order_of_the_paths_does_not_matter(paths in paths().prop_shuffle()) {
        let shuffled = group(&paths, &BTreeMap::new());
        let mut sorted = paths;
        sorted.sort();
        prop_assert_eq!(shuffled, group(&sorted, &BTreeMap::new()));
    }

    #[test]
    fn every_path_goes_somewhere_once_and_names_are_unique(paths in paths()) {
        let grouping = group(&paths, &BTreeMap::new());
        let placed: usize = grouping.models.iter().map(|model| model.files.len()).sum();
        let folders = paths
            .iter()
            .filter(|path| path.is_empty() || path.ends_with(['/', '\\']))
            .collect::<BTreeSet<_>>()
            .len();
        let twice = paths.len() - paths.iter().collect::<BTreeSet<_>>().len();
        let distinct = placed + grouping.unplaced.len() - twice + grouping.ignored + folders;
        prop_assert_eq!(distinct, paths.len() - twice);
        let names: BTreeSet<&str> = grouping.models.iter().map(|model| &model.name[..]).collect();
        prop_assert_eq!(names.len(), grouping.models.len());
        for model in &grouping.models {
            let slots: BTreeSet<_> = model.files.iter().map(|file| (file.role, &file.method)).collect();
            prop_assert_eq!(slots.len(), model.files.len());
        }
    }
}

#[test]
fn clouds_of_other_kinds_are_models_and_the_benchmarks_own_comes_first() {
    assert_eq!(
        shown(&["a.xyz", "b.CSV", "PC1.asc", "PC1.txt", "a_primitives.txt"]),
        [
            "a: a.xyz; a_primitives.txt Primitives truth",
            "b: b.CSV",
            "PC1: PC1.txt",
            "? PC1.asc: PC1.txt already is the cloud PC1",
        ]
    );
}

#[test]
fn labels_belong_to_the_cloud_of_their_name() {
    assert_eq!(
        shown(&[
            "a.pts",
            "a.seg",
            "b.ply.gz",
            "b_inst.txt",
            "Net/b_labels.npy",
            "HT/b.ply",
            "c.xyz",
            "c_pred.ply",
            "c_gt.xyzc",
            "c_part.ply",
            "d.txt",
            "d.vg",
            "e.npz",
        ]),
        [
            "a: a.pts; a.seg Primitives truth",
            "b: b.ply.gz; b_inst.txt Primitives truth; HT/b.ply Primitives HT; \
             Net/b_labels.npy Primitives Net",
            "c: c.xyz; c_gt.xyzc Primitives truth; c_pred.ply Primitives pred",
            "c_part: c_part.ply",
            "d: d.txt; d.vg Primitives truth",
            "e: e.npz",
        ]
    );
}
