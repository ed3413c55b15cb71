//! Where the files of a model lie: the paths that [`group`](super::group) reads.

use super::Role;
use super::group::names_truth;

/// How files are laid out in folders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// That of the public test set, a folder for each kind of file: `pointCloud/PC1.txt`,
    /// `pointCloud_primitives/PC1_primitives.txt`, `pointCloud_primitives_HT/PC1_primitives.txt`.
    TestSet,
    /// All of a model beside each other, as in the public training set, and a folder for each
    /// method: `PC1.txt`, `PC1_primitives.txt`, `HT/PC1_primitives.txt`.
    Beside,
}

/// Longest name of a file or folder before its ending, in bytes: with it and a folder's prefix
/// below the 255 of most file systems.
const LONGEST: usize = 200;

/// What a name that had to be changed gets around it: `_` before, and `-` with eight digits after.
const ADDED: usize = 10;

/// The path of a model's file, with `/` between folders. The name of a model may tell the set it is
/// of (`training_set/PC1`), which then is a folder around the others. No name leads out of where the
/// path begins, and none is one that a file system forbids: see [`file_name`].
///
/// ```
/// use fit4cad::format::{Layout, Role, path_of};
/// let path = path_of(Layout::TestSet, "training_set/PC1", Role::Implicit, Some("HT"));
/// assert_eq!(path, "training_set/pointCloud_implicit_HT/PC1_implicit.txt");
/// ```
pub fn path_of(layout: Layout, model: &str, role: Role, method: Option<&str>) -> String {
    let mut steps: Vec<String> = steps_of(model).map(file_name).collect();
    let name = steps.pop().unwrap_or_else(|| file_name(""));
    let word = match role {
        Role::Cloud => "",
        Role::Primitives => "_primitives",
        Role::Parametric => "_parametric",
        Role::Implicit => "_implicit",
        Role::Types => "_types",
    };
    // A cloud belongs to no method.
    let method = method.filter(|_| role != Role::Cloud).map(method_name);
    match (layout, method) {
        (Layout::TestSet, None) => steps.push(format!("pointCloud{word}")),
        (Layout::TestSet, Some(method)) => steps.push(format!("pointCloud{word}_{method}")),
        (Layout::Beside, None) => {}
        (Layout::Beside, Some(method)) => steps.push(method),
    }
    steps.push(format!("{name}{word}.txt"));
    steps.join("/")
}

/// A method's name as part of a path: never one that is read as the ground truth.
fn method_name(method: &str) -> String {
    let mut name = file_name(method);
    if names_truth(&name) {
        name.push_str(&format!("-{:08x}", digest(method)));
    }
    name
}

/// What a path is made of, but for steps that go nowhere or up.
fn steps_of(path: &str) -> impl Iterator<Item = &str> {
    let steps = path.split(['/', '\\']);
    steps.filter(|step| !matches!(*step, "" | "." | ".."))
}

/// A name as one of a file or folder that every file system takes. Most names are one already, and
/// stay. In others what separates folders, controls a terminal or is forbidden somewhere becomes `_`,
/// dots at the start and dots and spaces at the end go, and what is too long is cut off; eight digits
/// that stand for the whole name keep it apart from others that would become the same. Never empty;
/// made twice, the same.
///
/// ```
/// use fit4cad::format::file_name;
/// assert_eq!(file_name("PC1"), "PC1");
/// assert!(file_name("a/b").starts_with("a_b-"));
/// assert_ne!(file_name("a/b"), file_name("a:b"));
/// ```
pub fn file_name(name: &str) -> String {
    let forbidden = |character: char| {
        character.is_control()
            || matches!(
                character,
                '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|'
            )
    };
    let allowed = name.len() <= LONGEST && !name.contains(forbidden);
    let whole = !name.starts_with('.') && !name.ends_with(['.', ' ']) && !name.is_empty();
    if allowed && whole && !is_device(name) {
        return name.to_owned();
    }
    let mut end = name.len().min(LONGEST - ADDED);
    while !name.is_char_boundary(end) {
        end -= 1;
    }
    let inner = name.get(..end).unwrap_or_default();
    let inner = inner.trim_start_matches('.').trim_end_matches(['.', ' ']);
    let replaced = inner.chars().map(|it| if forbidden(it) { '_' } else { it });
    let mut safe: String = replaced.collect();
    if safe.is_empty() || is_device(&safe) {
        safe.insert(0, '_');
    }
    safe.push_str(&format!("-{:08x}", digest(name)));
    safe
}

/// A number that hardly any two names share: FNV-1a (Fowler, Noll and Vo).
fn digest(name: &str) -> u32 {
    let mix = |hash: u32, byte: u8| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    name.bytes().fold(0x811c_9dc5, mix)
}

