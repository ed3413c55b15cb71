//! The measures: for each what it is computed from and what is said of it. A row here is all it
//! takes to have one more in every report, table, chart and export.

use super::words::{Better, Words};
use super::{Published, Ratio, Source, Term, Undefined};
use crate::metrics::classification::Count::{
    FalseNegatives as FN, FalsePositives as FP, TrueNegatives as TN, TruePositives as TP,
};

macro_rules! measures {
    ($(
        $(#[$condition:meta])*
        $variant:ident $name:literal = $source:expr, $words:expr;
    )*) => {
        /// One of the measures of a submission: the paper's nine.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Measure {
            $(
                $(#[$condition])*
                #[doc = concat!($name, ": see [`Measure::info`].")]
                $variant,
            )*
        }

        impl Measure {
            /// All of them, in the order of the paper's tables.
            pub const ALL: [Self; Self::COUNT] = [$($(#[$condition])* Self::$variant,)*];

            /// How many there are.
            pub const COUNT: usize = [$($(#[$condition])* $name,)*].len();

            /// The paper's abbreviation.
            pub const fn name(self) -> &'static str {
                match self {
                    $($(#[$condition])* Self::$variant => $name,)*
                }
            }

            /// What it is computed from.
            pub const fn source(self) -> Source {
                match self {
                    $($(#[$condition])* Self::$variant => $source,)*
                }
            }

            /// Apart from the rest, so that a module that only scores holds no texts.
            pub(super) const fn words(self) -> Words {
                match self {
                    $($(#[$condition])* Self::$variant => $words,)*
                }
            }
        }
    };
}

/// Of points: what a ratio leaves to be said.
const POINTS: Words = Words {
    name: "",
    meaning: "",
    better: Better::Higher,
    symbol: None,
    formula: None,
    remark: "",
    logarithmic: false,
    section: "Quality indicators: Performance measures of the point classification",
    published: "",
};

/// Of surfaces.
const SURFACES: Words = Words {
    better: Better::Lower,
    section: "Quality indicators: Approximation accuracy",
    ..POINTS
};

/// Of distances to surfaces.
const DISTANCES: Words = Words {
    remark: "0.01 is one per cent of the primitive's size",
    ..SURFACES
};

measures! {
    Dsc "DSC" = Source::Points(Ratio {
        over: &[(2, TP)],
        under: &[(2, TP), (1, FP), (1, FN)],
        undefined: Undefined::Zero,
        published: Published::Whole,
    }),
    Words {
        name: "Sørensen–Dice index",
        meaning: "How well the matched primitive and the true one coincide, as one figure. Also \
                  called F₁ score.",
        ..POINTS
    };

    Ppv "PPV" = Source::Points(Ratio {
        over: &[(1, TP)],
        under: &[(1, TP), (1, FP)],
        undefined: Undefined::Zero,
        published: Published::Other(Measure::Tpr),
    }),
    Words {
        name: "Positive predictive value (precision)",
        meaning: "Share of the matched primitive's points that are right. Merging neighbours \
                  lowers it.",
        ..POINTS
    };

    Tpr "TPR" = Source::Points(Ratio {
        over: &[(1, TP)],
        under: &[(1, TP), (1, FN)],
        undefined: Undefined::Zero,
        published: Published::Other(Measure::Ppv),
    }),
    Words {
        name: "True positive rate (sensitivity)",
        meaning: "Share of the true primitive's points that were found. Splitting a primitive \
                  lowers it.",
        ..POINTS
    };

    Tnr "TNR" = Source::Points(Ratio {
        over: &[(1, TN)],
        under: &[(1, TN), (1, FP)],
        undefined: Undefined::LeftOut,
        published: Published::Other(Measure::Npv),
    }),
    Words {
        name: "True negative rate (specificity)",
        meaning: "Share of the points outside the true primitive that were left out. Near 1 \
                  whenever a primitive is small against its model.",
        ..POINTS
    };

    Npv "NPV" = Source::Points(Ratio {
        over: &[(1, TN)],
        under: &[(1, TN), (1, FN)],
        undefined: Undefined::ZeroAmongNegatives,
        published: Published::Other(Measure::Tnr),
    }),
    Words {
        name: "Negative predictive value",
        meaning: "Share of the points left out that really do not belong. Near 1 whenever a \
                  primitive is small against its model.",
        ..POINTS
    };

    Acc "ACC" = Source::Points(Ratio {
        over: &[(1, TP), (1, TN)],
        under: &[(1, TP), (1, TN), (1, FP), (1, FN)],
        undefined: Undefined::LeftOut,
        published: Published::Labelled,
    }),
    Words {
        name: "Accuracy",
        meaning: "Share of all decisions that are right. The many true negatives hold it near 1: \
                  read it beside DSC.",
        ..POINTS
    };

    #[cfg(feature = "one-more-measure")]
    Iou "IoU" = Source::Points(Ratio {
        over: &[(1, TP)],
        under: &[(1, TP), (1, FP), (1, FN)],
        undefined: Undefined::Zero,
        published: Published::Whole,
    }),
    Words {
        name: "Intersection over union (Jaccard index)",
        meaning: "How well the matched primitive and the true one coincide, harder than DSC on \
                  what is half right.",
        section: "Not in the paper",
        ..POINTS
    };

    Mfe "MFE" = Source::Distances(|accuracy| accuracy.mfe),
    Words {
        name: "Mean fitting error",
        meaning: "Mean distance of the predicted primitive's points to its own surface 𝒮, over \
                  the diagonal l of their bounding box.",
        formula: Some(|| {
            let size = Term::row([Term::Operator("|"), prediction(), Term::Operator("|")]);
            Term::row([
                Term::fraction(Term::Number(1), size),
                Term::under(Term::Operator("∑"), its_points()),
                relative_distance(),
            ])
        }),
        ..DISTANCES
    };

    DHaus "dHaus" = Source::Distances(|accuracy| accuracy.d_haus),
    Words {
        name: "Directed Hausdorff distance",
        meaning: "The worst distance of the predicted primitive's points to its own surface 𝒮, \
                  over the diagonal l of their bounding box.",
        symbol: Some(|| Term::sub(Term::Variable("d"), Term::word("dHaus"))),
        formula: Some(|| {
            Term::row([Term::under(Term::word("max"), its_points()), relative_distance()])
        }),
        ..DISTANCES
    };

    D1 "d1" = Source::Coefficients,
    Words {
        name: "Coefficient distance",
        meaning: "How far the implicit coefficients of prediction and truth are apart, both \
                  scaled to norm 1 and given the same sign.",
        symbol: Some(|| Term::sub(Term::Variable("d"), Term::Number(1))),
        formula: Some(|| {
            let bar = || Term::Operator("‖");
            let difference = [Term::Variable("v"), Term::Operator("−"), Term::Variable("v′")];
            let norm = [&[bar()], &difference[..], &[bar()]].concat();
            Term::sub(Term::row(norm), Term::Number(1))
        }),
        remark: "pairs of different type have none",
        logarithmic: true,
        published: "The published sign rule flips a vector when any pair of entries differs in \
                    sign, and primitives without a partner count as perfect. Most large published \
                    values are such flips.",
        ..SURFACES
    };
}

/// 𝒫_S, the points of the predicted primitive.
fn prediction() -> Term {
    Term::sub(Term::Variable("𝒫"), Term::Variable("S"))
}

/// x ∈ 𝒫_S.
fn its_points() -> Term {
    Term::row([Term::Variable("x"), Term::Operator("∈"), prediction()])
}

/// d(x, 𝒮) / l.
fn relative_distance() -> Term {
    let distance = [
        Term::Variable("d"),
        Term::Operator("("),
        Term::Variable("x"),
        Term::Operator(","),
        Term::Variable("𝒮"),
        Term::Operator(")"),
    ];
    Term::fraction(Term::row(distance), Term::Variable("l"))
}
