//! Reading the files of a model, whatever they are.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Mutex;

use fit4cad::diagnostics::Diagnostic;
use fit4cad::fit::given::give_surfaces;
use fit4cad::format::{self, Override, Readers, Role, limits, read_files};
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

use crate::cloud::Cloud;
use crate::diagnostic;
use crate::dict::{dict, refused};
use crate::segmentation::Segmentation;

/// The role of that name.
pub(crate) fn role_of(name: &str) -> PyResult<Role> {
    let known = Role::ALL.into_iter().find(|known| known.name() == name);
    known.ok_or_else(|| {
        let names = Role::ALL.map(Role::name).join(", ");
        refused(format!("there is no role `{name}`; there are {names}"))
    })
}

/// What is known better about a file than its path tells: role, model, method, what its indices count from.
type Known = (Option<String>, Option<String>, Option<String>, Option<u8>);

/// Sorts paths into models: a list of (name, files), each file (path, role, method, first), and a list of
/// (path, reason) of those that belong to none.
#[pyfunction]
pub(crate) fn group<'py>(
    py: Python<'py>,
    paths: Vec<String>,
    overrides: BTreeMap<String, Known>,
) -> PyResult<Bound<'py, PyDict>> {
    let overrides = overrides.into_iter().map(|(path, known)| {
        let (role, model, method, first) = known;
        let role = role.map(|name| role_of(&name)).transpose()?;
        let known = Override {
            role,
            model,
            method,
            first,
        };
        Ok((path, known))
    });
    let overrides = overrides.collect::<PyResult<BTreeMap<_, _>>>()?;
    let grouping = py.detach(|| format::group(&paths, &overrides));
    let models = grouping.models.into_iter().map(|model| {
        let files = model.files.into_iter();
        let files = files.map(|file| (file.path, file.role.name(), file.method, file.first));
        (model.name, files.collect::<Vec<_>>())
    });
    let unplaced = grouping.unplaced.into_iter();
    let unplaced = unplaced.map(|file| (file.path, file.reason));
    Ok(dict!(py;
        "models" => models.collect::<Vec<_>>(),
        "unplaced" => unplaced.collect::<Vec<_>>(),
        "ignored" => grouping.ignored,
    ))
}

/// A file: path, role, method, what its indices count from, bytes of its content, what gives it, and what gives those
/// between two offsets where they can be had so.
type Given = (
    String,
    String,
    Option<String>,
    Option<u8>,
    u64,
    Py<PyAny>,
    Option<Py<PyAny>>,
);

struct InputFile<'a> {
    path: String,
    role: Role,
    method: Option<String>,
    first: Option<u8>,
    size: u64,
    read: Py<PyAny>,
    part: Option<Py<PyAny>>,
    /// What is no failure of the file: Ctrl-C, above all.
    raised: &'a Mutex<Option<PyErr>>,
}

impl format::Source for InputFile<'_> {
    fn path(&self) -> &str {
        &self.path
    }

    fn role(&self) -> Role {
        self.role
    }

    fn method(&self) -> Option<&str> {
        self.method.as_deref()
    }

    fn first(&self) -> u8 {
        self.first.unwrap_or(1)
    }

    fn size(&self) -> u64 {
        self.size
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        // The file may have grown since its size was taken.
        self.bytes(limits::MAX_FILE_BYTES, |py| self.read.bind(py).call0())
    }

    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        let part = self.part.as_ref()?;
        Some(self.bytes(to - from, |py| part.bind(py).call1((from, to))))
    }
}

impl InputFile<'_> {
    /// The bytes that a call gives, of which there may be so many.
    fn bytes(
        &self,
        most: u64,
        call: impl for<'py> FnOnce(Python<'py>) -> PyResult<Bound<'py, PyAny>>,
    ) -> Result<Cow<'static, [u8]>, String> {
        Python::attach(|py| {
            let read = || call(py)?.cast_into::<PyBytes>().map_err(PyErr::from);
            match read() {
                Ok(bytes) if bytes.as_bytes().len() as u64 > most => {
                    Err("it is larger than it was said to be".to_owned())
                }
                Ok(bytes) => Ok(Cow::Owned(bytes.as_bytes().to_vec())),
                Err(error) => {
                    let reason = error.value(py).to_string();
                    if !error.is_instance_of::<PyException>(py)
                        && let Ok(mut raised) = self.raised.lock()
                    {
                        *raised = Some(error);
                    }
                    Err(reason)
                }
            }
        })
    }
}

/// What is wrong with the files of a model.
#[pyclass(frozen, module = "fit4cad._engine")]
#[derive(Debug)]
pub(crate) struct Findings {
    findings: Vec<Diagnostic>,
    method_of_file: BTreeMap<String, String>,
}

impl Findings {
    /// Those about files of no method.
    pub(crate) fn of_truth(&self) -> Vec<Diagnostic> {
        self.of(None).cloned().collect()
    }

    fn of(&self, method: Option<&str>) -> impl Iterator<Item = &Diagnostic> {
        self.findings.iter().filter(move |finding| {
            let owner = self.method_of_file.get(&finding.file);
            owner.is_none_or(|owner| method == Some(owner.as_str()))
        })
    }
}

#[pymethods]
impl Findings {
    /// All, as dictionaries.
    fn all<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let findings = self.findings.iter();
        findings
            .map(|finding| diagnostic::to_dict(py, finding))
            .collect()
    }

    /// Those that bear on the score of one method, or of the truth itself.
    #[pyo3(signature = (method))]
    fn about<'py>(
        &self,
        py: Python<'py>,
        method: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let findings = self.of(method);
        findings
            .map(|finding| diagnostic::to_dict(py, finding))
            .collect()
    }
}

/// Reads a model from its files. Whatever is wrong with them is among the findings; segments that come
/// without surfaces get them here, and `fitted` names whose.
#[pyfunction]
pub(crate) fn read<'py>(
    py: Python<'py>,
    name: &str,
    files: Vec<Given>,
) -> PyResult<Bound<'py, PyDict>> {
    let raised = Mutex::new(None);
    let files = files
        .into_iter()
        .map(|(path, role, method, first, size, read, part)| {
            let role = role_of(&role)?;
            Ok(InputFile {
                path,
                role,
                method,
                first,
                size,
                read,
                part,
                raised: &raised,
            })
        });
    let files = files.collect::<PyResult<Vec<_>>>()?;
    let (reading, fitted) = py.detach(|| {
        let mut reading = read_files(name, &files, &Readers::ALL);
        let fitted = give_surfaces(&mut reading, &files);
        (reading, fitted)
    });
    let submitted = files.into_iter();
    let submitted = submitted.filter_map(|file| file.method.map(|method| (file.path, method)));
    let method_of_file = submitted.collect();
    if let Ok(Some(error)) = raised.into_inner() {
        return Err(error);
    }
    let submissions = PyList::empty(py);
    for submission in reading.model.submissions {
        submissions.append((
            submission.method,
            Segmentation::from(submission.segmentation),
        ))?;
    }
    let findings = Findings {
        findings: reading.diagnostics,
        method_of_file,
    };
    Ok(dict!(py;
        "cloud" => Cloud::from(reading.model.cloud),
        "truth" => reading.model.truth.map(Segmentation::from),
        "submissions" => submissions,
        "findings" => findings,
        "fitted" => fitted.into_iter().collect::<Vec<Option<String>>>(),
    ))
}
