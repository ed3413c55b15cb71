//! The engine as Python sees it: a thin PyO3 boundary over [`fit4cad`].
//!
//! Points and lists of points cross as NumPy arrays, everything else as plain dictionaries with the keys of
//! the command line's JSON; the package's Python makes typed results of them. Nothing is computed here.
//! Whatever takes long runs without the interpreter's lock, and hears of Ctrl-C where progress is told.

mod audit;
mod batch;
mod cloud;
mod comparison;
mod declared;
mod diagnostic;
mod dict;
mod export;
mod files;
mod fit;
mod hdf5;
mod part;
mod recognition;
mod report;
mod score;
mod segmentation;
mod statistics;
mod step;
mod strata;
mod surface;

use pyo3::prelude::*;

/// The compiled half of the package `fit4cad`; what is meant for others is in the package itself.
#[pymodule]
mod _engine {
    #[pymodule_export]
    use crate::audit::{audit, corrected};
    #[pymodule_export]
    use crate::batch::{fit_many, score_many};
    #[pymodule_export]
    use crate::cloud::Cloud;
    #[pymodule_export]
    use crate::comparison::compare_figures;
    #[pymodule_export]
    use crate::declared::declarations;
    #[pymodule_export]
    use crate::diagnostic::one_line;
    #[pymodule_export]
    use crate::export::{export, file_name, path_of, write};
    #[pymodule_export]
    use crate::files::{group, read};
    #[pymodule_export]
    use crate::fit::{fit, fit_segments, fit_single, recognise};
    #[pymodule_export]
    use crate::hdf5::ArrayFile;
    #[pymodule_export]
    use crate::part::{degrade, generate, imperfect};
    #[pymodule_export]
    use crate::recognition::{rates, segments};
    #[pymodule_export]
    use crate::score::{distribution, field, score, summarise};
    #[pymodule_export]
    use crate::segmentation::Segmentation;
    #[pymodule_export]
    use crate::statistics::{statistics, statistics_of};
    #[pymodule_export]
    use crate::step::{export_step, import_step};
    #[pymodule_export]
    use crate::strata::{conditions, declared_condition};
    #[pymodule_export]
    use crate::surface::{distances, surface_of};

    use super::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("PUBLISHED", fit4cad::metrics::PUBLISHED)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
