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
}

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
