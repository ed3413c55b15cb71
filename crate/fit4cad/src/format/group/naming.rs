//! Names that tell models and methods apart and are no longer than that takes.

use std::collections::{BTreeMap, BTreeSet};

use super::natural;
use super::placing::{Draft, Owner};
use super::{ModelFiles, PlacedFile};
use crate::format::Role;
use crate::sorting::sort_by;

/// Names the models and orders them and their files.
pub(super) fn name(drafts: Vec<Draft<'_>>) -> Vec<ModelFiles> {
    let labels = set_labels(&drafts);
    let mut named: Vec<(String, String, ModelFiles)> = drafts
        .into_iter()
        .map(|draft| {
            let label = labels.get(&draft.cloud.base).cloned().unwrap_or_default();
            let stem = draft.cloud.stem.clone();
            let model = ModelFiles {
                name: qualified(&label, &stem),
                number: model_number(&stem),
                files: files(draft),
            };
            (stem, label, model)
        })
        .collect();
    sort_by(&mut named, |(a, set_a, _), (b, set_b, _)| {
        // Case never tells models apart within a set, so sets come before it.
        natural::compare(&a.to_lowercase(), &b.to_lowercase())
            .then_with(|| natural::compare(set_a, set_b))
    });
    named.into_iter().map(|(.., model)| model).collect()
}

fn qualified(label: &str, name: &str) -> String {
    if label.is_empty() {
        name.to_owned()
    } else {
        format!("{label}/{name}")
    }
}

/// A label for every set that shares a model's name with another.
fn set_labels<'a>(drafts: &[Draft<'a>]) -> BTreeMap<Vec<&'a str>, String> {
    let mut sets_of: BTreeMap<String, Vec<Vec<&str>>> = BTreeMap::new();
    for draft in drafts {
        sets_of
            .entry(draft.cloud.stem.to_lowercase())
            .or_default()
            .push(draft.cloud.base.clone());
    }
    let colliding: BTreeSet<Vec<&str>> = sets_of
        .into_values()
        .filter(|sets| sets.len() > 1)
        .flatten()
        .collect();
    shortest_suffixes(colliding)
}

/// For each path its last folders, as many as tell it from the others.
fn shortest_suffixes(paths: BTreeSet<Vec<&str>>) -> BTreeMap<Vec<&str>, String> {
    let suffix = |path: &[&str], length: usize| {
        path.get(path.len().saturating_sub(length)..)
            .unwrap_or_default()
            .join("/")
    };
    let deepest = paths.iter().map(Vec::len).max().unwrap_or(0);
    let mut labels = BTreeMap::new();
    let mut open = paths.clone();
    for length in 1..=deepest {
        let mut count: BTreeMap<String, usize> = BTreeMap::new();
        for path in &paths {
            *count.entry(suffix(path, length)).or_default() += 1;
        }
        open.retain(|path| {
            let label = suffix(path, length);
            let unique = count.get(&label) == Some(&1);
            if unique {
                labels.insert(path.clone(), label);
            }
            !unique
        });
        if open.is_empty() {
            break;
        }
    }
    for path in open {
        let label = path.join("/");
        labels.insert(path, label);
    }
    labels
}

/// The number a model's name ends with: 14 for `PC14` and for `training_set/PC14`.
pub fn model_number(name: &str) -> Option<u32> {
    let head = name.trim_end_matches(|character: char| character.is_ascii_digit());
    name.get(head.len()..)?.parse().ok()
}

fn files(draft: Draft<'_>) -> Vec<PlacedFile> {
    let owners = draft.files.keys().map(|(owner, _)| owner);
    let owners: BTreeSet<&Owner<'_>> = owners.chain(draft.pieces.keys()).collect();
    let names = method_names(owners.into_iter());
    let placed = |path: &str, role: Role, owner: Option<&Owner<'_>>| PlacedFile {
        path: path.to_owned(),
        role,
        method: owner.and_then(|owner| names.get(owner).cloned()),
        first: None,
    };
    let clouds = std::iter::once(&draft.cloud.path).chain(&draft.more);
    let mut files: Vec<PlacedFile> = clouds.map(|path| placed(path, Role::Cloud, None)).collect();
    let own = draft.files.iter();
    files.extend(own.map(|((owner, role), path)| placed(path, *role, Some(owner))));
    for (owner, paths) in &draft.pieces {
        let pieces = paths.iter();
        files.extend(pieces.map(|path| placed(path, Role::Primitives, Some(owner))));
    }
    sort_by(&mut files, |a, b| {
        (a.role != Role::Cloud)
            .cmp(&(b.role != Role::Cloud))
            .then_with(|| match (&a.method, &b.method) {
                (Some(a), Some(b)) => natural::compare(a, b),
                (a, b) => a.is_some().cmp(&b.is_some()),
            })
            .then(a.role.cmp(&b.role))
    });
    files
}

/// A name for each method of a model: its own, with folders where two have the same.
fn method_names<'o, 'a: 'o>(
    owners: impl Iterator<Item = &'o Owner<'a>>,
) -> BTreeMap<&'o Owner<'a>, String> {
    let mut by_name: BTreeMap<&str, BTreeMap<Vec<&str>, &Owner<'_>>> = BTreeMap::new();
    for owner in owners {
        if let Owner::Method { name, base } = owner {
            by_name.entry(name).or_default().insert(base.clone(), owner);
        }
    }
    let mut names = BTreeMap::new();
    let mut used = BTreeSet::new();
    for (name, owners) in by_name {
        let labels = match owners.len() {
            1 => BTreeMap::new(),
            _ => shortest_suffixes(owners.keys().cloned().collect()),
        };
        for (base, owner) in owners {
            let mut full = match labels.get(&base) {
                // Named after its folder, which the label holds already.
                Some(label) if base.last() == Some(&name) => label.clone(),
                Some(label) => qualified(label, name),
                None => name.to_owned(),
            };
            while !used.insert(full.clone()) {
                full.push('′');
            }
            names.insert(owner, full);
        }
    }
    names
}
