//! How a part becomes a cloud, as JavaScript says it.

use fit4cad_step::{Amount, Options, Spread};
use serde::Deserialize;
use tsify::Tsify;
use wasm_bindgen::JsError;

/// How a part becomes a cloud; what is left out is as [`crate::import_options`] declares.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Tsify)]
#[serde(default, deny_unknown_fields)]
pub struct ImportOptions {
    /// How many points; not beside a spacing.
    #[tsify(optional)]
    pub points: Option<u32>,
    /// About how far neighbours lie apart, in millimetres.
    #[tsify(optional)]
    pub spacing: Option<f64>,
    /// Fewest points of a face.
    #[tsify(optional)]
    pub least: Option<u32>,
    /// Seed of everything random.
    #[tsify(optional)]
    pub seed: Option<u64>,
    /// How they are spread: `even`, `random` or `scan`.
    #[tsify(optional, type = "\"even\" | \"random\" | \"scan\"")]
    pub spread: Option<String>,
    /// Of a scan, how many viewpoints there are.
    #[tsify(optional)]
    pub views: Option<u32>,
    /// Whether free-form faces that are of one of the five families stay unsegmented.
    #[tsify(optional)]
    pub named: Option<bool>,
    /// Whether faces that nothing outside sees have no points.
    #[tsify(optional)]
    pub outer: Option<bool>,
    /// Whether faces of one surface that touch stay primitives of their own.
    #[tsify(optional)]
    pub separate: Option<bool>,
}

impl ImportOptions {
    pub(crate) fn known(&self) -> Result<Options, JsError> {
        let usual = Options::default();
        let amount = match (self.points, self.spacing) {
            (Some(_), Some(_)) => return Err(JsError::new("give points or spacing, not both")),
            (Some(points), None) => Amount::Points(points as usize),
            (None, Some(spacing)) => Amount::Spacing(spacing),
            (None, None) => usual.amount,
        };
        let spread = match self.spread.as_deref() {
            None => usual.spread,
            Some("even") => Spread::Even,
            Some("random") => Spread::Random,
            Some("scan") => Spread::Scan,
            Some(other) => {
                return Err(JsError::new(&format!(
                    "spread must be even, random or scan, not {other}"
                )));
            }
        };
        Ok(Options {
            amount,
            spread,
            views: self.views.map_or(usual.views, |views| views as usize),
            least: self.least.map_or(usual.least, |least| least as usize),
            seed: self.seed.unwrap_or(usual.seed),
            recognise: !self.named.unwrap_or(!usual.recognise),
            inner: !self.outer.unwrap_or(!usual.inner),
            join: !self.separate.unwrap_or(!usual.join),
        })
    }
}
