//! Finding each file its model and its method.

use super::Grouping;
use super::clue::{Clue, NAMELESS, names_truth};
use super::named::{Named, Places, joined};
use super::pieces::{self, Set};
use super::settling::{place_of, settle, settle_types};
use crate::format::Role;
use crate::sorting::sort_by;

/// A model while files are being found for it.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    pub(super) cloud: Clue<'a>,
    /// By whose they are and role.
    pub(super) files: Named<Placed<'a>>,
    /// Further files of the cloud, where each holds the points of one primitive.
    pub(super) more: Vec<&'a str>,
    /// Files that hold the points of one primitive each, by whose they are.
    pub(super) pieces: Named<(Owner<'a>, Vec<&'a str>)>,
    has_truth: bool,
}

/// A file in its place.
#[derive(Debug)]
pub(super) struct Placed<'a> {
    pub(super) owner: Owner<'a>,
    pub(super) role: Role,
    pub(super) path: &'a str,
}

/// Whose a file is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Owner<'a> {
    Truth,
    /// A method: its name and the folders it was found in, for two of the same name.
    Method {
        name: String,
        base: Vec<&'a str>,
    },
}

/// Clouds of one name among which the one a file belongs to is looked for. Looking through more
/// for each of as many files would take time that grows with the square.
const MAX_NAMESAKES: usize = 256;

/// Most clouds that are named where it is unclear to which a file belongs.
const MOST_NAMED: usize = 3;

/// Gives each file a place in a model, or a reason why it has none.
pub(super) fn place<'a>(clues: Vec<Clue<'a>>, grouping: &mut Grouping) -> Vec<Draft<'a>> {
    let mut clues = clues;
    settle_types(&mut clues);
    let sets = pieces::take(&mut clues, grouping);
    settle(&mut clues);
    let (mut clouds, others): (Vec<_>, Vec<_>) =
        clues.into_iter().partition(|clue| clue.role == Role::Cloud);
    // Where two could be the same cloud, that of the kind named first is it.
    sort_by(&mut clouds, |one, other| one.kind.cmp(&other.kind));
    let mut shelf = Shelf::default();
    for cloud in clouds {
        shelf.add_cloud(cloud, Vec::new(), grouping);
    }
    let sets = shelf.with_clouds_of(sets, grouping);
    // Bases whose role folders name methods: there, folders that name none hold the truth.
    let mut bases_of_methods = Places::default();
    let names_method = |clue: &&Clue<'_>| clue.in_role_folder && clue.method.is_some();
    for clue in others.iter().filter(names_method) {
        bases_of_methods.give(&clue.home());
    }
    let is_of_methods =
        |clue: &Clue<'_>| clue.in_role_folder && bases_of_methods.get(&clue.home()).is_some();
    let mut at_home = Vec::new();
    let mut strangers = Vec::new();
    for mut clue in others {
        match shelf.find(&mut clue) {
            Ok(model) if shelf.is_home(model, &clue) => at_home.push((model, clue)),
            Ok(model) => strangers.push((model, clue)),
            Err(reason) => grouping.reject_clue(&clue, reason),
        }
    }
    // Truth beside its cloud comes before what may be a copy of it.
    for (model, clue) in at_home {
        let owner = match &clue.method {
            Some(name) => Owner::method(name.clone(), &clue),
            None => Owner::Truth,
        };
        shelf.put(model, owner, &clue, grouping);
    }
    let (sets_at_home, sets): (Vec<_>, Vec<_>) = sets
        .into_iter()
        .partition(|(model, set)| shelf.is_home(*model, &set.clue));
    for (model, set) in sets_at_home {
        let owner = match &set.clue.method {
            Some(name) => Owner::method(name.clone(), &set.clue),
            None if set.clue.is_truth || !shelf.has_truth(model) => Owner::Truth,
            None => Owner::method(NAMELESS.to_owned(), &set.clue),
        };
        shelf.put_pieces(model, owner, &set, grouping);
    }
    let with_truth: Vec<bool> = shelf.models.iter().map(|model| model.has_truth).collect();
    for (model, clue) in strangers {
        let holds_truth = is_of_methods(&clue);
        let has_truth = with_truth.get(model).copied().unwrap_or(false);
        let owner = shelf.owner_from_elsewhere(model, &clue, holds_truth, has_truth);
        shelf.put(model, owner, &clue, grouping);
    }
    for (model, set) in sets {
        let has_truth = shelf.has_truth(model);
        let holds_truth = is_of_methods(&set.clue);
        let owner = shelf.owner_from_elsewhere(model, &set.clue, holds_truth, has_truth);
        shelf.put_pieces(model, owner, &set, grouping);
    }
    shelf.models
}

