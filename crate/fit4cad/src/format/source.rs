//! Files of a model: what each is, and how its content is had.

use std::borrow::Cow;

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// `PCi.txt`: the points.
    Cloud,
    /// `PCi_primitives.txt`: which points belong together.
    Primitives,
    /// `PCi_parametric.txt`: their surfaces in parametric form.
    Parametric,
    /// `PCi_implicit.txt`: their surfaces in implicit form.
    Implicit,
    /// `PCi_type.txt`: the type of each point, which nothing here writes.
    Types,
}

impl Role {
    /// All five.
    pub const ALL: [Self; 5] = [
        Self::Cloud,
        Self::Primitives,
        Self::Parametric,
        Self::Implicit,
        Self::Types,
    ];

    /// The word for it in the names of files and folders; files of clouds go without.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cloud => "cloud",
            Self::Primitives => "primitives",
            Self::Parametric => "parametric",
            Self::Implicit => "implicit",
            Self::Types => "types",
        }
    }

    /// What such a file holds.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Cloud => "the cloud",
            Self::Primitives => "which points make up each primitive",
            Self::Parametric => "each primitive's surface, parametric form",
            Self::Implicit => "each primitive's surface, implicit form",
            Self::Types => "the type of each point; a primitive is of that of most of its points",
        }
    }

    /// Whether models are written in such files: types stand in those of the surfaces.
    pub const fn is_written(self) -> bool {
        !matches!(self, Self::Types)
    }
}

/// One file of a model. Its content is asked for when its turn comes, and let go afterwards.
pub trait Source {
    /// Path, for the diagnostics.
    fn path(&self) -> &str;

    /// What it holds.
    fn role(&self) -> Role;

    /// The method whose result it is; `None` for the cloud and the ground truth.
    fn method(&self) -> Option<&str>;

    /// What the indices of points in it count from: 1, as the benchmark's do, or 0.
    fn first(&self) -> u8 {
        1
    }

    /// Bytes of its content; known before it is asked for, so that too much never is.
    fn size(&self) -> u64;

    /// Its content.
    ///
    /// # Errors
    /// Why it cannot be had, in words for the reader.
    fn content(&self) -> Result<Cow<'_, [u8]>, String>;

    /// The bytes of its content from one offset to before another, both within its size; `None` where it can only be
    /// had whole. Clouds of text that can be had so are never held whole.
    fn part(&self, _from: u64, _to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        None
    }
}

/// A file whose content is in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SourceFile<'a> {
    /// Path, for the diagnostics.
    pub path: &'a str,
    /// What it holds.
    pub role: Role,
    /// The method whose result it is; `None` for the cloud and the ground truth.
    pub method: Option<&'a str>,
    /// The content.
    pub bytes: &'a [u8],
}

impl Source for SourceFile<'_> {
    fn path(&self) -> &str {
        self.path
    }

    fn role(&self) -> Role {
        self.role
    }

    fn method(&self) -> Option<&str> {
        self.method
    }

    fn size(&self) -> u64 {
        self.bytes.len() as u64
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        Ok(Cow::Borrowed(self.bytes))
    }

    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        let [from, to] = [from, to].map(|at| usize::try_from(at).unwrap_or(usize::MAX));
        let bytes = self.bytes.get(from..to);
        Some(
            bytes
                .map(Cow::Borrowed)
                .ok_or_else(|| "it is shorter".to_owned()),
        )
    }
}
