//! What a submission makes of single points: labels and distances to look at.

use fit4cad::metrics::histogram::{Bins, farthest};
use fit4cad::metrics::outcome::{figure, outcomes};
use fit4cad::model::Primitive;
use js_sys::{Float64Array, Uint32Array};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;

/// Whose distances a histogram counts.
#[derive(Debug, Clone, Deserialize, Tsify)]
pub struct Counted {
    /// The method; absent for the truth.
    #[serde(default)]
    #[tsify(optional)]
    pub method: Option<String>,
    /// Places of the primitives.
    pub places: Vec<u32>,
}

/// Distances to surfaces, counted.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct Histogram {
    /// Bounds of the intervals, one more than there are. The first takes all that is smaller as
    /// well, the upper bound of the last belongs to it.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float64Array")]
    pub edges: Float64Array,
    /// For each of those asked for, a row of counts per primitive, one after the other.
    #[tsify(type = "Uint32Array[]")]
    pub counts: Vec<Preserved>,
}

/// A typed array within a list.
#[derive(Debug, Clone, Serialize)]
#[serde(transparent)]
pub struct Preserved(#[serde(with = "serde_wasm_bindgen::preserve")] Uint32Array);

#[wasm_bindgen]
impl Model {
    /// What each point is for the true and the predicted primitive at these places: 0
    /// in neither, 1 in both, 2 predicted alone, 3 of the truth alone (the numbers of
    /// [`PointOutcome`](fit4cad::metrics::outcome::PointOutcome)). A place that is absent, or of no
    /// primitive, lists nothing.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn outcomes(
        &self,
        method: Option<String>,
        truth: Option<u32>,
        predicted: Option<u32>,
    ) -> Result<Uint32Array, JsError> {
        let list = |of: Option<&str>, place: Option<u32>| -> Result<&[u32], JsError> {
            let primitives = &self.segmentation(of)?.primitives;
            let primitive = place.and_then(|place| primitives.get(place as usize));
            Ok(primitive.map_or(&[], |primitive| &primitive.points))
        };
        let (truth, predicted) = (list(None, truth)?, list(method.as_deref(), predicted)?);
        let found = outcomes(self.model.cloud.len(), truth, predicted);
        let numbers: Vec<u32> = found.into_iter().map(|outcome| outcome as u32).collect();
        Ok(Uint32Array::from(numbers.as_slice()))
    }

    /// The paper's figure of a submission as a label per point: 0 where nothing is predicted, i + 1
    /// where the true primitive at place i was rightly found, and one more than there are true
    /// primitives where what is predicted is wrong.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn figure(&self, method: String) -> Result<Uint32Array, JsError> {
        let truth = self.segmentation(None)?;
        let labels = figure(
            self.model.cloud.len(),
            truth,
            self.segmentation(Some(&method))?,
        );
        Ok(Uint32Array::from(labels.as_slice()))
    }

    /// Counts the distances of points to the surfaces of their primitives, all on one scale: from 0
    /// to the largest in equal intervals, or from a millionth of it in intervals of equal ratio.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn histogram(
        &self,
        wanted: Vec<Ts<Counted>>,
        bins: u32,
        logarithmic: bool,
    ) -> Result<Ts<Histogram>, JsError> {
        let chosen = self.counted(&wanted)?;
        let bins = self.bins(&chosen, bins, logarithmic);
        let count = |primitives: &Vec<&Primitive>| {
            let primitives = primitives.iter();
            let counts = primitives.flat_map(|primitive| bins.counts(&self.model, primitive));
            Preserved(Uint32Array::from(counts.collect::<Vec<u32>>().as_slice()))
        };
        hand_over(&Histogram {
            edges: Float64Array::from(bins.edges().collect::<Vec<f64>>().as_slice()),
            counts: chosen.iter().map(count).collect(),
        })
    }

    /// For each of those asked for, the indices, ascending and each once, of the points whose distance
    /// is in the intervals `first` to `last` of [`Model::histogram`] of the same.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    #[wasm_bindgen(js_name = pointsInBins)]
    pub fn points_in_bins(
        &self,
        wanted: Vec<Ts<Counted>>,
        bins: u32,
        logarithmic: bool,
        first: u32,
        last: u32,
    ) -> Result<Vec<Uint32Array>, JsError> {
        let chosen = self.counted(&wanted)?;
        let bins = self.bins(&chosen, bins, logarithmic);
        let intervals = first as usize..=last as usize;
        let points = |primitives: &Vec<&Primitive>| {
            let primitives = primitives.iter().copied();
            let found = bins.points_in(&self.model, primitives, &intervals);
            Uint32Array::from(found.as_slice())
        };
        Ok(chosen.iter().map(points).collect())
    }

    /// The largest distance of a listed point to the surface of its primitive; 0 where there is none.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn farthest(&self, method: Option<String>) -> Result<f64, JsError> {
        let primitives = &self.segmentation(method.as_deref())?.primitives;
        Ok(farthest(&self.model, primitives))
    }
}

impl Model {
    /// The primitives that are asked for, in their order.
    fn counted(&self, wanted: &[Ts<Counted>]) -> Result<Vec<Vec<&Primitive>>, JsError> {
        let mut chosen: Vec<Vec<&Primitive>> = Vec::new();
        for of in wanted {
            let of = of.to_rust()?;
            let primitives = &self.segmentation(of.method.as_deref())?.primitives;
            let places = of.places.iter();
            let found = places.filter_map(|&place| primitives.get(place as usize));
            chosen.push(found.collect());
        }
        Ok(chosen)
    }

    fn bins(&self, chosen: &[Vec<&Primitive>], count: u32, logarithmic: bool) -> Bins {
        let limit = farthest(&self.model, chosen.iter().flatten().copied());
        Bins::new(count as usize, limit, logarithmic)
    }
}
