//! What a set of models holds: types of surfaces, sizes, share of points that no primitive lists.
//!
//! The counts of [`DatasetStatistics::types`] for the training and the test set are the paper's two
//! bar charts (section "The benchmark", figure "Surface type distribution").

use crate::metrics::Distribution;
use crate::model::{Model, Segmentation};
use crate::surface::SurfaceType;

/// How many primitives there are of each type: those of [`SurfaceType::ALL`] in that order, then
/// those of another type or of none.
pub type TypeCounts = [usize; SurfaceType::ALL.len() + 1];

/// Counts the primitives of a segmentation by type.
pub fn types_of(segmentation: &Segmentation) -> TypeCounts {
    let mut types = TypeCounts::default();
    for primitive in &segmentation.primitives {
        let is_kind = |kind: &SurfaceType| Some(*kind) == primitive.kind;
        let column = SurfaceType::ALL.iter().position(is_kind);
        if let Some(count) = types.get_mut(column.unwrap_or(SurfaceType::ALL.len())) {
            *count += 1;
        }
    }
    types
}

/// One model in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelStatistics {
    /// Its name.
    pub name: String,
    /// Number of points.
    pub points: usize,
    /// Number of points that at least one true primitive lists; `None` without truth.
    pub segmented: Option<usize>,
    /// Number of points that several true primitives list, usually along edges.
    pub shared: usize,
    /// True primitives by type.
    pub types: TypeCounts,
}

impl ModelStatistics {
    /// Counts a model. O(points + points listed).
    pub fn of(model: &Model) -> Self {
        let types = model.truth.as_ref().map_or(TypeCounts::default(), types_of);
        let mut listed = vec![0u8; model.cloud.len()];
        for primitive in model.truth.iter().flat_map(|truth| &truth.primitives) {
            for &index in &primitive.points {
                if let Some(times) = listed.get_mut(index as usize) {
                    *times = times.saturating_add(1);
                }
            }
        }
        let times = |least: u8| listed.iter().filter(|&&times| times >= least).count();
        Self {
            name: model.name.clone(),
            points: model.cloud.len(),
            segmented: model.truth.as_ref().map(|_| times(1)),
            shared: times(2),
            types,
        }
    }

    /// Number of true primitives.
    pub fn primitives(&self) -> usize {
        self.types.iter().sum()
    }

    /// Share of the points that no true primitive lists; `None` without points or truth.
    pub fn unsegmented(&self) -> Option<f64> {
        let unsegmented = self.points.checked_sub(self.segmented?)?;
        (self.points > 0).then(|| unsegmented as f64 / self.points as f64)
    }
}

/// A set of models in numbers. Models without truth count among the models and points only.
#[derive(Debug, Clone, PartialEq)]
pub struct DatasetStatistics {
    /// Number of models.
    pub models: usize,
    /// Number of points of all models.
    pub points: usize,
    /// Number of true primitives of all models.
    pub primitives: usize,
    /// True primitives by type.
    pub types: TypeCounts,
    /// Share of all points that no true primitive lists, over the models that have a truth.
    pub unsegmented: Option<f64>,
    /// Number of points that several true primitives list.
    pub shared: usize,
    /// Points of a model.
    pub points_per_model: Option<Distribution>,
    /// True primitives of a model.
    pub primitives_per_model: Option<Distribution>,
    /// Share of a model's points that no true primitive lists.
    pub unsegmented_per_model: Option<Distribution>,
}

impl DatasetStatistics {
    /// The share that each type has of the true primitives; `None` without any.
    pub fn type_shares(&self) -> Option<[f64; SurfaceType::ALL.len() + 1]> {
        let whole = self.primitives as f64;
        (self.primitives > 0).then(|| self.types.map(|count| count as f64 / whole))
    }

