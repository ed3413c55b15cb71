//! What a set of models holds.

use fit4cad::model::Model;
use fit4cad::statistics::{DatasetStatistics, ModelStatistics};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cloud::Cloud;
use crate::dict::dict;
use crate::score::spread;
use crate::segmentation::{Segmentation, by_type, counted};

/// One model in numbers.
#[pyclass(frozen, module = "fit4cad._engine")]
#[derive(Debug)]
pub(crate) struct Counted {
    counted: ModelStatistics,
}

#[pymethods]
impl Counted {
    /// With the keys of the command line's JSON.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let model = &self.counted;
        let dict = dict!(py;
            "name" => &model.name,
            "points" => model.points,
            "primitives" => model.primitives(),
        );
        // What cannot be had is not there.
        if let Some(segmented) = model.segmented {
            dict.set_item("segmented", segmented)?;
        }
        if let Some(unsegmented) = model.unsegmented() {
            dict.set_item("unsegmented", unsegmented)?;
        }
        dict.set_item("shared", model.shared)?;
        dict.set_item("types", counted(py, &model.types)?)?;
        Ok(dict)
    }
}

/// Counts a model.
#[pyfunction]
#[pyo3(signature = (name, cloud, truth))]
pub(crate) fn statistics_of(name: &str, cloud: &Cloud, truth: Option<&Segmentation>) -> Counted {
    let model = Model {
        name: name.to_owned(),
        cloud: cloud.cloud.clone(),
        truth: truth.map(|truth| truth.segmentation.clone()),
        ..Model::default()
    };
    Counted {
        counted: ModelStatistics::of(&model),
    }
}

/// Sums up counted models.
#[pyfunction]
pub(crate) fn statistics<'py>(
    py: Python<'py>,
    models: Vec<PyRef<'py, Counted>>,
) -> PyResult<Bound<'py, PyDict>> {
    let models: Vec<ModelStatistics> = models.iter().map(|it| it.counted.clone()).collect();
    let found = DatasetStatistics::of(&models);
    let over = |found: Option<fit4cad::metrics::Distribution>| {
        found.map(|found| spread(py, &found)).transpose()
    };
    Ok(dict!(py;
        "models" => found.models,
        "points" => found.points,
        "primitives" => found.primitives,
        "types" => counted(py, &found.types)?,
        "typeShares" => found.type_shares().map(|shares| by_type(py, shares)).transpose()?,
        "shared" => found.shared,
        "unsegmented" => found.unsegmented,
        "pointsPerModel" => over(found.points_per_model)?,
        "primitivesPerModel" => over(found.primitives_per_model)?,
        "unsegmentedPerModel" => over(found.unsegmented_per_model)?,
    ))
}
