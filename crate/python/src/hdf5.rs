//! HDF5 files as the files of models that are in them.

use fit4cad_hdf5::Opened;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::dict::refused;

/// A file that is open.
#[pyclass(frozen, module = "fit4cad._engine")]
pub(crate) struct ArrayFile {
    opened: Opened,
}

#[pymethods]
impl ArrayFile {
    /// Opens a file by its path, its size, and what gives the bytes between two offsets.
    #[new]
    fn open(py: Python<'_>, path: &str, size: u64, part: Py<PyAny>) -> PyResult<Self> {
        let read = move |from: u64, length: usize| {
            Python::attach(|py| {
                let to = from.saturating_add(length as u64);
                let given = part.bind(py).call1((from, to));
                let given = given.and_then(|it| it.cast_into::<PyBytes>().map_err(PyErr::from));
                let given = given.map_err(|error| error.value(py).to_string())?;
                Ok(given.as_bytes().to_vec())
            })
        };
        let opened = py.detach(|| Opened::open(path, size, read));
        let opened = opened.map_err(|error| refused(error.to_string()))?;
        Ok(Self { opened })
    }

    /// Path and size of each file of a model in it.
    fn entries(&self) -> Vec<(String, u64)> {
        let entries = self.opened.entries().iter();
        entries
            .map(|entry| (entry.path.clone(), entry.size))
            .collect()
    }

    /// What else there is to say of it, of "it".
    fn notes(&self) -> Vec<String> {
        self.opened.notes().to_vec()
    }

    /// The content of the entry at a place: arrays of NumPy in a zip.
    fn read<'py>(&self, py: Python<'py>, place: usize) -> PyResult<Bound<'py, PyBytes>> {
        let entry = self.opened.entries().get(place);
        let entry = entry.ok_or_else(|| refused("there is no such entry"))?;
        let content = py.detach(|| self.opened.read(entry));
        let content = content.map_err(|error| refused(error.to_string()))?;
        Ok(PyBytes::new(py, &content))
    }
}
