//! The figures: for each what it is computed from and what is said of it. A row here is all it takes
//! to have one more in the comparison of protocols, in exports and in `--help`.

use super::FigureSource;
use crate::metrics::Better;
use crate::metrics::segmentation::{fit4cad, hpnet, panoptic, parsenet, spfn};

/// What a figure is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureGroup {
    /// Which points belong together: a score of the segmentation by a protocol.
    Segmentation,
    /// How the predicted surfaces reproduce the true ones.
    Fit,
}

/// What is to be known about a figure, wherever it is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FigureInfo {
    /// Name by which it is asked for.
    pub key: &'static str,
    /// Head of its column.
    pub title: &'static str,
    /// What it is about.
    pub group: FigureGroup,
    /// What is computed.
    pub definition: &'static str,
    /// In one sentence, what kind of answer it rewards.
    pub rewards: &'static str,
    /// What one has to know before comparing.
    pub trap: &'static str,
    /// Where the rules are read off.
    pub source: &'static str,
    /// What it takes for the label of a point.
    pub labels: &'static str,
    /// The largest value, where there is one; the smallest is 0.
    pub most: Option<f64>,
    /// Which values are good.
    pub better: Better,
    /// Digits after the point that tell something.
    pub decimals: u8,
    /// Unit of its values: empty of shares, `°` of angles.
    pub unit: &'static str,
    /// Whether its values, or its ε, are lengths in units of the normalisation.
    pub is_normalised: bool,
}

const SETS: &str = "Sets: a point of several primitives is a member of each. The original reads one \
                    label a point.";

/// Of segmentation.
const SHARE: FigureInfo = FigureInfo {
    key: "",
    title: "",
    group: FigureGroup::Segmentation,
    definition: "",
    rewards: "",
    trap: "",
    source: "",
    labels: SETS,
    most: Some(1.0),
    better: Better::Higher,
    decimals: 4,
    unit: "",
    is_normalised: false,
};

/// Of surfaces.
const FIT: FigureInfo = FigureInfo {
    group: FigureGroup::Fit,
    labels: "True and predicted primitives are matched one to one by IoU, as sets.",
    source: "lingxiaoli94/SPFN, spfn/lib/evaluation.py",
    ..SHARE
};

/// Errors of surfaces.
const ERROR: FigureInfo = FigureInfo {
    most: None,
    better: Better::Lower,
    ..FIT
};

/// Angles.
const ANGLE: FigureInfo = FigureInfo {
    most: Some(90.0),
    decimals: 2,
    unit: "°",
    ..ERROR
};

macro_rules! figures {
    ($($variant:ident $name:literal $title:literal = $source:expr, $info:expr;)*) => {
        /// One of the figures that the field reports.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Figure {
            $(
                #[doc = concat!($title, ": see [`Figure::info`].")]
                $variant,
            )*
        }

        impl Figure {
            /// All of them: scores of the segmentation first.
            pub const ALL: [Self; Self::COUNT] = [$(Self::$variant,)*];

            /// How many there are.
            pub const COUNT: usize = [$($name,)*].len();

            /// Name by which it is asked for.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// The figure of that name.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|figure| figure.name() == name)
            }

            /// What it is computed from.
            pub const fn source(self) -> FigureSource {
                match self {
                    $(Self::$variant => $source,)*
                }
            }

            /// What every face needs to show it. Apart from the rest, so that a module that only scores
            /// holds no texts.
            pub const fn info(self) -> FigureInfo {
                match self {
                    $(Self::$variant => FigureInfo { key: $name, title: $title, ..$info },)*
                }
            }
        }
    };
}

