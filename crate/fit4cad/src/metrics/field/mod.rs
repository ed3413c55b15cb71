//! What the rest of the field reports of a submission, beside the benchmark's measures: scores of the
//! segmentation by each protocol and figures of fit, by name.

mod conditions;
mod declared;
mod strata;

use std::fmt;
use std::ops::Index;

pub use conditions::Conditions;
pub use declared::{Figure, FigureGroup, FigureInfo};
pub use strata::{By, UNKNOWN};

use super::geometry::{self, Geometry, Scale};
use super::hidden::TypeConfusion;
use super::segmentation::assignment::{Partner, most_iou};
use super::segmentation::nvdnet::{self, Detection};
use super::segmentation::overlaps::Overlaps;
use crate::cloud::Cloud;
use crate::model::Segmentation;
use crate::surface::SurfaceType;

/// What a figure is computed from.
#[derive(Debug, Clone, Copy)]
pub enum FigureSource {
    /// The overlaps of the two segmentations.
    Overlaps(fn(&Overlaps) -> Option<f64>),
    /// How many primitives NVDNet's rules detect.
    Detection(fn(&Detection) -> f64),
    /// The predicted surfaces against the true ones.
    Geometry(fn(&Geometry) -> Option<f64>),
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A value for each figure; `None` where it cannot be had.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Figures([Option<f64>; Figure::COUNT]);

impl Figures {
    /// Each figure with its value, in the order of [`Figure::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Figure, Option<f64>)> {
        Figure::ALL.into_iter().zip(self.0)
    }
}

impl Index<Figure> for Figures {
    type Output = Option<f64>;

    fn index(&self, figure: Figure) -> &Option<f64> {
        &self.0[figure as usize]
    }
}

/// How one true primitive fares, whatever protocol averages it: what strata are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldRow {
    /// Its number in the file.
    pub number: u32,
    /// Its type, where it is one of the five.
    pub kind: Option<SurfaceType>,
    /// How many points of the cloud it lists.
    pub size: usize,
    /// By how much of the cloud it is a small or a large one.
    pub stratum: Size,
    /// IoU with its one-to-one partner; 0 without one.
    pub iou: f64,
}

/// How much of its cloud a primitive has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Size {
    /// Below 0.5 %: what SPFN's rule removes from predictions.
    Tiny,
    /// 0.5 % to below 2 %.
    Small,
    /// 2 % to below 10 %.
    Medium,
    /// 10 % and more.
    Large,
}

impl Size {
    /// All of them, smallest first.
    pub const ALL: [Self; 4] = [Self::Tiny, Self::Small, Self::Medium, Self::Large];

    /// The stratum of a number of points among those of the cloud.
    pub fn of(size: usize, points: usize) -> Self {
        let is_below =
            |per_mille: usize| size.saturating_mul(1000) < points.saturating_mul(per_mille);
        match () {
            () if is_below(5) => Self::Tiny,
            () if is_below(20) => Self::Small,
            () if is_below(100) => Self::Medium,
            () => Self::Large,
        }
    }

    /// In words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tiny => "< 0.5 % of the points",
            Self::Small => "0.5 – 2 %",
            Self::Medium => "2 – 10 %",
            Self::Large => "≥ 10 %",
        }
    }
}

/// What the field reports of one submission.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldReport {
    /// How lengths are given.
    pub scale: Scale,
    /// The figures.
    pub figures: Figures,
    /// Types of true primitives against types of their one-to-one partners.
    pub types: TypeConfusion,
    /// One row per true primitive, in their order.
    pub rows: Vec<FieldRow>,
}

