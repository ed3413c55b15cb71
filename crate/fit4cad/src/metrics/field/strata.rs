//! What true primitives are told apart by: where a method wins and where it loses.

use super::{Conditions, Size};
use crate::surface::{OTHER, SurfaceType};

/// What stands in the place of a stratum where a condition cannot be had.
pub const UNKNOWN: &str = "not known";

/// What true primitives are told apart by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// How large they are.
    Size,
    /// Their type.
    Type,
    /// The noise of their model.
    Noise,
    /// How dense the points of their model are.
    Density,
    /// How much of their model is missing.
    Missing,
}

/// Strata of a number: each begins where the one before ends.
#[derive(Debug, Clone, Copy)]
struct Ladder {
    /// Where the second begins, the third, and so on.
    starts: &'static [f64],
    /// In words; one more than there are starts.
    names: &'static [&'static str],
}

/// Steps of five, so that the usual degrees of noise (0.05, 0.1, 0.2, 0.5, 1 % of the diagonal) lie
/// well inside; first what the rounding of files leaves of exact points.
const NOISE: Ladder = Ladder {
    starts: &[1e-5, 3e-4, 1.5e-3, 7.5e-3],
    names: &[
        "noise < 0.001 % of the diagonal",
        "0.001 – 0.03 %",
        "0.03 – 0.15 %",
        "0.15 – 0.75 %",
        "≥ 0.75 %",
    ],
};

/// Steps of two: four times the points each.
const DENSITY: Ladder = Ladder {
    starts: &[0.005, 0.01, 0.02, 0.04],
    names: &[
        "spacing < 0.5 % of the diagonal",
        "0.5 – 1 %",
        "1 – 2 %",
        "2 – 4 %",
        "≥ 4 %",
    ],
};

/// The first is what small accidents at edges add up to.
const MISSING: Ladder = Ladder {
    starts: &[0.02, 0.1, 0.3],
    names: &["missing < 2 %", "2 – 10 %", "10 – 30 %", "≥ 30 %"],
};

impl Ladder {
    fn of(&self, value: Option<f64>) -> &'static str {
        let Some(value) = value.filter(|value| !value.is_nan()) else {
            return UNKNOWN;
        };
        let place = self.starts.partition_point(|start| *start <= value);
        self.names.get(place).copied().unwrap_or(UNKNOWN)
    }
}

impl By {
    /// All of them: first what a primitive has itself.
    pub const ALL: [Self; 5] = [
        Self::Size,
        Self::Type,
        Self::Noise,
        Self::Density,
        Self::Missing,
    ];

    /// Name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Size => "size",
            Self::Type => "type",
            Self::Noise => "noise",
            Self::Density => "density",
            Self::Missing => "missing",
        }
    }

    /// The one of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|by| by.name() == name)
    }

    /// Head of its column.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Size => "Size of the primitive",
            Self::Type => "Type",
            Self::Noise => "Noise of the model",
            Self::Density => "Density of the model",
            Self::Missing => "Share missing of the model",
        }
    }

    /// How it is had.
    pub const fn how(self) -> &'static str {
        match self {
            Self::Size => "The share of the cloud's points that the primitive lists.",
            Self::Type => "The type that the truth names.",
            Self::Noise => {
                "Measured: the root mean square distance of a true primitive's points to its surface, \
                 over the diagonal of the cloud's box; of a model the median over its listed points."
            }
            Self::Density => {
                "Measured: the median distance of a point to its nearest neighbour, over the diagonal \
                 of the cloud's box; points in the same place are one."
            }
            Self::Missing => {
                "Estimated: where a true primitive's points end with none of another beside them, \
                 there is an opening. One whose rim is n points long counts for the n²/4π points of a \
                 disc with that rim; rims across narrow faces are missed. Not known of a cloud that is \
                 one segment, which ends in the open all round."
            }
        }
    }

    /// Whether it is a condition of a model, measured or declared, and no property of a primitive.
    pub const fn is_condition(self) -> bool {
        matches!(self, Self::Noise | Self::Density | Self::Missing)
    }

    /// What its strata are called, in the order to show them.
    pub fn strata(self) -> Vec<&'static str> {
        let of = |ladder: Ladder| ladder.names.iter().copied().chain([UNKNOWN]).collect();
        match self {
            Self::Size => Size::ALL.map(Size::name).to_vec(),
            Self::Type => {
                let types = SurfaceType::ALL.map(SurfaceType::name);
                types.into_iter().chain([OTHER]).collect()
            }
            Self::Noise => of(NOISE),
            Self::Density => of(DENSITY),
            Self::Missing => of(MISSING),
        }
    }

    /// The stratum of a condition's value: noise and spacing in diagonals of the cloud's box, missing as
    /// a share. `None` for what is no condition.
    pub fn of_value(self, value: Option<f64>) -> Option<&'static str> {
        match self {
            Self::Size | Self::Type => None,
            Self::Noise => Some(NOISE.of(value)),
            Self::Density => Some(DENSITY.of(value)),
            Self::Missing => Some(MISSING.of(value)),
        }
    }
}

impl Conditions {
    /// The value of a condition; `None` where it cannot be had, and for what is no condition.
    pub fn value(&self, by: By) -> Option<f64> {
        match by {
            By::Size | By::Type => None,
            By::Noise => self.noise,
            By::Density => self.spacing,
            By::Missing => self.missing,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stratum_begins_where_it_says() {
        let noise = |value| By::Noise.of_value(value).unwrap();
        assert_eq!(noise(Some(0.0)), "noise < 0.001 % of the diagonal");
        assert_eq!(noise(Some(0.001)), "0.03 – 0.15 %");
        assert_eq!(noise(Some(7.5e-3)), "≥ 0.75 %");
        assert_eq!(noise(None), UNKNOWN);
        assert_eq!(noise(Some(f64::NAN)), UNKNOWN);
        assert_eq!(By::Size.of_value(Some(1.0)), None);
    }

    #[test]
    fn every_ladder_ascends_and_names_all_its_steps() {
        for ladder in [NOISE, DENSITY, MISSING] {
            assert_eq!(ladder.names.len(), ladder.starts.len() + 1);
            assert!(ladder.starts.is_sorted());
        }
        for by in By::ALL {
            assert_eq!(By::from_name(by.name()), Some(by));
            let mut names = by.strata();
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count, "{}", by.name());
        }
    }
}
