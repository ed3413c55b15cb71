//! What the path of one file says about it.

use super::{Override, Recognised};
use crate::format::Role;
use crate::format::files::{self, FILE_KINDS, Holds};
use crate::format::pieces::PieceName;

/// Name of a method whose files give it none.
pub(super) const NAMELESS: &str = "submission";

/// What is known of a file from its path, or from what the caller said about it.
#[derive(Debug, Clone)]
pub(super) struct Clue<'a> {
    /// The path as it was given.
    pub(super) path: &'a str,
    /// The folders that hold its set: those above its role folder, or all of them.
    pub(super) base: Vec<&'a str>,
    /// Name of the model, as the file spells it.
    pub(super) stem: String,
    pub(super) role: Role,
    /// The method, where path or caller name one.
    pub(super) method: Option<String>,
    /// Whether the caller says that it is ground truth.
    pub(super) is_truth: bool,
    /// Whether it lies in a folder for its role, like `pointCloud_primitives`.
    pub(super) in_role_folder: bool,
    /// The model the caller names for it, in lower case.
    pub(super) model: Option<String>,
    /// Place of its kind among [`FILE_KINDS`].
    pub(super) kind: usize,
    /// Whether nothing says if it is a cloud or holds segments of one.
    pub(super) is_open: bool,
    /// Where its name says that it holds the points of one primitive: of which model, as far as that is told.
    pub(super) piece: Option<PieceName<'a>>,
    /// Where nothing but its name says that it holds types: that name without its ending.
    pub(super) types: Option<&'a str>,
}

/// What becomes of a path.
#[derive(Debug)]
pub(super) enum Sorted<'a> {
    File(Clue<'a>),
    /// Left by an operating system.
    Litter,
    /// A picture, a program or a document.
    Other,
    /// A folder's own entry in an archive.
    Folder,
    Unknown(String),
}

/// Words in the names of texts that come with data sets and are no clouds.
const OTHER_TEXTS: [&str; 19] = [
    "readme",
    "license",
    "licence",
    "copying",
    "changelog",
    "citation",
    "requirements",
    "cmakelists",
    "notes",
    "colors",
    "colours",
    "colormap",
    "palette",
    "boxplot",
    "scores",
    "metrics",
    "config",
    "settings",
    "filelist",
];

/// Judges a path. Folders are separated by `/` or `\`.
pub(super) fn sort<'a>(path: &'a str, said: Option<&Override>) -> Sorted<'a> {
    let mut folders: Vec<&str> = path
        .split(['/', '\\'])
        .filter(|part| !part.is_empty() && *part != ".")
        .collect();
    if path.ends_with(['/', '\\']) {
        return Sorted::Folder;
    }
    let Some(name) = folders.pop() else {
        return Sorted::Folder;
    };
    if is_litter(name)
        || folders
            .iter()
            .any(|folder| *folder == "__MACOSX" || *folder == ".git")
    {
        return Sorted::Litter;
    }
    let said_role = said.and_then(|said| said.role);
    let known = files::kind_of(name);
    let Some((kind, stem)) = known.or(said_role.map(|_| (FILE_KINDS.len(), name))) else {
        if files::is_of_other_kind(name) {
            return Sorted::Other;
        }
        return Sorted::Unknown(match name.rsplit_once('.') {
            Some((_, "zip" | "gz" | "7z" | "rar" | "tar")) => {
                "an archive within; unpack it first".to_owned()
            }
            _ => format!("not of a kind that is read: {}", files::endings()),
        });
    };
    let holds = FILE_KINDS.get(kind).map(|kind| kind.holds);
    let own_stem = stem;
    let piece = PieceName::read(stem)
        .filter(|_| said_role.is_none_or(|role| role == Role::Primitives))
        .filter(|_| holds != Some(Holds::Segments));
    let FileName {
        stem,
        mut role,
        mut method,
    } = match piece {
        Some(_) => FileName {
            stem: stem.to_owned(),
            role: Some(Role::Primitives),
            method: None,
        },
        None => FileName::read(stem),
    };
    let mut in_role_folder = false;
    for (depth, folder) in folders.iter().enumerate().rev() {
        let Some(found) = role_folder(folder) else {
            continue;
        };
        if role.is_some_and(|role| role != found.role) {
            continue;
        }
        in_role_folder = true;
        role = Some(found.role);
        method = method.or(found.method.map(str::to_owned));
        folders.truncate(depth);
        break;
    }
    if role.is_none() && said_role.is_none() && names_other_text(&stem) {
        return Sorted::Unknown("its name is not that of a model's file".to_owned());
    }
    let usual = match holds {
        Some(Holds::Segments) => Role::Primitives,
        _ => Role::Cloud,
    };
    let mut clue = Clue {
        path,
        base: folders,
        stem,
        role: said_role.or(role).unwrap_or(usual),
        method: method.filter(|method| !names_truth(method)),
        is_truth: false,
        in_role_folder,
        model: None,
        kind,
        is_open: said_role.or(role).is_none() && holds == Some(Holds::Either),
        piece,
        types: Some(own_stem).filter(|_| said_role.is_none() && role == Some(Role::Types)),
    };
    if let Some(said) = said {
        clue.heed(said);
    }
    Sorted::File(clue)
}

