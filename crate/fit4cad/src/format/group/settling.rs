//! Files that could be clouds or segments: which they are.

use super::clue::Clue;
use super::named::{Named, Places, joined};
use crate::format::Role;

/// Words behind a model's name that make a file its segments.
const OF_A_MODEL: [&str; 7] = [
    "pred",
    "prediction",
    "predicted",
    "result",
    "gt",
    "truth",
    "labelled",
];

/// Makes segments of the files that could be clouds as well and lie beside or below a cloud of their
/// name, or are named after one and what is in them.
pub(super) fn settle(clues: &mut [Clue<'_>]) {
    let is_cloud = |clue: &&Clue<'_>| clue.role == Role::Cloud;
    // The first kind of file of a place is its cloud.
    let mut clouds: Named<usize> = Named::default();
    for clue in clues.iter().filter(is_cloud) {
        let kind = clouds.or_insert(&place_of(&clue.stem.to_lowercase(), &clue.base), clue.kind);
        *kind = clue.kind.min(*kind);
    }
    for clue in clues.iter_mut().filter(|clue| clue.is_open) {
        let stem = clue.stem.to_lowercase();
        let named = stem
            .rsplit_once(['_', '-'])
            .filter(|(_, word)| OF_A_MODEL.contains(word));
        let mut folders = &clue.base[..];
        let beside = clouds.get(&place_of(&stem, folders));
        let mut is_of_another = beside.is_some_and(|&kind| kind < clue.kind)
            || named.is_some_and(|(model, _)| clouds.contains(&place_of(model, folders)));
        while !is_of_another && let Some((_, around)) = folders.split_last() {
            folders = around;
            is_of_another = clouds.contains(&place_of(&stem, folders));
        }
        if is_of_another {
            clue.role = Role::Primitives;
        }
    }
}

/// Makes clouds of the files that are called as types are, where there is nothing that the types could be of: what is in
/// them tells the rest.
pub(super) fn settle_types(clues: &mut [Clue<'_>]) {
    let mut stems = Places::default();
    for clue in clues.iter().filter(|clue| clue.role != Role::Types) {
        stems.give(&clue.stem.to_lowercase());
    }
    for clue in clues {
        if let Some(own) = clue.types
            && stems.get(&clue.stem.to_lowercase()).is_none()
        {
            own.clone_into(&mut clue.stem);
            clue.role = Role::Cloud;
            clue.is_open = true;
        }
    }
}

/// The name of a model in lower case and the folders of its set, as one name.
pub(super) fn place_of(stem: &str, folders: &[&str]) -> String {
    joined(&[stem, &folders.join("/")])
}