/// Computes every figure. Where lists are so entangled that primitives cannot be matched one to one
/// (see [`Overlaps::of`]), what follows from that matching is `None`.
///
/// ```
/// use fit4cad::metrics::geometry::Scale;
/// use fit4cad::metrics::{Figure, field_report};
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let model = generate("flange", &options)?;
/// let truth = model.truth.unwrap_or_default();
/// let report = field_report(&model.cloud, &truth, &truth, Scale::default());
/// assert_eq!(report.figures[Figure::Spfn], Some(1.0));
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn field_report(
    cloud: &Cloud,
    truth: &Segmentation,
    predicted: &Segmentation,
    scale: Scale,
) -> FieldReport {
    let overlaps = Overlaps::of(cloud.len(), truth, predicted);
    let partners = overlaps
        .as_ref()
        .and_then(|overlaps| most_iou(overlaps, &|_| true));
    let geometry = partners
        .as_ref()
        .map(|partners| geometry::measure(cloud, truth, predicted, partners, scale));
    let detection = nvdnet::score(cloud, truth, predicted);
    let value = |figure: Figure| match figure.source() {
        FigureSource::Overlaps(of) => overlaps.as_ref().and_then(of),
        FigureSource::Detection(of) => detection.as_ref().map(of),
        FigureSource::Geometry(of) => geometry.as_ref().and_then(of),
    };
    let rows = match (&overlaps, &partners) {
        (Some(overlaps), Some(partners)) => rows(cloud, truth, overlaps, partners),
        _ => Vec::new(),
    };
    FieldReport {
        scale,
        figures: Figures(Figure::ALL.map(value)),
        types: geometry.map(|geometry| geometry.types).unwrap_or_default(),
        rows,
    }
}

fn rows(
    cloud: &Cloud,
    truth: &Segmentation,
    overlaps: &Overlaps,
    partners: &[Option<Partner>],
) -> Vec<FieldRow> {
    let rows = truth.primitives.iter().zip(&overlaps.truth).zip(partners);
    rows.map(|((primitive, &size), partner)| FieldRow {
        number: primitive.number,
        kind: primitive.kind,
        size,
        stratum: Size::of(size, cloud.len()),
        iou: partner.map_or(0.0, |partner| partner.iou),
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strata_begin_where_they_say() {
        let of = |size| Size::of(size, 1000);
        assert_eq!(
            [0, 4, 5, 19].map(of),
            [Size::Tiny, Size::Tiny, Size::Small, Size::Small]
        );
        assert_eq!(
            [20, 99, 100, 1000].map(of),
            [Size::Medium, Size::Medium, Size::Large, Size::Large]
        );
    }

    #[test]
    fn every_figure_has_its_own_name_and_says_what_it_is() {
        let mut names: Vec<&str> = Figure::ALL.iter().map(|figure| figure.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Figure::COUNT);
        for figure in Figure::ALL {
            let info = figure.info();
            for text in [
                info.title,
                info.definition,
                info.rewards,
                info.trap,
                info.source,
                info.labels,
            ] {
                assert!(!text.is_empty(), "{figure}");
            }
            assert_eq!(Figure::from_name(figure.name()), Some(figure));
        }
    }

    #[test]
    fn a_made_part_is_all_right_by_itself_and_nothing_by_nothing() {
        let part = crate::sample::parts()[0].name;
        let model = crate::sample::generate(part, &crate::sample::Options::default()).unwrap();
        let truth = model.truth.as_ref().unwrap();
        let report = field_report(&model.cloud, truth, truth, Scale::default());
        for (figure, value) in report.figures.iter() {
            let perfect = match figure.info().better {
                crate::metrics::Better::Higher => 1.0,
                crate::metrics::Better::Lower => 0.0,
            };
            if figure != Figure::SpfnLarge {
                assert!(
                    value.is_none_or(|value| (value - perfect).abs() < 1e-6),
                    "{figure}: {value:?}"
                );
            }
        }
        let nothing = field_report(
            &model.cloud,
            truth,
            &Segmentation::default(),
            Scale::default(),
        );
        for figure in Figure::ALL {
            if figure.info().group == FigureGroup::Segmentation {
                assert_eq!(nothing.figures[figure], Some(0.0), "{figure}");
            }
        }
    }
}
