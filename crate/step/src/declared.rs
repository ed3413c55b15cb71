//! What the options of an import are, for every face that offers them.

use fit4cad::sample::MAX_POINTS;

use crate::options::{Amount, Options};

/// What kind of value an option has.
#[derive(Debug, Clone, PartialEq)]
pub enum OptionValue {
    /// A number in a range.
    Number {
        /// The least allowed.
        minimum: f64,
        /// The most allowed.
        maximum: f64,
        /// Whether it is whole.
        whole: bool,
    },
    /// One of some words, the first of them where none is given.
    Choice {
        /// The words.
        words: Vec<&'static str>,
    },
    /// Given or not.
    Flag,
}

/// An option of an import.
#[derive(Debug, Clone, PartialEq)]
pub struct OptionInfo {
    /// Its name.
    pub name: &'static str,
    /// What kind of value it has.
    pub value: OptionValue,
    /// What it is measured in; empty of what has no unit.
    pub unit: &'static str,
    /// The number that holds where none is given; `None` where what holds follows from the part.
    pub default: Option<f64>,
    /// What it does, with what holds where it is not given.
    pub explanation: String,
}

/// The options of an import, in the order to show them.
pub fn import_options() -> Vec<OptionInfo> {
    let usual = Options::default();
    let share = match usual.amount {
        Amount::Share(share) => format!("{} % of the diagonal", 100.0 * share),
        Amount::Spacing(spacing) => format!("{spacing} mm"),
        Amount::Points(points) => format!("that of {points} points"),
    };
    let whole = |minimum: f64, maximum: f64| OptionValue::Number {
        minimum,
        maximum,
        whole: true,
    };
    vec![
        OptionInfo {
            name: "points",
            value: whole(10.0, MAX_POINTS as f64),
            unit: "",
            default: None,
            explanation: "How many points, on all faces together, in place of a spacing.".to_owned(),
        },
        OptionInfo {
            name: "spacing",
            value: OptionValue::Number {
                minimum: f64::MIN_POSITIVE,
                maximum: fit4cad::cloud::LARGEST,
                whole: false,
            },
            unit: "mm",
            default: None,
            explanation: format!(
                "About how far neighbouring points lie apart, in millimetres (default: {share}, as in the benchmark)."
            ),
        },
        OptionInfo {
            name: "spread",
            value: OptionValue::Choice {
                words: vec!["even", "random", "scan"],
            },
            unit: "",
            default: None,
            explanation: "even: all neighbours at about one distance, as in the benchmark; random: every place as likely, as samplers of meshes give them; scan: as a scanner takes them from viewpoints around the part, fewer where a face is seen aslant and none where it is hidden.".to_owned(),
        },
        OptionInfo {
            name: "views",
            value: whole(1.0, Options::MOST_VIEWS as f64),
            unit: "",
            default: Some(usual.views as f64),
            explanation: format!(
                "Of a scan, how many viewpoints there are, evenly about the part at two diagonals from its middle and turned by the seed (default {}).",
                usual.views
            ),
        },
        OptionInfo {
            name: "least",
            value: whole(0.0, 10_000.0),
            unit: "",
            default: Some(usual.least as f64),
            explanation: format!(
                "Fewest points of a face, however small it is (default {}); a scan has what it sees.",
                usual.least
            ),
        },
        OptionInfo {
            name: "seed",
            value: whole(0.0, 4_294_967_295.0),
            unit: "",
            default: Some(usual.seed as f64),
            explanation: format!("Seed of everything random (default {}).", usual.seed),
        },
        OptionInfo {
            name: "named",
            value: OptionValue::Flag,
            unit: "",
            default: None,
            explanation: "Free-form faces stay unsegmented, also those that are planes, cylinders, cones, spheres or tori within a millionth of the part.".to_owned(),
        },
        OptionInfo {
            name: "outer",
            value: OptionValue::Flag,
            unit: "",
            default: None,
            explanation: "Faces that nothing outside sees have no points, as those inside of assemblies; a scan has none of them anyway.".to_owned(),
        },
        OptionInfo {
            name: "separate",
            value: OptionValue::Flag,
            unit: "",
            default: None,
            explanation: "Faces of one surface that touch stay primitives of their own; in the benchmark they are one.".to_owned(),
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_declared_ranges_are_taken() {
        for option in import_options() {
            let OptionValue::Number {
                minimum, maximum, ..
            } = option.value
            else {
                continue;
            };
            for value in [minimum, maximum] {
                let usual = Options::default();
                let options = match option.name {
                    "points" => Options {
                        amount: Amount::Points(value as usize),
                        ..usual
                    },
                    "spacing" => Options {
                        amount: Amount::Spacing(value),
                        ..usual
                    },
                    "least" => Options {
                        least: value as usize,
                        ..usual
                    },
                    "views" => Options {
                        views: value as usize,
                        ..usual
                    },
                    "seed" => Options {
                        seed: value as u64,
                        ..usual
                    },
                    other => panic!("{other} is a number that nothing heeds"),
                };
                assert!(options.check().is_ok(), "{} {value}", option.name);
            }
        }
    }
}