    /// Sums up models. O(n log n) in their number.
    ///
    /// ```
    /// use fit4cad::sample::{Options, generate};
    /// use fit4cad::statistics::{DatasetStatistics, ModelStatistics};
    /// let options = Options { spacing: 0.02, ..Options::default() };
    /// let model = generate("flange", &options)?;
    /// let set = DatasetStatistics::of(&[ModelStatistics::of(&model)]);
    /// assert_eq!((set.models, set.points), (1, model.cloud.len()));
    /// # Ok::<(), fit4cad::sample::SampleError>(())
    /// ```
    pub fn of(models: &[ModelStatistics]) -> Self {
        let mut types = TypeCounts::default();
        for model in models {
            for (sum, count) in types.iter_mut().zip(&model.types) {
                *sum += count;
            }
        }
        let with_truth = || models.iter().filter(|model| model.segmented.is_some());
        let all: usize = with_truth().map(|model| model.points).sum();
        let segmented: usize = with_truth().filter_map(|model| model.segmented).sum();
        Self {
            models: models.len(),
            points: models.iter().map(|model| model.points).sum(),
            primitives: types.iter().sum(),
            types,
            shared: models.iter().map(|model| model.shared).sum(),
            unsegmented: (all > 0).then(|| all.saturating_sub(segmented) as f64 / all as f64),
            points_per_model: Distribution::of(models.iter().map(|model| model.points as f64)),
            primitives_per_model: Distribution::of(
                with_truth().map(|model| model.primitives() as f64),
            ),
            unsegmented_per_model: Distribution::of(models.iter().filter_map(|m| m.unsegmented())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Cloud, Point};
    use crate::model::{Primitive, Segmentation};

    fn model(points: usize, lists: &[(&[u32], Option<SurfaceType>)]) -> Model {
        let primitives = lists.iter().map(|(points, kind)| Primitive {
            points: points.to_vec(),
            kind: *kind,
            ..Primitive::default()
        });
        Model {
            cloud: Cloud::new(vec![Point::origin(); points]),
            truth: Some(Segmentation {
                primitives: primitives.collect(),
            }),
            ..Model::default()
        }
    }

    #[test]
    fn types_and_points_are_counted() {
        let (plane, torus) = (Some(SurfaceType::Plane), Some(SurfaceType::Torus));
        let lists: [(&[u32], _); 4] = [
            (&[0, 1, 2], plane),
            (&[2, 3], plane),
            (&[4], torus),
            (&[5], None),
        ];
        let statistics = ModelStatistics::of(&model(8, &lists));
        assert_eq!(statistics.types, [2, 0, 0, 0, 1, 1]);
        assert_eq!((statistics.segmented, statistics.shared), (Some(6), 1));
        assert_eq!(statistics.unsegmented(), Some(0.25));
    }

    #[test]
    fn a_set_is_the_sum_of_its_models() {
        let sphere = Some(SurfaceType::Sphere);
        let small = ModelStatistics::of(&model(2, &[(&[0, 1], sphere)]));
        let large = ModelStatistics::of(&model(6, &[(&[0, 1, 2], sphere), (&[3], sphere)]));
        let bare = ModelStatistics::of(&Model {
            truth: None,
            ..model(10, &[])
        });
        let set = DatasetStatistics::of(&[large, small, bare]);
        assert_eq!((set.models, set.points, set.primitives), (3, 18, 3));
        assert_eq!(set.types, [0, 0, 0, 3, 0, 0]);
        assert_eq!(set.type_shares(), Some([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]));
        assert_eq!(set.shared, 0);
        assert_eq!(set.unsegmented, Some(0.25));
        let spread = |figure: Option<Distribution>| {
            let Distribution {
                min, median, max, ..
            } = figure.unwrap();
            [min, median, max]
        };
        assert_eq!(spread(set.points_per_model), [2.0, 6.0, 10.0]);
        assert_eq!(spread(set.primitives_per_model), [1.0, 1.5, 2.0]);
    }

    #[test]
    fn nothing_has_no_shares() {
        let set = DatasetStatistics::of(&[]);
        assert_eq!((set.models, set.unsegmented), (0, None));
        assert_eq!(set.type_shares(), None);
        assert_eq!(set.points_per_model, None);
    }
}
