//! Paths: which files make which models, and what models are written as.

use std::collections::{BTreeMap, BTreeSet};

use fit4cad::format::{Layout, Override, Role, file_name, group, model_number, path_of};

use super::MIB;
use crate::{Bytes, Target};

const WORDS: &[&str] = &[
    "PC1",
    "PC10",
    ".txt",
    "_primitives",
    "_parametric",
    "_implicit",
    "pointCloud",
    "pointCloud/",
    "/",
    "\\",
    "\n",
    "..",
    ".",
    "__MACOSX/",
    ".DS_Store",
    "Icon\r",
    "HT",
    "GT",
    "PG",
    "truth",
    "training_set/",
    "test_set/",
    "-",
    "_",
    " ",
    "\0",
    "CON",
    "NUL",
    "COM1",
    ".TXT",
    ".zip",
    "é",
    "\u{202E}",
    "00001",
    "4294967296",
    "99999999999999999999",
    "C:",
    "Plane_0001",
    "PC1_CYLINDER_0002_cloud",
    "Leftovers",
    ".ply",
    "//",
];

pub const GROUP: Target = Target {
    name: "group",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let overrides: BTreeMap<String, Override> = bytes.list(4, corrected).into_iter().collect();
        let text = String::from_utf8_lossy(bytes.rest());
        let mut paths: Vec<&str> = text.split('\n').collect();
        let grouping = group(&paths, &overrides);
        let unique: BTreeSet<&str> = paths.iter().copied().collect();
        let placed = || grouping.models.iter().flat_map(|model| &model.files);
        assert!(placed().count() + grouping.unplaced.len() + grouping.ignored <= paths.len());
        assert!(placed().all(|file| unique.contains(file.path.as_str())));
        let names: BTreeSet<&str> = grouping
            .models
            .iter()
            .map(|model| model.name.as_str())
            .collect();
        assert_eq!(names.len(), grouping.models.len(), "two models of one name");
        paths.reverse();
        assert_eq!(
            group(&paths, &overrides),
            grouping,
            "the order of paths matters"
        );
    },
    seeds: || {
        let lists = [
            "\0PC1.txt\nPC1_primitives.txt\nPC1_parametric.txt\nPC1_implicit.txt\nHT/PC1_primitives.txt",
            "\0a/pointCloud/PC1.txt\na\\pointCloud_primitives_HT/PC1_primitives.txt\na/pointCloud_primitives/PC1_primitives.txt",
            "\0PC10.txt\nPC10_implicit.txt\n__MACOSX/x\nb/PC1.txt\nc/PC1.txt\nc/pointCloud_/PC2-HT-primitives.TXT\n.DS_Store",
            "\0a/Plane_0001.txt\na/Leftovers.txt\na/Cone_0001.ply\nb/PC1.txt\nb/PC1/Plane_0001.txt\nb/HT/PC1_SPHERE_0001_cloud.txt",
            "\u{1}PC1.txt\0\u{1}\u{1}M\0\u{1}HT\0PC1.txt\nPC2.txt",
        ];
        lists.map(|list| list.as_bytes().to_vec()).to_vec()
    },
    words: WORDS,
    longest: 2048,
    floor: MIB / 4,
    quick: 15_000,
};

pub const PATHS: Target = Target {
    name: "paths",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let layout = bytes.one([Layout::TestSet, Layout::Beside]);
        let role = bytes.one(Role::ALL);
        let (model, method) = (bytes.text(), bytes.flag().then(|| bytes.text()));
        model_number(&model);
        let safe = file_name(&model);
        assert_eq!(file_name(&safe), safe);
        let path = path_of(layout, &model, role, method.as_deref());
        for step in path.split('/') {
            assert!(!step.is_empty() && step.len() <= 255 && !step.starts_with('.'));
            assert!(!step.contains(|it: char| it.is_control() || "\\:*?\"<>|".contains(it)));
        }
    },
    seeds: || {
        vec![
            b"\x00\x01PC1\0\x01HT\0".to_vec(),
            b"\x01\x02training_set/PC1\0".to_vec(),
        ]
    },
    words: WORDS,
    longest: 1024,
    floor: MIB / 16,
    quick: 40_000,
};

fn corrected(bytes: &mut Bytes<'_>) -> (String, Override) {
    let path = bytes.text();
    let said = Override {
        role: bytes.flag().then(|| bytes.one(Role::ALL)),
        model: bytes.flag().then(|| bytes.text()),
        method: bytes.flag().then(|| bytes.text()),
        first: bytes.flag().then_some(0),
    };
    (path, said)
}
