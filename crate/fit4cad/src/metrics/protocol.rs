//! The two ways to score.

use std::fmt;
use std::str::FromStr;

/// Which rules apply.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Protocol {
    /// The formulas of the paper, computed exactly. Negatives are counted among all points.
    #[default]
    Definition,
    /// What the authors' evaluation scripts do, so that a score can be set beside the paper's
    /// tables: points outside every true primitive do not exist for the counts, PPV and TPR as well
    /// as TNR and NPV stand under each other's heading, and d1 follows
    /// [`coefficients::published_mean`](super::coefficients::published_mean). MFE and directed
    /// Hausdorff distance are those of the definition: the scripts approximate them at random.
    Published,
}

impl Protocol {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Definition, Self::Published];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Definition => "definition",
            Self::Published => "published",
        }
    }

    /// How scores by it come about, to go on a sentence.
    pub const fn rules(self) -> &'static str {
        match self {
            Self::Definition => "by definition",
            Self::Published => "as the published tables were made",
        }
    }

    /// What it does and what it is for.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Definition => "Computes the paper's formulas exactly. Use it to judge a method.",
            Self::Published => {
                "Repeats what the authors' evaluation scripts do, so that a score can stand beside \
                 the paper's two tables. The scripts hand prediction and truth to a helper in the \
                 other order, which is why four published columns are swapped in pairs."
            }
        }
    }
}

/// A point in which the protocols differ, or are held to differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Difference {
    /// What it is about.
    pub what: &'static str,
    /// How it is by [`Protocol::Definition`].
    pub definition: &'static str,
    /// How it is by [`Protocol::Published`].
    pub published: &'static str,
}

/// How the protocols differ.
pub static DIFFERENCES: &[Difference] = &[
    Difference {
        what: "Points that count",
        definition: "every point of the cloud",
        published: "only points listed by a ground-truth primitive",
    },
    Difference {
        what: "PPV and TPR",
        definition: "as defined: TP/(TP+FP) and TP/(TP+FN)",
        published: "swapped: the column headed PPV holds TPR, and the other way round",
    },
    Difference {
        what: "TNR and NPV",
        definition: "as defined: TN/(TN+FP) and TN/(TN+FN)",
        published: "swapped, for the same reason",
    },
    Difference {
        what: "DSC and ACC",
        definition: "as in the paper",
        published: "as in the paper",
    },
    Difference {
        what: "d1: which sign",
        definition: "the sign that makes the distance smaller",
        published: "negated when any pair of entries differs in sign, even −1e−18 against 1e−18",
    },
    Difference {
        what: "d1: no partner, or another type",
        definition: "has no d1; other types are counted as type errors",
        published: "counts as a perfect 0 in the mean, or is left out where the vectors differ in \
                    length",
    },
    Difference {
        what: "MFE and directed Hausdorff",
        definition: "exact distance to the whole surface",
        published: "the same: the authors' random sampling does not repeat and is not imitated",
    },
];

impl fmt::Display for Protocol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// There is no protocol of that name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no protocol `{0}`; choose `definition` or `published`")]
pub struct UnknownProtocol(pub String);

impl FromStr for Protocol {
    type Err = UnknownProtocol;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|protocol| protocol.name() == name)
            .ok_or_else(|| UnknownProtocol(name.to_owned()))
    }
}
