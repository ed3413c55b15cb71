//! Files that hold the points of one primitive each, brought together: beside a cloud they are its segments,
//! without one they are the cloud.

use super::Grouping;
use super::clue::Clue;
use super::named::{Named, Places, joined};
use crate::format::Role;

/// Files of one folder and model, by one method.
#[derive(Debug)]
pub(super) struct Set<'a> {
    /// What is known of all of them; its stem is the name of the model, empty where there is none.
    pub(super) clue: Clue<'a>,
    /// In the order of the files.
    pub(super) files: Vec<Clue<'a>>,
}

/// What a model made of such files is called where neither names nor folders tell.
const NAMELESS: &str = "shapes";

/// Takes such files out of the others. What only looks like one stays: a model that has files of its own, and
/// what was left over where nothing was found.
pub(super) fn take<'a>(clues: &mut Vec<Clue<'a>>, grouping: &mut Grouping) -> Vec<Set<'a>> {
    let (pieces, mut others): (Vec<_>, Vec<_>) = std::mem::take(clues)
        .into_iter()
        .partition(|clue| clue.piece.is_some());
    let mut models = Places::default();
    for clue in others.iter().filter(|clue| clue.role != Role::Cloud) {
        models.give(&clue.stem.to_lowercase());
    }
    let mut sets: Named<Vec<Clue<'a>>> = Named::default();
    for mut clue in pieces {
        let Some(name) = clue.piece else { continue };
        if models.get(&own_stem(&clue)).is_some() {
            clue.becomes_cloud();
            others.push(clue);
            continue;
        }
        let told = |text: &Option<String>| if text.is_some() { "1" } else { "" };
        let set = joined(&[
            &clue.home(),
            &name.model.to_lowercase(),
            told(&clue.method),
            clue.method.as_deref().unwrap_or_default(),
            told(&clue.model),
            clue.model.as_deref().unwrap_or_default(),
            if clue.is_truth { "1" } else { "" },
        ]);
        sets.or_insert(&set, Vec::new()).push(clue);
    }
    let mut found = Vec::new();
    for files in sets.in_order() {
        let is_left_over = |clue: &Clue<'_>| clue.piece.is_none_or(|name| name.kind.is_none());
        if files.iter().all(is_left_over) {
            others.extend(files.into_iter().map(|mut clue| {
                clue.becomes_cloud();
                clue
            }));
            continue;
        }
        found.extend(Set::of(files, grouping));
    }
    *clues = others;
    found
}

impl<'a> Set<'a> {
    /// Of files that are saved in two kinds, the first kind is taken.
    fn of(files: Vec<Clue<'a>>, grouping: &mut Grouping) -> Option<Self> {
        let mut best: Named<(usize, &str)> = Named::default();
        for clue in &files {
            let kind = best.or_insert(&own_stem(clue), (clue.kind, clue.path));
            *kind = (clue.kind, clue.path).min(*kind);
        }
        let mut kept = Vec::new();
        for clue in files {
            match best.get(&own_stem(&clue)) {
                Some(&(_, path)) if path != clue.path => {
                    grouping.reject(clue.path, format!("{path} already gives the same"));
                }
                _ => kept.push(clue),
            }
        }
        let mut clue = kept.first()?.clone();
        if clue.model.is_none() {
            clue.stem = clue.piece?.model.to_owned();
        }
        Some(Self { clue, files: kept })
    }

    /// The cloud of these files together, and the paths of all but the first; a file alone is a cloud as any
    /// other.
    pub(super) fn into_cloud(mut self) -> (Clue<'a>, Vec<&'a str>) {
        let mut files = self.files.into_iter();
        let first = files.next();
        let more: Vec<&str> = files.map(|clue| clue.path).collect();
        if let (Some(mut alone), true) = (first, more.is_empty()) {
            alone.becomes_cloud();
            return (alone, more);
        }
        let folder = self.clue.base.last().copied();
        if self.clue.stem.is_empty() {
            self.clue.stem = folder.unwrap_or(NAMELESS).to_owned();
        }
        self.clue.becomes_cloud();
        (self.clue, more)
    }
}

/// The name of a file without its ending, in lower case. Where the caller says the model, the stem is that.
fn own_stem(clue: &Clue<'_>) -> String {
    let name = clue.path.rsplit(['/', '\\']).next().unwrap_or(clue.path);
    let stem = crate::format::files::kind_of(name).map_or(name, |(_, stem)| stem);
    stem.to_lowercase()
}

impl Clue<'_> {
    fn becomes_cloud(&mut self) {
        self.role = Role::Cloud;
        self.method = None;
        self.piece = None;
    }
}
