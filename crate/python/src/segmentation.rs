//! Points grouped into primitives, in and out.

use fit4cad::fit::least_squares::StandardErrors;
use fit4cad::fit::{Fit, Noise};
use fit4cad::format::by_label;
use fit4cad::metrics::accuracy::fit_accuracy;
use fit4cad::model::{self, Coefficients, Primitive};
use fit4cad::statistics::types_of;
use fit4cad::surface::{OTHER, SurfaceType};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::surface::{from_dict, kind_of, to_dict};

/// Primitives of a cloud: groups of its points, each with its surface where there is one.
#[pyclass(frozen, module = "fit4cad._engine")]
#[derive(Debug)]
pub(crate) struct Segmentation {
    pub(crate) segmentation: model::Segmentation,
    /// The noise that it was fitted by.
    pub(crate) noise: Option<Noise>,
}

impl From<Fit> for Segmentation {
    fn from(fit: Fit) -> Self {
        Self {
            segmentation: fit.segmentation,
            noise: Some(fit.noise),
        }
    }
}

impl From<model::Segmentation> for Segmentation {
    fn from(segmentation: model::Segmentation) -> Self {
        Self {
            segmentation,
            noise: None,
        }
    }
}

/// What a segment is on, by the number of its label.
type ByLabel<T> = std::collections::BTreeMap<i32, T>;

#[pymethods]
impl Segmentation {
    /// The segments that labels make, one a point; points of labels below 0 belong to none. Types are names
    /// and surfaces dictionaries, by label.
    #[staticmethod]
    #[pyo3(signature = (labels, types, surfaces))]
    fn from_labels(
        py: Python<'_>,
        labels: PyReadonlyArray1<'_, i32>,
        types: ByLabel<String>,
        surfaces: ByLabel<Py<PyDict>>,
    ) -> PyResult<Self> {
        let labels = labels.as_array();
        let labels: Vec<i32> = labels.iter().copied().collect();
        let segments = py.detach(|| by_label(&labels));
        let primitives = segments.into_iter().map(|segment| {
            let label = segment.number as i32;
            let kind = types.get(&label).map(|name| kind_of(name)).transpose()?;
            let surface = surfaces.get(&label).map(|it| from_dict(it.bind(py)));
            let surface = surface.transpose()?;
            Ok(match surface {
                Some(surface) => Primitive {
                    kind: Some(kind.unwrap_or(surface.kind())),
                    ..Primitive::on(surface, segment.number, segment.points)
                },
                None => Primitive {
                    number: segment.number,
                    points: segment.points,
                    kind,
                    ..Primitive::default()
                },
            })
        });
        let primitives = primitives.collect::<PyResult<Vec<_>>>()?;
        Ok(model::Segmentation { primitives }.into())
    }

    /// Primitives of dictionaries with `number`, `points`, `type` and `surface`, for a cloud of so many points.
    #[staticmethod]
    fn from_primitives(points: usize, primitives: Vec<Bound<'_, PyDict>>) -> PyResult<Self> {
        let primitives = primitives.iter().map(|it| primitive(points, it));
        let primitives = primitives.collect::<PyResult<Vec<_>>>()?;
        Ok(model::Segmentation { primitives }.into())
    }

    fn __len__(&self) -> usize {
        self.segmentation.primitives.len()
    }

