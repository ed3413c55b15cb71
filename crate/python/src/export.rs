//! A segmentation as files: the benchmark's own, and the forms of other programs.

use std::collections::BTreeMap;

use fit4cad::export::{self as engine, About, Export};
use fit4cad::format::{self, Layout, Role, write_cloud, write_primitives, write_surfaces};
use fit4cad::surface::Form;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::cloud::Cloud;
use crate::dict::refused;
use crate::files::role_of;
use crate::segmentation::Segmentation;

/// The texts of a model's four files by role, of the cloud alone without a segmentation.
#[pyfunction]
#[pyo3(signature = (cloud, segmentation))]
pub(crate) fn write(
    py: Python<'_>,
    cloud: &Cloud,
    segmentation: Option<&Segmentation>,
) -> BTreeMap<&'static str, String> {
    let cloud = &cloud.cloud;
    let segmentation = segmentation.map(|it| &it.segmentation);
    py.detach(|| {
        let mut texts = BTreeMap::from([(Role::Cloud.name(), write_cloud(cloud))]);
        if let Some(found) = segmentation {
            let lists = write_primitives(found, cloud.numbering());
            texts.insert(Role::Primitives.name(), lists);
            texts.insert(
                Role::Parametric.name(),
                write_surfaces(found, Form::Parametric),
            );
            texts.insert(Role::Implicit.name(), write_surfaces(found, Form::Implicit));
        }
        texts
    })
}

/// The path of a model's file in the layout `beside` or `test-set`; it leads out of no folder.
#[pyfunction]
#[pyo3(signature = (layout, model, role, method = None))]
pub(crate) fn path_of(
    layout: &str,
    model: &str,
    role: &str,
    method: Option<&str>,
) -> PyResult<String> {
    let layout = match layout {
        "beside" => Layout::Beside,
        "test-set" => Layout::TestSet,
        _ => {
            let message = format!("there is no layout `{layout}`; there are beside, test-set");
            return Err(refused(message));
        }
    };
    Ok(format::path_of(layout, model, role_of(role)?, method))
}

/// A name as one of a file or folder that every file system takes.
#[pyfunction]
pub(crate) fn file_name(name: &str) -> String {
    format::file_name(name)
}

/// A segmentation in a form of another program. The colours are red, green and blue, of points of no
/// primitive and then of the primitives in their order.
#[pyfunction]
#[allow(
    clippy::too_many_arguments,
    reason = "they are what a file says of itself"
)]
pub(crate) fn export<'py>(
    py: Python<'py>,
    form: &str,
    cloud: &Cloud,
    segmentation: &Segmentation,
    model: String,
    method: String,
    fitted: bool,
    colours: Vec<[u8; 3]>,
) -> PyResult<Bound<'py, PyBytes>> {
    let known = Export::ALL.into_iter().find(|known| known.name() == form);
    let known = known.ok_or_else(|| {
        let names = Export::ALL.map(Export::name).join(", ");
        refused(format!("there is no form `{form}`; there are {names}"))
    })?;
    let about = About {
        model,
        method,
        fitted,
        colours,
    };
    let segmentation = &segmentation.segmentation;
    let bytes = py.detach(|| engine::write(known, &cloud.cloud, segmentation, &about));
    Ok(PyBytes::new(py, &bytes))
}