impl<'a> Owner<'a> {
    fn method(name: String, clue: &Clue<'a>) -> Self {
        Self::Method {
            name,
            base: clue.base.clone(),
        }
    }

    /// The folders that a method was found in.
    pub(super) fn base(&self) -> &[&'a str] {
        match self {
            Self::Truth => &[],
            Self::Method { base, .. } => base,
        }
    }

    /// Nothing for the truth; different names for different methods.
    pub(super) fn key(&self) -> String {
        match self {
            Self::Truth => String::new(),
            Self::Method { name, base } => joined(&[name, &base.join("/")]),
        }
    }
}

/// The files of one role that are somebody's, as one name.
fn key(owner: &Owner<'_>, role: Role) -> String {
    joined(&[&owner.key(), role.name()])
}

#[derive(Default)]
struct Shelf<'a> {
    models: Vec<Draft<'a>>,
    /// Models by their name in lower case.
    by_stem: Named<Vec<usize>>,
    /// Models by their name in lower case and the folders of their set.
    at_home: Named<usize>,
    /// Models by the folders of their set.
    by_base: Named<Vec<usize>>,
}

impl<'a> Shelf<'a> {
    fn add_cloud(&mut self, cloud: Clue<'a>, more: Vec<&'a str>, grouping: &mut Grouping) {
        let stem = cloud.stem.to_lowercase();
        let key = place_of(&stem, &cloud.base);
        if let Some(twin) = self
            .at_home
            .get(&key)
            .and_then(|&model| self.models.get(model))
        {
            let reason = format!(
                "{} already is the cloud {}",
                twin.cloud.path, twin.cloud.stem
            );
            for path in std::iter::once(cloud.path).chain(more) {
                grouping.reject(path, reason.clone());
            }
            return;
        }
        let model = self.models.len();
        self.by_base
            .or_insert(&cloud.home(), Vec::new())
            .push(model);
        self.at_home.or_insert(&key, model);
        self.by_stem.or_insert(&stem, Vec::new()).push(model);
        self.models.push(Draft {
            cloud,
            files: Named::default(),
            // A cloud of several files holds its own.
            has_truth: !more.is_empty(),
            more,
            pieces: Named::default(),
        });
    }

    /// The models of files that hold the points of one primitive each; those without a cloud become one.
    fn with_clouds_of(
        &mut self,
        sets: Vec<Set<'a>>,
        grouping: &mut Grouping,
    ) -> Vec<(usize, Set<'a>)> {
        let mut found = Vec::new();
        let mut clouds = Vec::new();
        // All are looked up before any becomes a cloud, which would be one for the others.
        for mut set in sets {
            match self.find_for(&mut set.clue) {
                Ok(Some(model)) => {
                    // A folder named after the model only holds them together.
                    let cloud = self.models.get(model).map(|model| &model.cloud);
                    let folder = set.clue.base.last();
                    if let (Some(cloud), Some(folder)) = (cloud, folder)
                        && cloud.base != set.clue.base
                        && folder.eq_ignore_ascii_case(&cloud.stem)
                    {
                        set.clue.base.pop();
                    }
                    found.push((model, set));
                }
                Ok(None) => clouds.push(set.into_cloud()),
                Err(reason) => {
                    for file in &set.files {
                        grouping.reject(file.path, reason.clone());
                    }
                }
            }
        }
        for (cloud, more) in clouds {
            self.add_cloud(cloud, more, grouping);
        }
        found
    }