figures! {
    Fit4cad "fit4cad" "Fit4CAD DSC" = FigureSource::Overlaps(fit4cad::score), FigureInfo {
        definition: "Each true primitive takes the predicted one with which it shares most points; the \
                     mean of their Sørensen–Dice index over all true primitives, 0 without a match.",
        rewards: "Covering every true primitive with some prediction, even one that serves several.",
        trap: "One prediction may serve many true primitives, and what serves none costs nothing.",
        source: "Fit4CAD, section Quality indicators; the measure DSC of both protocols",
        labels: "Sets: a point of several primitives is a member of each.",
        ..SHARE
    };

    Spfn "spfn" "SPFN" = FigureSource::Overlaps(spfn::score), FigureInfo {
        definition: "Matched one to one for the largest sum of IoU; the mean of IoU over all true \
                     primitives, 0 without a partner.",
        rewards: "Finding every true primitive once and whole, the small as much as the large.",
        trap: "Predictions without a partner cost nothing. The original skips shapes of more than 24 \
               primitives; they are scored here.",
        source: "lingxiaoli94/SPFN, spfn/lib/evaluation.py: hungarian_matching, compute_miou_loss",
        ..SHARE
    };

    SpfnLarge "spfn-large" "SPFN, < 0.5 % removed" = FigureSource::Overlaps(spfn::score_without_small),
    FigureInfo {
        definition: "As SPFN, once predictions of fewer than 0.5 % of the cloud's points are removed.",
        rewards: "Finding the large primitives; small ones cannot be found at all.",
        trap: "The truth itself does not score 1 where the part has faces that small.",
        source: "lingxiaoli94/SPFN, spfn/lib/evaluation.py: nn_filter_W",
        ..SHARE
    };

    ParseNet "parsenet" "ParseNet" = FigureSource::Overlaps(parsenet::score), FigureInfo {
        definition: "The first 50 primitives of either side matched one to one for the largest sum of \
                     IoU; the mean of IoU over the pairs whose true primitive has at least 100 points.",
        rewards: "Being right about what is predicted: few safe primitives beat many daring ones.",
        trap: "True primitives without a partner do not count, so one perfect face alone scores 1; \
               those after the fiftieth and those of fewer than 100 points do not exist.",
        source: "Hippogriff/parsenet-codebase, src/segment_utils.py: SIOU_matched_segments, \
                 mean_IOU_primitive_segment, to_one_hot",
        ..SHARE
    };

    HpNet "hpnet" "HPNet" = FigureSource::Overlaps(hpnet::score), FigureInfo {
        definition: "True primitives of at most 100 points become background; matched one to one for \
                     the largest sum of IoU, the mean over as many pairs as the shorter side has.",
        rewards: "Being right about what is predicted, with no prediction to spare.",
        trap: "One perfect face alone scores 1: true primitives without a partner do not count where \
               predictions are fewer.",
        source: "SimingYan/HPNet, utils/loss_utils.py: hungarian_matching, compute_miou",
        ..SHARE
    };

    F1 "f1" "F1@0.5" = FigureSource::Overlaps(panoptic::f1), FigureInfo {
        definition: "A true and a predicted primitive with IoU > 0.5 are a hit; twice the hits over \
                     the number of all primitives of both sides.",
        rewards: "The right number of primitives, each more than half right: missing and inventing \
                  cost the same.",
        trap: "How well a hit coincides does not show.",
        source: "Kirillov et al. 2019, Panoptic Segmentation: recognition quality, types ignored",
        labels: "Sets: a point of several primitives is a member of each.",
        ..SHARE
    };

    Pq "pq" "PQ" = FigureSource::Overlaps(panoptic::quality), FigureInfo {
        definition: "The sum of IoU over the hits (IoU > 0.5), over half the number of all primitives \
                     of both sides.",
        rewards: "The right primitives in the right number, each as exact as can be.",
        trap: "The strict one: what is half right counts as wrong twice, missed and invented.",
        source: "Kirillov et al. 2019, Panoptic Segmentation: panoptic quality, types ignored",
        labels: "Sets: a point of several primitives is a member of each.",
        ..SHARE
    };

    Nvdnet "nvdnet" "NVDNet F1" = FigureSource::Detection(|found| found.f1), FigureInfo {
        definition: "Matched one to one for the smallest sum of mean nearest distances, both ways and \
                     halved; the mean of F1 over hits nearer than 0.005, 0.01, 0.02, 0.05 and 0.1 of \
                     the unit cube.",
        rewards: "A primitive about where each true one is; exact borders hardly matter.",
        trap: "It needs a unit, here the longest side of the cloud's box. A thin face found as part of \
               its neighbour is a hit at the wide thresholds.",
        source: "yilinliu77/NVDNet, src/evaluate/evaluate.cpp: the block Surfaces, pr_compute",
        labels: "Sets; primitives without points do not exist.",
        ..SHARE
    };

    PCoverage "p-coverage" "P-coverage" = FigureSource::Geometry(|fit| fit.p_coverage), FigureInfo {
        definition: "Share of the cloud's points within ε of any predicted surface.",
        rewards: "Surfaces that pass near every point, whether or not they are the right ones.",
        trap: "Surfaces are endless: a few large planes cover much of a part. It hangs on ε and on the \
               unit of ε.",
        is_normalised: true,
        ..FIT
    };

    SCoverage "s-coverage" "S-coverage" = FigureSource::Geometry(|fit| fit.s_coverage), FigureInfo {
        definition: "Mean over all true primitives of the share of their samples within ε of the \
                     matched surface, 0 without a match. Samples are the primitive's points on its true \
                     surface.",
        rewards: "The right surface for every true primitive, whatever points it was found from.",
        trap: "It hangs on ε and on the unit of ε.",
        is_normalised: true,
        ..FIT
    };

    Residual "residual" "Residual" = FigureSource::Geometry(|fit| fit.residual), FigureInfo {
        definition: "Mean over the matched true primitives of the mean distance of their samples to the \
                     matched surface.",
        rewards: "Surfaces near the true ones, of those primitives that were found at all.",
        trap: "What was missed does not count. SPFN's code squares the distance, CPFN's adds 10⁻¹⁰ \
               under the root: here it is the distance.",
        decimals: 5,
        is_normalised: true,
        ..ERROR
    };

    ResidualRms "residual-rms" "Residual (RMS)" = FigureSource::Geometry(|fit| fit.residual_rms),
    FigureInfo {
        definition: "Mean over the matched true primitives of the root mean square distance of their \
                     samples to the matched surface.",
        rewards: "Surfaces that are nowhere far from the true ones.",
        trap: "What was missed does not count; a few primitives of the wrong type decide it.",
        decimals: 5,
        is_normalised: true,
        ..ERROR
    };

    NormalError "normal" "Normal error" = FigureSource::Geometry(|fit| fit.normal_error), FigureInfo {
        definition: "Mean over the matched true primitives of the mean angle between true and matched \
                     surface at their samples; sides are not told apart.",
        rewards: "Surfaces that lie as the true ones do.",
        trap: "SPFN takes normals predicted for each point; these are those of the predicted surfaces.",
        ..ANGLE
    };

    AxisError "axis" "Axis error" = FigureSource::Geometry(|fit| fit.axis_error), FigureInfo {
        definition: "Mean angle between true and predicted axis (of planes the normal) over the matched \
                     pairs of the right type; spheres count as 0.",
        rewards: "Exact directions of what was typed right.",
        trap: "Pairs of the wrong type do not count. CPFN prints a ratio under this name, no angle.",
        ..ANGLE
    };

    RadiusError "radius" "Radius error" = FigureSource::Geometry(|fit| fit.radius_error), FigureInfo {
        definition: "Mean difference of radii over the matched pairs of cylinders, spheres and tori; of \
                     a torus the mean of both.",
        rewards: "Exact radii of what was typed right.",
        trap: "Pairs of the wrong type do not count; radii of barely curved pieces are large and \
               uncertain.",
        source: "the parameters of the Fit4CAD paper's appendix",
        decimals: 5,
        is_normalised: true,
        ..ERROR
    };

    AngleError "angle" "Cone angle error" = FigureSource::Geometry(|fit| fit.angle_error), FigureInfo {
        definition: "Mean difference of half-angles over the matched pairs of cones.",
        rewards: "Exact cones among what was typed right.",
        trap: "Few parts have cones: mind over how many models the mean runs.",
        source: "the parameters of the Fit4CAD paper's appendix",
        ..ANGLE
    };

    TypeAccuracy "type" "Type accuracy" = FigureSource::Geometry(|fit| fit.type_accuracy), FigureInfo {
        definition: "Share of the matched pairs that are of the same type, where both are known.",
        rewards: "The right type of what was found.",
        trap: "What was missed does not count. ParseNet calls such a share type IoU.",
        ..FIT
    };
}