impl Clue<'_> {
    /// The folders that hold its set, as one path.
    pub(super) fn home(&self) -> String {
        self.base.join("/")
    }

    /// What it is, as far as it alone tells: the method is that of its name, else its folder.
    pub(super) fn recognised(&self) -> Recognised {
        let folder = self.base.last().copied();
        let method = self.method.as_deref().or(folder);
        Recognised {
            role: self.role,
            model: self.stem.clone(),
            method: method.unwrap_or(NAMELESS).to_owned(),
        }
    }

    fn heed(&mut self, said: &Override) {
        if let Some(model) = said.model.as_deref().filter(|model| !model.is_empty()) {
            let name = model.rsplit('/').next().unwrap_or(model);
            self.stem = name.to_owned();
            self.model = Some(model.to_lowercase());
        }
        match said.method.as_deref() {
            None => {}
            Some("") => {
                self.method = None;
                self.is_truth = true;
            }
            Some(method) => self.method = Some(method.to_owned()),
        }
    }
}

fn is_litter(name: &str) -> bool {
    name.starts_with('.')
        || ["Icon\r", "Icon", "Thumbs.db", "desktop.ini"]
            .iter()
            .any(|litter| name.eq_ignore_ascii_case(litter))
}

/// Whether one of the words of a name says that it is no cloud's.
fn names_other_text(stem: &str) -> bool {
    stem.split(['_', '-', ' ', '.']).any(|word| {
        OTHER_TEXTS
            .iter()
            .any(|other| word.eq_ignore_ascii_case(other))
    })
}

/// Whether a folder or method name means the ground truth. What joins its words does not matter; a
/// digit does: "GT0" is somebody's method.
pub(in crate::format) fn names_truth(name: &str) -> bool {
    let word: String = name.chars().filter(|it| it.is_alphanumeric()).collect();
    matches!(word.to_lowercase().as_str(), "truth" | "groundtruth" | "gt")
}

/// What a file of such a name holds, where one of its words says so: `PC1_labels`, `PC1_primitives_HT`. The name is
/// without folders and ending.
pub fn role_in_name(name: &str) -> Option<Role> {
    FileName::read(name).role
}

/// The parts of a file's name: `PC1.txt`, `PC1_primitives.txt`, `PC1_primitives_HT.txt`.
struct FileName {
    stem: String,
    role: Option<Role>,
    method: Option<String>,
}

impl FileName {
    fn read(name: &str) -> Self {
        let mut end = name.len();
        // From the right: the last word that names a role divides the name.
        while let Some(start) = name.get(..end).and_then(|head| head.rfind(['_', '-'])) {
            let word = name.get(start + 1..end).unwrap_or_default();
            // Many a cloud is called `bracket_type_2`.
            let is_whole = |role: &Role| *role != Role::Types || end == name.len();
            let role = role_word(word).filter(|_| start > 0);
            if let Some(role) = role.filter(is_whole) {
                return Self {
                    stem: name.get(..start).unwrap_or_default().to_owned(),
                    role: Some(role),
                    method: name
                        .get(end + 1..)
                        .filter(|rest| !rest.is_empty())
                        .map(str::to_owned),
                };
            }
            end = start;
        }
        Self {
            stem: name.to_owned(),
            role: None,
            method: None,
        }
    }
}

fn role_word(word: &str) -> Option<Role> {
    match word.to_ascii_lowercase().as_str() {
        "primitives" | "primitive" | "labels" | "label" | "inst" | "instance" | "instances"
        | "seg" | "segments" | "segmentation" => Some(Role::Primitives),
        "parametric" => Some(Role::Parametric),
        "implicit" => Some(Role::Implicit),
        "type" | "types" => Some(Role::Types),
        _ => None,
    }
}

struct RoleFolder<'a> {
    role: Role,
    method: Option<&'a str>,
}

/// Reads `pointCloud`, `pointCloud_primitives`, `pointCloud_primitives_HT`, `primitives`,
/// `primitives_HT` in any case.
fn role_folder(name: &str) -> Option<RoleFolder<'_>> {
    let is = |word: &str| name.eq_ignore_ascii_case(word);
    if is("pointCloud") || is("pointClouds") || is("point_cloud") || is("clouds") || is("points") {
        return Some(RoleFolder {
            role: Role::Cloud,
            method: None,
        });
    }
    const PREFIX: &str = "pointcloud_";
    let (rest, is_prefixed) = match name.get(..PREFIX.len()) {
        Some(prefix) if prefix.eq_ignore_ascii_case(PREFIX) => (name.get(PREFIX.len()..)?, true),
        _ => (name, false),
    };
    let (word, method) = match rest.split_once('_') {
        Some((word, method)) => (word, Some(method).filter(|method| !method.is_empty())),
        None => (rest, None),
    };
    // A folder `type_2` may hold anything.
    let role = role_word(word).filter(|role| is_prefixed || *role != Role::Types)?;
    Some(RoleFolder { role, method })
}
