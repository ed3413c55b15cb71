//! Plain values as Python has them.

/// A dictionary of the values that stand beside their keys, in their order.
macro_rules! dict {
    ($py:expr; $($key:expr => $value:expr),* $(,)?) => {{
        let dict = pyo3::types::PyDict::new($py);
        $(dict.set_item($key, $value)?;)*
        dict
    }};
}

pub(crate) use dict;

use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// An error of the engine, in its words.
pub(crate) fn refused(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}