/// Whether Windows takes a name for one of its devices, whatever its ending.
fn is_device(name: &str) -> bool {
    let stem = name
        .split('.')
        .next()
        .unwrap_or_default()
        .to_ascii_uppercase();
    let numbered = |stem: &str| {
        let number = stem
            .strip_prefix("COM")
            .or_else(|| stem.strip_prefix("LPT"));
        number.is_some_and(|rest| matches!(rest.as_bytes(), [b'1'..=b'9']))
    };
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL") || numbered(&stem)
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use proptest::prelude::*;

    use super::super::group;
    use super::*;

    const ROLES: [Role; 5] = [
        Role::Cloud,
        Role::Primitives,
        Role::Parametric,
        Role::Implicit,
        Role::Types,
    ];

    #[test]
    fn both_layouts_are_those_of_the_public_sets() {
        let test = |role, method| path_of(Layout::TestSet, "PC1", role, method);
        assert_eq!(test(Role::Cloud, None), "pointCloud/PC1.txt");
        assert_eq!(
            test(Role::Parametric, None),
            "pointCloud_parametric/PC1_parametric.txt"
        );
        assert_eq!(
            test(Role::Primitives, Some("HT")),
            "pointCloud_primitives_HT/PC1_primitives.txt"
        );
        let beside = |role, method| path_of(Layout::Beside, "sets/PC1", role, method);
        assert_eq!(beside(Role::Cloud, Some("HT")), "sets/PC1.txt");
        assert_eq!(beside(Role::Implicit, None), "sets/PC1_implicit.txt");
        assert_eq!(
            beside(Role::Implicit, Some("HT")),
            "sets/HT/PC1_implicit.txt"
        );
    }

    #[test]
    fn no_method_is_written_as_the_ground_truth() {
        for method in ["GT", "truth", "Ground Truth", "GT0", "gt-2"] {
            for layout in [Layout::TestSet, Layout::Beside] {
                let path = path_of(layout, "PC1", Role::Primitives, Some(method));
                let cloud = path_of(layout, "PC1", Role::Cloud, None);
                let grouping = group(&[cloud, path.clone()], &BTreeMap::new());
                let found = grouping.models[0].files[1].method.as_deref();
                assert!(
                    found.is_some_and(|found| found.starts_with(method)),
                    "{path}: {found:?}"
                );
            }
        }
    }

    #[test]
    fn names_that_are_paths_or_forbidden_become_names() {
        for name in ["flange", "Rücken 1.5", "COM10", "conical", "a-b_c"] {
            assert_eq!(file_name(name), name);
        }
        let changed = [
            ("", "_-"),
            ("..", "_-"),
            (".hidden", "hidden-"),
            ("a/b\\c:d", "a_b_c_d-"),
            ("what?*\"<>|", "what______-"),
            ("line\nend\u{7f}\0", "line_end__-"),
            ("dots. .", "dots-"),
            ("nul", "_nul-"),
            ("COM1.old", "_COM1.old-"),
        ];
        let mut seen = BTreeSet::new();
        for (name, start) in changed {
            let safe = file_name(name);
            assert!(safe.starts_with(start), "{name:?}: {safe}");
            assert_eq!(file_name(&safe), safe);
            assert!(seen.insert(safe), "{name:?}");
        }
        assert_ne!(file_name("a:b"), file_name("a?b"));
        let long = |last: char| "ä".repeat(500) + &last.to_string();
        assert_ne!(file_name(&long('x')), file_name(&long('y')));
        assert!(file_name(&long('x')).len() <= LONGEST);
    }

    #[test]
    fn a_name_made_safe_stays_as_it_is() {
        for length in 150..260 {
            for name in [
                "a".repeat(length),
                "ä:".repeat(length),
                "a".repeat(length) + "\u{85}",
                format!("NUL.{}", "b".repeat(length)),
            ] {
                let safe = file_name(&name);
                assert!(safe.len() <= LONGEST, "{} bytes", safe.len());
                assert_eq!(file_name(&safe), safe);
            }
        }
    }

    proptest! {
        /// What is written is found again: model, role and method, under the names that paths can
        /// have.
        #[test]
        fn grouping_reads_what_paths_say(
            model in "[A-Za-z]{1,6}[0-9]{1,3}",
            method in "[A-Z][a-z]{0,5}[0-9]",
            test_set: bool,
        ) {
            let layout = if test_set { Layout::TestSet } else { Layout::Beside };
            let truth = ROLES.map(|role| (role, None));
            let found = [Role::Primitives, Role::Parametric, Role::Implicit, Role::Types];
            let (model, method) = (file_name(&model), method_name(&method));
            let found = found.map(|role| (role, Some(method.as_str())));
            let files: Vec<_> = truth.into_iter().chain(found).collect();
            let path = |&(role, method): &(Role, Option<&str>)| path_of(layout, &model, role, method);
            let paths: Vec<String> = files.iter().map(path).collect();
            let grouping = group(&paths, &BTreeMap::new());
            prop_assert_eq!(grouping.unplaced.len(), 0);
            prop_assert_eq!(grouping.models.len(), 1);
            prop_assert_eq!(&grouping.models[0].name, &model);
            let placed = grouping.models[0].files.iter();
            let placed: Vec<_> = placed.map(|file| (file.role, file.method.as_deref())).collect();
            prop_assert_eq!(placed, files);
        }

        #[test]
        fn no_path_leads_out_or_names_what_is_forbidden(model in any::<String>(), method in any::<String>()) {
            for layout in [Layout::TestSet, Layout::Beside] {
                for role in ROLES {
                    let path = path_of(layout, &model, role, Some(&method));
                    for step in path.split('/') {
                        prop_assert!(!step.is_empty() && step.len() <= 255 && !step.starts_with('.'));
                        prop_assert!(!step.contains(['\\', ':', '\0', '\n']) && !step.ends_with([' ', '.']));
                    }
                }
            }
        }
    }
}
