//! Points in and out.

use fit4cad::cloud::{self, Point};
use numpy::{IntoPyArray, PyArrayMethods};
use numpy::{PyArray1, PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::dict::{dict, refused};

/// The points of a model, float64 of shape (n, 3), and the numbers that files give them.
#[pyclass(frozen, module = "fit4cad._engine")]
#[derive(Debug)]
pub(crate) struct Cloud {
    pub(crate) cloud: cloud::Cloud,
}

impl From<cloud::Cloud> for Cloud {
    fn from(cloud: cloud::Cloud) -> Self {
        Self { cloud }
    }
}

#[pymethods]
impl Cloud {
    /// A cloud of an array of shape (n, 3).
    #[new]
    fn new(points: PyReadonlyArray2<'_, f64>) -> PyResult<Self> {
        let (rows, columns) = (points.shape()[0], points.shape()[1]);
        if columns != 3 {
            return Err(refused(format!(
                "points are an array of shape (n, 3), not ({rows}, {columns})"
            )));
        }
        if rows > fit4cad::format::limits::MAX_POINTS {
            return Err(refused(format!(
                "a cloud has at most {} points, not {rows}",
                fit4cad::format::limits::MAX_POINTS
            )));
        }
        let array = points.as_array();
        let points = array.rows().into_iter();
        let points = points.map(|row| Point::new(row[0], row[1], row[2]));
        Ok(cloud::Cloud::new(points.collect()).into())
    }

    fn __len__(&self) -> usize {
        self.cloud.len()
    }

    /// The points, a new array of shape (n, 3).
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = self.cloud.points().iter();
        let flat: Vec<f64> = points
            .flat_map(|point| [point.x, point.y, point.z])
            .collect();
        flat.into_pyarray(py).reshape([self.cloud.len(), 3])
    }

    /// The number of each point in its file, from 1; `None` where that is its index and one.
    fn numbers<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<u64>>> {
        let numbering = self.cloud.numbering();
        if numbering.is_plain() {
            return None;
        }
        let numbers = (0u32..).take(self.cloud.len());
        let numbers: Vec<u64> = numbers.map(|index| numbering.number(index)).collect();
        Some(numbers.into_pyarray(py))
    }

    /// The axis-aligned box: `min`, `max` and `diagonal`; `None` without points.
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let bounds = self.cloud.bounds();
        if bounds.is_empty() {
            return Ok(None);
        }
        let corner = |point: Point| [point.x, point.y, point.z];
        Ok(Some(dict!(py;
            "min" => corner(bounds.min),
            "max" => corner(bounds.max),
            "diagonal" => bounds.diagonal(),
        )))
    }
}
