//! A file that was opened: which models are in it, under which paths, and each when it is asked for.

use fit4cad::format::Role;
use fit4cad::format::group::role_in_name;
use hdf5_reader::Hdf5File;
use hdf5_reader::group::Group;

use crate::contents::{Contents, Part};
use crate::names::is_soup;
use crate::storage::{options, storage};

/// Most models of one file; the rest is left with a word.
const MOST_MODELS: usize = 100_000;

/// Most arrays that are named where none of them can be used.
const MOST_NAMED: usize = 12;

/// Why a file cannot be used, in words for the reader.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// It is not HDF5, or damaged.
    #[error("it could not be read as HDF5: {0}")]
    Unreadable(String),
    /// None of its arrays is called and shaped as points or labels; it has those.
    #[error("it holds no points and no labels of points; there are {0}")]
    Nothing(String),
}

impl From<hdf5_reader::error::Error> for Error {
    fn from(error: hdf5_reader::error::Error) -> Self {
        Self::Unreadable(error.to_string())
    }
}

/// One file of a model, as arrays of NumPy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// The path under which it is sorted into models: that of the file where it holds one cloud and no more.
    pub path: String,
    /// Its bytes, about.
    pub size: u64,
    group: usize,
    part: Part,
    model: u64,
}

/// A file that was opened.
pub struct Opened {
    groups: Vec<Contents>,
    entries: Vec<Entry>,
    notes: Vec<String>,
}

impl Opened {
    /// Opens a file by its path, of which nothing but the name is looked at, its size, and what gives bytes from an
    /// offset on. Arrays are told by their names and shapes; none is read. Linear in the number of models.
    ///
    /// # Errors
    /// If it is no HDF5, is damaged, or holds neither points nor labels.
    pub fn open(
        path: &str,
        size: u64,
        read: impl Fn(u64, usize) -> Result<Vec<u8>, String> + Send + Sync + 'static,
    ) -> Result<Self, Error> {
        let file = Hdf5File::from_storage_with_options(storage(size, read), options())?;
        let root = file.root_group()?;
        let (groups, arrays) = root.member_names()?;
        let mut notes = Vec::new();
        if groups.iter().any(|name| is_soup(name)) {
            notes.push(
                "the parameters of its surfaces are not read: they are pickled attributes, which are never opened. \
                 Surfaces are fitted to its segments instead"
                    .to_owned(),
            );
        }
        let mut opened = Self {
            groups: Vec::new(),
            entries: Vec::new(),
            notes,
        };
        if let Some(contents) = contents_of(&root, &arrays) {
            opened.add(path, None, contents);
        } else {
            for name in &groups {
                let within = root.group(name)?;
                let (_, arrays) = within.member_names()?;
                if let Some(contents) = contents_of(&within, &arrays) {
                    opened.add(path, Some(name), contents);
                }
            }
        }
        if opened.entries.is_empty() {
            return Err(Error::Nothing(list(arrays.into_iter().chain(groups))));
        }
        if opened.groups.iter().any(|contents| contents.has_noisy) {
            opened
                .notes
                .push("of its points those without noise are read".to_owned());
        }
        Ok(opened)
    }

    /// The files in it.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// What else there is to say of it, of "it".
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The content of an entry: an `.npz` with `points`, or `labels`, `numbers` and `types`, or all of them.
    ///
    /// # Errors
    /// If its arrays cannot be had, or are damaged.
    pub fn read(&self, entry: &Entry) -> Result<Vec<u8>, Error> {
        let Some(contents) = self.groups.get(entry.group) else {
            return Err(Error::Nothing("none".to_owned()));
        };
        Ok(contents.read(entry.part, entry.model)?.npz())
    }

    fn add(&mut self, path: &str, group: Option<&str>, contents: Contents) {
        let place = self.groups.len();
        let count = contents.models.unwrap_or(1);
        let many = group.is_some() || count > 1;
        for model in 0..count {
            if self.entries.len() >= MOST_MODELS {
                self.notes.push(format!(
                    "it holds more than {MOST_MODELS} models; the rest was left"
                ));
                break;
            }
            let name = match (group, count) {
                (Some(group), 1) => Some(group.to_owned()),
                (Some(group), _) => Some(format!("{group}_{model:05}")),
                (None, _) if many => Some(format!("{model:05}")),
                (None, _) => None,
            };
            let with_cloud = contents.parts().contains(&Part::Cloud);
            for part in contents.parts() {
                self.entries.push(Entry {
                    path: path_of(path, name.as_deref(), part, with_cloud),
                    size: contents.size(part),
                    group: place,
                    part,
                    model,
                });
            }
        }
        self.groups.push(contents);
    }
}

/// The arrays of a group that mean something. What cannot be opened, as a link to another file, means nothing.
fn contents_of(group: &Group, names: &[String]) -> Option<Contents> {
    let arrays = names.iter().filter_map(|name| group.dataset(name).ok());
    Contents::of(arrays.collect())
}

/// The path of a part: of one model that of its file, with a word where it is of labels alone; of many, one in a
/// folder named after the file.
fn path_of(path: &str, model: Option<&str>, part: Part, with_cloud: bool) -> String {
    let name = path.rfind(['/', '\\']).map_or(0, |at| at + 1);
    let end = path
        .get(name..)
        .and_then(|name| name.rfind('.'))
        .map_or(path.len(), |at| name + at);
    let (stem, ending) = path.split_at_checked(end).unwrap_or((path, ""));
    let (stem, ending) = match model {
        Some(model) => (format!("{stem}/{model}"), ".npz"),
        None => (stem.to_owned(), ending),
    };
    let named = stem
        .get(stem.rfind(['/', '\\']).map_or(0, |at| at + 1)..)
        .unwrap_or(&stem);
    let word = match part {
        Part::Cloud => "",
        // Beside the truth, of a method of that name.
        Part::Labels if with_cloud => "_labels_predicted",
        Part::Labels if role_in_name(named) == Some(Role::Primitives) => "",
        Part::Labels => "_labels",
    };
    format!("{stem}{word}{ending}")
}

fn list(names: impl Iterator<Item = String>) -> String {
    let mut names: Vec<String> = names.collect();
    let more = names.len().saturating_sub(MOST_NAMED);
    names.truncate(MOST_NAMED);
    match (names.is_empty(), more) {
        (true, _) => "none at all".to_owned(),
        (_, 0) => names.join(", "),
        (_, more) => format!("{} and {more} more", names.join(", ")),
    }
}
