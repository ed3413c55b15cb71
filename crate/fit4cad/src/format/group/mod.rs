//! From a heap of paths to models: which file is what, of which model, by which method.

mod clue;
mod named;
mod naming;
mod natural;
mod pieces;
mod placing;
mod settling;

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

pub(super) use clue::names_truth;
pub use clue::role_in_name;
use clue::{Clue, Sorted};
pub use naming::model_number;

use super::Role;
use crate::sorting::sort_by;

/// What a caller knows better about one file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Override {
    /// What it holds.
    pub role: Option<Role>,
    /// Which model it belongs to: a name as [`ModelFiles::name`] gives it.
    pub model: Option<String>,
    /// Whose result it is; empty for ground truth.
    pub method: Option<String>,
    /// What its indices of points count from: 0, or 1 as the benchmark's do.
    pub first: Option<u8>,
}

/// Files sorted into models.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Grouping {
    /// The models in the order people count: PC2 before PC10.
    pub models: Vec<ModelFiles>,
    /// Files that belong to no model as far as can be told, in the order of their paths. Pictures,
    /// programs and documents stand here as the first of them.
    pub unplaced: Vec<Unplaced>,
    /// How many files were passed over as litter (`.DS_Store`, `Icon\r`, `__MACOSX`, …).
    pub ignored: usize,
}

/// The files of one model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelFiles {
    /// Unique among the models: `PC1`, or `training_set/PC1` where two sets have one.
    pub name: String,
    /// The number its name ends with.
    pub number: Option<u32>,
    /// The cloud, then the ground truth, then the methods' files in the order of their names.
    pub files: Vec<PlacedFile>,
}

/// A file and what it is for its model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedFile {
    /// The path as it was given.
    pub path: String,
    /// What it holds.
    pub role: Role,
    /// Whose result it is; `None` for the cloud and the ground truth.
    pub method: Option<String>,
    /// What its indices of points count from, where the caller says so.
    pub first: Option<u8>,
}

/// A file without a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unplaced {
    /// The path as it was given.
    pub path: String,
    /// Why it has none, and what would give it one.
    pub reason: String,
    /// What its name and folder say it is, where they say that it holds segments or surfaces.
    pub recognised: Option<Recognised>,
}

/// What a file that has no place was taken for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recognised {
    /// What it holds.
    pub role: Role,
    /// The name of the cloud it asks for.
    pub model: String,
    /// Whose result it would be.
    pub method: String,
}

/// Sorts files into models by their paths alone.
///
/// What is looked at are the endings of [`FILE_KINDS`](super::FILE_KINDS). Knows the layouts of the
/// benchmark: all files of a set in one folder, or one folder per role
/// (`pointCloud`, `pointCloud_primitives`, …) and per role and method (`pointCloud_primitives_HT`),
/// nested in whatever folders an archive adds, in any case. A file beside its cloud is ground
/// truth; one in a folder of its own is the result of a method named after that folder. Models of
/// the same name in different sets are kept apart. The result does not depend on the order of the
/// paths. O(n log n) for n paths of bounded depth.
///
/// ```
/// use std::collections::BTreeMap;
/// use fit4cad::format::group;
/// let paths = ["set/PC2.txt", "set/PC2_primitives.txt", "set/HT/PC2_primitives.txt"];
/// let grouping = group(&paths, &BTreeMap::new());
/// let files = &grouping.models[0].files;
/// assert_eq!((files.len(), files[2].method.as_deref()), (3, Some("HT")));
/// ```
pub fn group<P: AsRef<str>>(paths: &[P], overrides: &BTreeMap<String, Override>) -> Grouping {
    let mut paths: Vec<&str> = paths.iter().map(AsRef::as_ref).collect();
    sort_by(&mut paths, |a, b| natural::compare(a, b));
    let mut grouping = Grouping::default();
    let mut before = None;
    let mut clues = Vec::new();
    let mut others = Vec::new();
    for path in paths {
        // The order tells any two apart, so that the same ones are beside each other.
        if before.replace(path) == Some(path) {
            grouping.reject(path, "the same path was given twice".to_owned());
            continue;
        }
        match clue::sort(path, overrides.get(path)) {
            Sorted::File(clue) => clues.push(clue),
            Sorted::Litter => grouping.ignored += 1,
            Sorted::Other => others.push(path),
            Sorted::Folder => {}
            Sorted::Unknown(reason) => grouping.reject(path, reason),
        }
    }
    if let Some((first, more)) = others.split_first() {
        let reason = match more.len() {
            0 => "a picture, a program or a document".to_owned(),
            1 => "a picture, a program or a document, as is one more file".to_owned(),
            more => format!("a picture, a program or a document, as are {more} more files"),
        };
        grouping.reject(first, reason);
    }
    let models = placing::place(clues, &mut grouping);
    grouping.models = naming::name(models);
    for file in grouping
        .models
        .iter_mut()
        .flat_map(|model| &mut model.files)
    {
        file.first = overrides.get(&file.path).and_then(|said| said.first);
    }
    sort_by(&mut grouping.unplaced, |a, b| {
        natural::compare(&a.path, &b.path)
    });
    grouping
}

impl Grouping {
    fn reject(&mut self, path: &str, reason: String) {
        self.unplaced.push(Unplaced {
            path: path.to_owned(),
            reason,
            recognised: None,
        });
    }

    /// Rejects a file of which it is known what it is.
    fn reject_clue(&mut self, clue: &Clue<'_>, reason: String) {
        self.unplaced.push(Unplaced {
            path: clue.path.to_owned(),
            reason,
            recognised: Some(clue.recognised()),
        });
    }
}
