//! What the rest of the field reports of a submission, as plain objects.

use fit4cad::metrics::{self, field_report, geometry};
use serde::{Deserialize, Serialize, Serializer};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;
use crate::primitive::SurfaceType;
use crate::report::TypeConfusion;
use crate::summary::Distribution;

/// How lengths are given, and what counts as near.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Tsify)]
pub struct FigureScale {
    /// What every length is divided by.
    pub normalisation: String,
    /// ε of the coverages, in units of the normalisation.
    pub epsilon: f64,
}

/// The figures by their keys; `null` where one cannot be had.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(transparent)]
pub struct Figures(
    #[serde(serialize_with = "by_key")]
    #[tsify(type = "Record<Figure, number | null>")]
    metrics::Figures,
);

fn by_key<S: Serializer>(figures: &metrics::Figures, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(figures.iter().map(|(figure, value)| (figure.name(), value)))
}

/// How one true primitive fares.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct FieldRow {
    /// Its number in the file.
    pub truth: u32,
    /// Its type, where it is one of the five.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// How many points of the cloud it lists.
    pub size: u32,
    /// How large that is, in words.
    pub stratum: &'static str,
    /// IoU with its one-to-one partner; 0 without one.
    pub iou: f64,
}

/// What the field reports of one submission.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
// A map is to be a plain object too.
#[tsify(missing_as_null, hashmap_as_object)]
pub struct FieldReport {
    /// Name of the model.
    pub model: String,
    /// Name of the method.
    pub method: String,
    /// How lengths are given.
    pub scale: FigureScale,
    /// The figures.
    pub figures: Figures,
    /// Types of true primitives against types of their one-to-one partners.
    pub types: TypeConfusion,
    /// One row per true primitive.
    pub primitives: Vec<FieldRow>,
}

#[wasm_bindgen]
impl Model {
    /// Computes what the rest of the field reports of the submission of a method, or of the truth
    /// against itself as method `truth`.
    ///
    /// # Errors
    /// If there is no such submission, no truth, no such normalisation, or ε is negative.
    pub fn field(
        &self,
        method: Option<String>,
        scale: Ts<FigureScale>,
    ) -> Result<Ts<FieldReport>, JsError> {
        let (scale, wanted) = (scale.to_rust()?, method.as_deref());
        let (truth, predicted) = (self.segmentation(None)?, self.segmentation(wanted)?);
        let found = field_report(&self.model.cloud, truth, predicted, scale.known()?);
        hand_over(&FieldReport::new(
            &self.model.name,
            wanted.unwrap_or("truth"),
            &found,
        ))
    }
}

impl FigureScale {
    fn known(&self) -> Result<geometry::Scale, JsError> {
        if !(self.epsilon >= 0.0 && self.epsilon.is_finite()) {
            return Err(JsError::new("ε is a number of at least 0"));
        }
        Ok(geometry::Scale {
            normalisation: self.normalisation.parse()?,
            epsilon: self.epsilon,
        })
    }
}

impl From<geometry::Scale> for FigureScale {
    fn from(scale: geometry::Scale) -> Self {
        Self {
            normalisation: scale.normalisation.name().to_owned(),
            epsilon: scale.epsilon,
        }
    }
}

impl FieldReport {
    pub(crate) fn new(model: &str, method: &str, report: &metrics::FieldReport) -> Self {
        let rows = report.rows.iter().map(|row| FieldRow {
            truth: row.number,
            kind: row.kind.map(SurfaceType::from),
            size: row.size as u32,
            stratum: row.stratum.name(),
            iou: row.iou,
        });
        Self {
            model: model.to_owned(),
            method: method.to_owned(),
            scale: report.scale.into(),
            figures: Figures(report.figures),
            types: TypeConfusion::from(&report.types),
            primitives: rows.collect(),
        }
    }
}

/// How values are spread over models, with how certain their mean is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
// A flattened struct is written as a map, which is to be a plain object too.
#[tsify(missing_as_null, hashmap_as_object)]
pub struct FigureSpread {
    /// How they are spread.
    #[serde(flatten)]
    pub over: Distribution,
    /// The bootstrap 95 % interval of the mean; `null` for one value.
    pub interval: Option<[f64; 2]>,
}

/// How values are spread; absent where none is a number. NaN stands for one that cannot be had.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen]
pub fn distribution(values: &[f64]) -> Result<Option<Ts<FigureSpread>>, JsError> {
    let found = metrics::Distribution::of(values.iter().copied());
    found
        .map(|found| {
            hand_over(&FigureSpread {
                over: found.into(),
                interval: metrics::bootstrap::mean_interval(values.iter().copied()),
            })
        })
        .transpose()
}
