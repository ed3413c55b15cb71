//! What is to be known about a measure, wherever it is shown.

use super::{Better, Group, Measure, Published, Ratio, Source, Term, Times, Undefined};
use crate::metrics::classification::Count;

/// What every face needs to show a measure.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasureInfo {
    /// The paper's abbreviation: head of columns and name in reports.
    pub key: &'static str,
    /// Its name in full.
    pub name: &'static str,
    /// What it looks at.
    pub group: Group,
    /// How it is written in formulas.
    pub symbol: Term,
    /// What it is equal to.
    pub formula: Term,
    /// What it tells, in a sentence or two.
    pub meaning: &'static str,
    /// The values it can have, in words.
    pub range: String,
    /// The largest of them, where there is one; the smallest is 0.
    pub most: Option<f64>,
    /// Which values are good.
    pub better: Better,
    /// Whether its values lie orders of magnitude apart, so that their logarithms are what to draw.
    pub logarithmic: bool,
    /// Digits after the point that tell something.
    pub decimals: u8,
    /// What its mean runs over.
    pub mean: &'static str,
    /// Where the paper defines it.
    pub section: &'static str,
    /// What [`Protocol::Published`](crate::metrics::Protocol::Published) changes about it; empty
    /// where nothing.
    pub published: String,
}

/// Clouds have some ten thousand points: a fifth digit would be about single ones.
const DECIMALS: u8 = 4;

impl Measure {
    /// What every face needs to show it.
    pub fn info(self) -> MeasureInfo {
        let (words, source) = (self.words(), self.source());
        let most = match source {
            Source::Points(_) => Some(1.0),
            Source::Distances(_) | Source::Coefficients => None,
        };
        let range = match most {
            Some(most) => format!("0 to {most}"),
            None => "0 upwards".to_owned(),
        };
        let formula = || match source {
            Source::Points(ratio) => ratio.term(),
            Source::Distances(_) | Source::Coefficients => Term::row([]),
        };
        MeasureInfo {
            key: self.name(),
            name: words.name,
            group: self.group(),
            symbol: words
                .symbol
                .map_or_else(|| Term::word(self.name()), |symbol| symbol()),
            formula: words.formula.map_or_else(formula, |formula| formula()),
            meaning: words.meaning,
            range: joined(&range, words.remark, "; "),
            most,
            better: words.better,
            logarithmic: words.logarithmic,
            decimals: DECIMALS,
            mean: source.mean(),
            section: words.section,
            published: joined(&source.published(), words.published, " "),
        }
    }
}

fn joined(first: &str, second: &str, between: &str) -> String {
    let parts = [first, second].into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(between)
}

impl Source {
    /// What a mean runs over, in words.
    const fn mean(self) -> &'static str {
        match self {
            Self::Points(Ratio { undefined, .. }) => match undefined {
                Undefined::Zero => {
                    "Mean over the ground-truth primitives; one without a match enters as 0."
                }
                Undefined::ZeroAmongNegatives => {
                    "Mean over the ground-truth primitives; one whose match leaves no point out \
                     enters as 0."
                }
                Undefined::LeftOut => {
                    "Mean over the ground-truth primitives, without those that leave nothing to \
                     measure."
                }
            },
            Self::Distances(_) => "Mean over the predicted primitives that have a surface.",
            Self::Coefficients => {
                "Mean over the predicted primitives whose partner has the same type."
            }
        }
    }

    /// What the published protocol changes, as far as it follows from what is counted.
    fn published(self) -> String {
        let Self::Points(ratio) = self else {
            return String::new();
        };
        let left_out = "Points without a true primitive are left out of the count.";
        match ratio.published {
            Published::Whole => String::new(),
            Published::Labelled => left_out.to_owned(),
            Published::Other(other) => {
                let swapped = format!(
                    "In the published tables this column holds what is defined as {other}: the \
                     authors' script hands prediction and truth over in the other order."
                );
                let counted =
                    matches!(other.source(), Self::Points(held) if held.sees_beyond_truth());
                joined(&swapped, if counted { left_out } else { "" }, " ")
            }
        }
    }
}

impl Ratio {
    /// Whether points of no true primitive enter it.
    fn sees_beyond_truth(self) -> bool {
        let mut counts = self.over.iter().chain(self.under);
        counts.any(|(_, count)| matches!(count, Count::FalsePositives | Count::TrueNegatives))
    }

    /// As a fraction of sums.
    fn term(self) -> Term {
        Term::fraction(sum(self.over), sum(self.under))
    }
}

fn sum(parts: &[Times]) -> Term {
    let mut terms = Vec::new();
    for &(times, count) in parts {
        if !terms.is_empty() {
            terms.push(Term::Operator("+"));
        }
        terms.push(Term::word(match times {
            1 => count.name().to_owned(),
            _ => format!("{times} {}", count.name()),
        }));
    }
    Term::Row(terms)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_written_as_it_is_computed() {
        let plus = || Term::Operator("+");
        let dice = Measure::Dsc.info();
        assert_eq!(dice.symbol, Term::word("DSC"));
        let under = [
            Term::word("2 TP"),
            plus(),
            Term::word("FP"),
            plus(),
            Term::word("FN"),
        ];
        assert_eq!(
            dice.formula,
            Term::fraction(Term::row([Term::word("2 TP")]), Term::row(under))
        );
        assert_eq!((dice.range.as_str(), dice.most), ("0 to 1", Some(1.0)));
    }

    #[test]
    fn what_the_published_protocol_changes_follows_from_what_is_counted() {
        let published = |measure: Measure| measure.info().published;
        assert_eq!(published(Measure::Dsc), "");
        assert_eq!(published(Measure::Mfe), "");
        let tpr = published(Measure::Tpr);
        assert!(
            tpr.contains("defined as PPV") && tpr.ends_with("left out of the count."),
            "{tpr}"
        );
        // TPR, which stands under PPV, counts points of the true primitive alone.
        assert!(published(Measure::Ppv).ends_with("in the other order."));
        assert!(published(Measure::D1).contains("sign rule"));
    }

    #[test]
    fn every_measure_says_all_there_is_to_know() {
        for info in Measure::ALL.map(Measure::info) {
            assert!(
                !info.name.is_empty() && !info.section.is_empty(),
                "{info:?}"
            );
            assert!(
                info.meaning.ends_with('.') && info.mean.ends_with('.'),
                "{info:?}"
            );
            assert_ne!(info.formula, Term::row([]), "{info:?}");
        }
    }
}