    /// The model that files with the points of one primitive each are of: the one their names or their folder
    /// name, else the one cloud in their folder or in the one around it. `None` where there is no cloud.
    fn find_for(&self, clue: &mut Clue<'a>) -> Result<Option<usize>, String> {
        if clue.model.is_some() {
            return self.find(clue).map(Some);
        }
        if !clue.stem.is_empty()
            && let Ok(model) = self.find(clue)
        {
            return Ok(Some(model));
        }
        if let Some((&folder, around)) = clue.base.split_last()
            && self.by_stem.contains(&folder.to_lowercase())
        {
            let mut named = clue.clone();
            folder.clone_into(&mut named.stem);
            named.base = around.to_vec();
            return self.find(&mut named).map(Some);
        }
        let around = clue.base.split_last().map(|(_, around)| around);
        let beside = std::iter::once(&clue.base[..]).chain(around);
        let models = beside
            .filter_map(|base| self.by_base.get(&base.join("/")))
            .find(|models| !models.is_empty());
        match models.map_or(&[][..], |models| models) {
            [] => Ok(None),
            [model] => Ok(Some(*model)),
            several => Err(self.unclear(several)),
        }
    }

    fn has_truth(&self, model: usize) -> bool {
        self.models.get(model).is_some_and(|model| model.has_truth)
    }

    fn put_pieces(
        &mut self,
        model: usize,
        owner: Owner<'a>,
        set: &Set<'a>,
        grouping: &mut Grouping,
    ) {
        let Some(draft) = self.models.get_mut(model) else {
            return;
        };
        let whose = owner.key();
        let pieces = draft
            .pieces
            .get(&whose)
            .and_then(|(_, paths)| paths.first());
        let file = draft.files.get(&key(&owner, Role::Primitives));
        if let Some(first) = file.map(|file| file.path).or(pieces.copied()) {
            let reason = format!("{first} already gives the same for {}", draft.cloud.stem);
            for file in &set.files {
                grouping.reject(file.path, reason.clone());
            }
            return;
        }
        let paths = set.files.iter().map(|clue| clue.path);
        draft.has_truth |= owner == Owner::Truth;
        draft.pieces.or_insert(&whose, (owner, paths.collect()));
    }

    /// The model a file belongs to; `PC1_HT_primitives.txt` is split into model and method if
    /// there is no model `PC1_HT`, at the last place that leaves a model's name.
    fn find(&self, clue: &mut Clue<'a>) -> Result<usize, String> {
        if let Some(models) = self.by_stem.get(&clue.stem.to_lowercase()) {
            return self.nearest(models, clue);
        }
        // Made small once: a hostile name may be all separators.
        let (whole, small) = (clue.stem.clone(), clue.stem.to_lowercase());
        let places = |name: &str| -> Vec<usize> {
            let separators = name.rmatch_indices(['_', '-']);
            separators.map(|(at, _)| at).collect()
        };
        for (at, small_at) in places(&whole).into_iter().zip(places(&small)) {
            let models = small
                .get(..small_at)
                .and_then(|stem| self.by_stem.get(stem));
            let (Some(models), Some(stem)) = (models, whole.get(..at)) else {
                continue;
            };
            stem.clone_into(&mut clue.stem);
            let method = whole.get(at + 1..).unwrap_or_default();
            if !clue.is_truth && !names_truth(method) {
                clue.method.get_or_insert_with(|| method.to_owned());
            }
            return self.nearest(models, clue);
        }
        Err(format!("there is no cloud {} for it", clue.stem))
    }

