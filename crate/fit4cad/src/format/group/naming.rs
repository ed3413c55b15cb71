//! Names that tell models and methods apart and are no longer than that takes.

use super::named::{Named, Places};
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
            let label = labels.get(&draft.cloud.home()).cloned().unwrap_or_default();
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

/// A label for every set that shares a model's name with another, by its folders.
fn set_labels(drafts: &[Draft<'_>]) -> Named<String> {
    let mut sets_of: Named<Vec<&[&str]>> = Named::default();
    for draft in drafts {
        let sets = sets_of.or_insert(&draft.cloud.stem.to_lowercase(), Vec::new());
        sets.push(&draft.cloud.base);
    }
    let mut colliding: Named<&[&str]> = Named::default();
    for &set in sets_of.iter().filter(|sets| sets.len() > 1).flatten() {
        colliding.or_insert(&set.join("/"), set);
    }
    let colliding: Vec<&[&str]> = colliding.iter().copied().collect();
    let mut labels = Named::default();
    for (set, label) in colliding.iter().zip(shortest_suffixes(&colliding)) {
        labels.or_insert(&set.join("/"), label);
    }
    labels
}

/// For each of different paths its last folders, as many as tell it from the others.
fn shortest_suffixes(paths: &[&[&str]]) -> Vec<String> {
    let suffix = |path: &[&str], length: usize| {
        let folders = path.get(path.len().saturating_sub(length)..);
        folders.unwrap_or_default().join("/")
    };
    let deepest = paths.iter().map(|path| path.len()).max().unwrap_or(0);
    let mut labels: Vec<Option<String>> = vec![None; paths.len()];
    for length in 1..=deepest {
        let mut count: Named<usize> = Named::default();
        for path in paths {
            *count.or_insert(&suffix(path, length), 0) += 1;
        }
        for (path, label) in paths.iter().zip(&mut labels) {
            let own = suffix(path, length);
            if label.is_none() && count.get(&own) == Some(&1) {
                *label = Some(own);
            }
        }
        if labels.iter().all(Option::is_some) {
            break;
        }
    }
    let labelled = labels.into_iter().zip(paths);
    labelled
        .map(|(label, path)| label.unwrap_or_else(|| path.join("/")))
        .collect()
}

/// The number a model's name ends with: 14 for `PC14` and for `training_set/PC14`.
pub fn model_number(name: &str) -> Option<u32> {
    let head = name.trim_end_matches(|character: char| character.is_ascii_digit());
    name.get(head.len()..)?.parse().ok()
}

fn files(draft: Draft<'_>) -> Vec<PlacedFile> {
    let mut owners = Named::default();
    let of_files = draft.files.iter().map(|file| &file.owner);
    for owner in of_files.chain(draft.pieces.iter().map(|(owner, _)| owner)) {
        owners.or_insert(&owner.key(), owner);
    }
    let names = method_names(owners);
    let placed = |path: &str, role: Role, owner: Option<&Owner<'_>>| PlacedFile {
        path: path.to_owned(),
        role,
        method: owner.and_then(|owner| names.get(&owner.key()).cloned()),
        first: None,
    };
    let clouds = std::iter::once(&draft.cloud.path).chain(&draft.more);
    let mut files: Vec<PlacedFile> = clouds.map(|path| placed(path, Role::Cloud, None)).collect();
    let own = draft.files.iter();
    files.extend(own.map(|file| placed(file.path, file.role, Some(&file.owner))));
    for (owner, paths) in draft.pieces.iter() {
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

/// A name for each method of a model, by whose it is: its own, with folders where two have the same.
fn method_names(owners: Named<&Owner<'_>>) -> Named<String> {
    let mut by_name: Named<(&str, Vec<&Owner<'_>>)> = Named::default();
    for owner in owners.in_order() {
        if let Owner::Method { name, .. } = owner {
            by_name.or_insert(name, (name, Vec::new())).1.push(owner);
        }
    }
    let mut names = Named::default();
    let mut used = Places::default();
    for (name, owners) in by_name.in_order() {
        let bases: Vec<&[&str]> = owners.iter().map(|owner| owner.base()).collect();
        let labels = match bases.len() {
            1 => vec![String::new()],
            _ => shortest_suffixes(&bases),
        };
        for (owner, label) in owners.into_iter().zip(labels) {
            // Named after its folder, which the label holds already.
            let mut full = match owner.base().last() {
                Some(&folder) if folder == name && !label.is_empty() => label,
                _ => qualified(&label, name),
            };
            while used.get(&full).is_some() {
                full.push('′');
            }
            used.give(&full);
            names.or_insert(&owner.key(), full);
        }
    }
    names
}