    /// A dictionary for each primitive of the cloud: number, type, points, surface, both vectors and MFE.
    fn primitives<'py>(&self, py: Python<'py>, cloud: &Cloud) -> PyResult<Bound<'py, PyList>> {
        let list = PyList::empty(py);
        for primitive in &self.segmentation.primitives {
            let surface = primitive.surface.as_ref();
            let mfe = surface.and_then(|it| fit_accuracy(&cloud.cloud, &primitive.points, it));
            let vector = |vector: &Coefficients| {
                let values = vector.values();
                values.map(|values| values.to_vec().into_pyarray(py))
            };
            list.append(dict!(py;
                "number" => primitive.number,
                "type" => primitive.kind.map(SurfaceType::name),
                "points" => primitive.points.clone().into_pyarray(py),
                "surface" => surface.map(|surface| to_dict(py, surface)).transpose()?,
                "parametric" => vector(&primitive.parametric),
                "implicit" => vector(&primitive.implicit),
                "mfe" => mfe.map(|accuracy| accuracy.mfe),
                "standardErrors" => errors_to_dict(py, &StandardErrors::of_primitive(&cloud.cloud, primitive))?,
            ))?;
        }
        Ok(list)
    }

    /// The place of a primitive for each of so many points, -1 for none; of several the last in order.
    fn labels<'py>(&self, py: Python<'py>, points: usize) -> Bound<'py, PyArray1<i32>> {
        let mut labels = vec![-1; points];
        for (place, primitive) in (0..).zip(&self.segmentation.primitives) {
            for &index in &primitive.points {
                if let Some(label) = labels.get_mut(index as usize) {
                    *label = place;
                }
            }
        }
        labels.into_pyarray(py)
    }

    /// The noise that it was fitted by, where it was fitted.
    fn noise<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(noise) = &self.noise else {
            return Ok(None);
        };
        Ok(Some(dict!(py;
            "deviation" => noise.deviation,
            "source" => noise.source.name(),
            "kind" => noise.kind.map(|kind| kind.name()),
            "step" => noise.step,
        )))
    }

    /// How many primitives are of each type.
    fn types<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        counted(py, &types_of(&self.segmentation))
    }

    /// Whether no primitive has a surface, as where they come from labels alone.
    fn is_bare(&self) -> bool {
        let mut primitives = self.segmentation.primitives.iter();
        primitives.all(|primitive| primitive.surface.is_none())
    }
}

/// Standard errors by their names.
pub(crate) fn errors_to_dict<'py>(
    py: Python<'py>,
    errors: &StandardErrors,
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for ((name, _), value) in StandardErrors::NAMES.iter().zip(errors.values()) {
        dict.set_item(name, value)?;
    }
    Ok(dict)
}

/// Counts by type, in the order of the types.
pub(crate) fn counted<'py>(
    py: Python<'py>,
    types: &fit4cad::statistics::TypeCounts,
) -> PyResult<Bound<'py, PyDict>> {
    by_type(py, *types)
}

/// Values by type, in the order of the types, the last of what is of none.
pub(crate) fn by_type<'py, T: IntoPyObject<'py>>(
    py: Python<'py>,
    values: impl IntoIterator<Item = T>,
) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let names = SurfaceType::ALL.map(SurfaceType::name).into_iter();
    for (name, value) in names.chain([OTHER]).zip(values) {
        dict.set_item(name, value)?;
    }
    Ok(dict)
}

fn primitive(points: usize, dict: &Bound<'_, PyDict>) -> PyResult<Primitive> {
    let value = |key: &str| Ok::<_, PyErr>(dict.get_item(key)?.filter(|it| !it.is_none()));
    let number = value("number")?.map(|it| it.extract::<u32>()).transpose()?;
    let number = number.ok_or_else(|| refused("a primitive has a number"))?;
    let listed = value("points")?
        .ok_or_else(|| refused(format!("primitive {number} lists no points")))?
        .extract::<PyReadonlyArray1<'_, u32>>()?;
    let mut listed: Vec<u32> = listed.as_array().iter().copied().collect();
    listed.sort_unstable();
    listed.dedup();
    if let Some(beyond) = listed.last().filter(|&&last| last as usize >= points) {
        return Err(refused(format!(
            "primitive {number} lists point {beyond}, of {points} that are counted from 0"
        )));
    }
    let kind = value("type")?
        .map(|it| it.extract::<String>())
        .transpose()?;
    let kind = kind.map(|name| kind_of(&name)).transpose()?;
    let surface = value("surface")?;
    let surface = surface
        .map(|it| from_dict(it.cast::<PyDict>()?))
        .transpose()?;
    Ok(match surface {
        Some(surface) => Primitive {
            kind: Some(kind.unwrap_or(surface.kind())),
            ..Primitive::on(surface, number, listed)
        },
        None => Primitive {
            number,
            points: listed,
            kind,
            ..Primitive::default()
        },
    })
}