    /// Of models of the same name, the one in the same folder, else the one with most folders in
    /// common, else the one laid out alike.
    fn nearest(&self, models: &[usize], clue: &Clue<'a>) -> Result<usize, String> {
        let key = place_of(&clue.stem.to_lowercase(), &clue.base);
        if let (Some(&model), None) = (self.at_home.get(&key), &clue.model) {
            return Ok(model);
        }
        if models.len() > MAX_NAMESAKES {
            return Err(format!(
                "more than {MAX_NAMESAKES} clouds are called {}",
                clue.stem
            ));
        }
        let rank = |model: usize| {
            let cloud = &self.models.get(model)?.cloud;
            let named = clue.model.as_ref().is_some_and(|name| {
                let path = format!("/{}/{}", cloud.base.join("/"), cloud.stem).to_lowercase();
                path.ends_with(&format!("/{name}"))
            });
            let common = cloud
                .base
                .iter()
                .filter(|folder| {
                    clue.base
                        .iter()
                        .any(|other| other.eq_ignore_ascii_case(folder))
                })
                .count();
            let alike = clue.in_role_folder && cloud.in_role_folder;
            Some((named, cloud.base == clue.base, common, alike))
        };
        let mut best: Vec<usize> = Vec::new();
        for &model in models {
            let against = best.first().and_then(|&first| rank(first));
            match rank(model).cmp(&against) {
                std::cmp::Ordering::Greater => best = vec![model],
                std::cmp::Ordering::Equal => best.push(model),
                std::cmp::Ordering::Less => {}
            }
        }
        match best[..] {
            [model] => Ok(model),
            _ => Err(self.unclear(&best)),
        }
    }

    /// Why a file that may be of any of these models has no place.
    fn unclear(&self, models: &[usize]) -> String {
        let paths: Vec<&str> = models
            .iter()
            .take(MOST_NAMED)
            .filter_map(|&model| self.models.get(model))
            .map(|model| model.cloud.path)
            .collect();
        let more = match models.len().saturating_sub(MOST_NAMED) {
            0 => String::new(),
            more => format!(" or one of {more} more"),
        };
        format!(
            "it is unclear to which cloud it belongs: {}{more}",
            paths.join(" or ")
        )
    }

    fn is_home(&self, model: usize, clue: &Clue<'a>) -> bool {
        self.models
            .get(model)
            .is_some_and(|model| model.cloud.base == clue.base)
    }

    /// Whose a file is that does not lie with its cloud.
    fn owner_from_elsewhere(
        &self,
        model: usize,
        clue: &Clue<'a>,
        holds_truth: bool,
        has_truth: bool,
    ) -> Owner<'a> {
        if let Some(method) = &clue.method {
            return Owner::method(method.clone(), clue);
        }
        if clue.is_truth || holds_truth {
            return Owner::Truth;
        }
        let home = self
            .models
            .get(model)
            .map_or(&[][..], |model| &model.cloud.base[..]);
        let shared = home
            .iter()
            .zip(&clue.base)
            .take_while(|(a, b)| a == b)
            .count();
        match clue.base.get(shared..).and_then(<[_]>::last) {
            Some(folder) if names_truth(folder) => Owner::Truth,
            Some(folder) => Owner::method((*folder).to_owned(), clue),
            None if has_truth => Owner::method(NAMELESS.to_owned(), clue),
            None => Owner::Truth,
        }
    }

    fn put(&mut self, model: usize, owner: Owner<'a>, clue: &Clue<'a>, grouping: &mut Grouping) {
        let Some(draft) = self.models.get_mut(model) else {
            return;
        };
        let pieces = draft
            .pieces
            .get(&owner.key())
            .and_then(|(_, paths)| paths.first());
        let pieces = pieces.filter(|_| clue.role == Role::Primitives);
        let key = key(&owner, clue.role);
        let file = draft.files.get(&key).map(|file| file.path);
        if let Some(first) = file.or(pieces.copied()) {
            let stem = &draft.cloud.stem;
            return grouping
                .reject_clue(clue, format!("{first} already gives the same for {stem}"));
        }
        // Types alone make no segments.
        draft.has_truth |= owner == Owner::Truth && clue.role != Role::Types;
        let (role, path) = (clue.role, clue.path);
        draft.files.or_insert(&key, Placed { owner, role, path });
    }
}
