//! Why a file, or a piece of it, cannot be used.

/// Why no part could be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StepError {
    /// The bytes are none of STEP at all.
    #[error(
        "this is no STEP file: it does not start with “ISO-10303-21;” but with “{found}”. Export the part as STEP (AP203, AP214 or AP242)"
    )]
    NotStep {
        /// How it starts.
        found: String,
    },
    /// It is packed by gzip and cannot be unpacked.
    #[error("it is packed by gzip and damaged, or too large")]
    Packed,
    /// The file is larger than is read.
    #[error("the file has {size} bytes; up to {limit} are read. Export single parts of it")]
    TooLarge {
        /// Its size in bytes.
        size: usize,
        /// The most that is read.
        limit: usize,
    },
    /// The file is cut off, or is not written as STEP files are.
    #[error("{reason}. Export the file again: nothing can be read from what is broken here")]
    Syntax {
        /// What is wrong, with line and column.
        reason: String,
    },
    /// There is no face in it that could be sampled.
    #[error("the file holds no face: {reason}")]
    NoFaces {
        /// What it holds instead.
        reason: String,
    },
    /// Every face had to be left out.
    #[error("none of the {count} faces could be used. The first: {reason}")]
    NothingUsable {
        /// How many faces there are.
        count: usize,
        /// Why the first was left out.
        reason: String,
    },
    /// Something asked for is out of its range.
    #[error("{what} must be {expected}, not {found}")]
    OutOfRange {
        /// What was asked for.
        what: &'static str,
        /// What is allowed.
        expected: String,
        /// What was given.
        found: String,
    },
    /// The assembly has more faces than are sampled.
    #[error(
        "the assembly has more than {limit} faces, instances counted each; import single parts of it"
    )]
    TooManyFaces {
        /// The most there may be.
        limit: usize,
    },
}

/// Why one entity cannot be used: the rest of the file can.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trouble {
    /// Number of the entity in the file.
    pub entity: u64,
    /// What is wrong with it, a clause without a full stop.
    pub reason: String,
}

impl Trouble {
    pub(crate) fn new(entity: u64, reason: impl Into<String>) -> Self {
        Self {
            entity,
            reason: reason.into(),
        }
    }
}

impl std::fmt::Display for Trouble {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "#{}: {}", self.entity, self.reason)
    }
}

/// The result of reading one entity.
pub(crate) type Got<T> = Result<T, Trouble>;
