//! Running a fitter: without the interpreter's lock, heard of and stopped from Python.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use fit4cad::cloud::Point;
use fit4cad::fit::least_squares::StandardErrors;
use fit4cad::fit::parameters::TABLE;
use fit4cad::fit::single::fit_segments as segments;
use fit4cad::fit::single::recognise as each;
use fit4cad::fit::single::{Single, Verdict, fit_single as single};
use fit4cad::fit::{Cancelled, Method, Observer, Parameters, Stage, fit as engine};
use fit4cad::format::write_answer;
use fit4cad::model::{self, Primitive};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::segmentation::{Segmentation, errors_to_dict};
use crate::surface::{kind_of, to_dict};

/// How often the interpreter is asked whether somebody pressed Ctrl-C: soon enough for a hand, and far too
/// seldom to be felt.
const ASKED: Duration = Duration::from_millis(20);

/// The method of that name.
pub(crate) fn method_of(name: &str) -> PyResult<Method> {
    let known = Method::ALL.into_iter().find(|known| known.name() == name);
    known.ok_or_else(|| {
        let names = Method::ALL.map(Method::name).join(", ");
        refused(format!("there is no method `{name}`; there are {names}"))
    })
}

/// The parameters with the values given, each one that the method heeds.
pub(crate) fn parameters_of(method: Method, given: &BTreeMap<String, f64>) -> PyResult<Parameters> {
    let mut parameters = Parameters::default();
    for (name, &value) in given {
        parameters.set(name, value).map_err(refused)?;
        let info = TABLE.iter().find(|info| info.name == name);
        if info.is_some_and(|info| !info.methods.contains(&method)) {
            return Err(refused(format!(
                "`{name}` is no parameter of {}",
                method.name()
            )));
        }
    }
    Ok(parameters)
}

/// Fits primitives to a cloud, and says what the answer is called; `progress(stage, fraction)` hears how far it is, and
/// what it raises ends the fit.
#[pyfunction]
#[pyo3(signature = (cloud, method, parameters, seed = 1, progress = None))]
pub(crate) fn fit(
    py: Python<'_>,
    cloud: &Cloud,
    method: &str,
    parameters: BTreeMap<String, f64>,
    seed: u32,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Segmentation, String)> {
    let method = method_of(method)?;
    let parameters = parameters_of(method, &parameters)?;
    let mut listener = Listener::new(progress);
    let fitted = py.detach(|| {
        engine(
            &cloud.cloud,
            method,
            &parameters,
            u64::from(seed),
            &mut listener,
        )
    });
    match fitted {
        Ok(fitted) => {
            let title = fitted.title(method);
            Ok((fitted.into(), title))
        }
        Err(error) => Err(listener.raised.unwrap_or_else(|| refused(error))),
    }
}

/// Gives every segment that has no surface the one its points lie on, and says how many got one.
#[pyfunction]
pub(crate) fn fit_segments(
    py: Python<'_>,
    cloud: &Cloud,
    segmentation: &Segmentation,
) -> (Segmentation, usize) {
    let mut fitted = segmentation.segmentation.clone();
    let count = py.detach(|| segments(&cloud.cloud, &mut fitted));
    (fitted.into(), count)
}

/// Takes some points of a cloud, or all, for one primitive of one of the types, or of any: the best surface,
/// the best of another type and the margin between them; and a segmentation of the one primitive.
#[pyfunction]
#[pyo3(signature = (cloud, points = None, types = Vec::new(), number = 1))]
pub(crate) fn fit_single<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    points: Option<PyReadonlyArray1<'py, u32>>,
    types: Vec<String>,
    number: u32,
) -> PyResult<(Bound<'py, PyDict>, Segmentation)> {
    let kinds = types.iter().map(|name| kind_of(name));
    let kinds = kinds.collect::<PyResult<Vec<_>>>()?;
    let listed: Vec<u32> = match points {
        Some(points) => points.as_array().iter().copied().collect(),
        None => (0u32..).take(cloud.cloud.len()).collect(),
    };
    let all = cloud.cloud.points();
    let found = py.detach(|| {
        let points = listed
            .iter()
            .filter_map(|&at| all.get(at as usize).copied());
        single(&points.collect::<Vec<_>>(), &kinds)
    });
    let dict = single_to_dict(py, number, &listed, cloud, &found)?;
    let primitives = vec![Primitive::on(found.best.surface, number, listed)];
    Ok((dict, model::Segmentation { primitives }.into()))
}

/// Takes each segment, or the whole cloud where there are none, for one primitive: what each is, and a
/// segmentation of them.
#[pyfunction]
#[pyo3(signature = (cloud, segments))]
pub(crate) fn recognise<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    segments: Option<&Segmentation>,
) -> PyResult<(Bound<'py, PyList>, Segmentation)> {
    let segments = segments.map(|it| &it.segmentation);
    let found = py.detach(|| each(&cloud.cloud, segments));
    let (list, mut primitives) = (PyList::empty(py), Vec::new());
    for it in found {
        list.append(single_to_dict(
            py, it.number, &it.points, cloud, &it.single,
        )?)?;
        let surface = it.single.best.surface;
        primitives.push(Primitive::on(surface, it.number, it.points));
    }
    Ok((list, model::Segmentation { primitives }.into()))
}

fn single_to_dict<'py>(
    py: Python<'py>,
    number: u32,
    points: &[u32],
    cloud: &Cloud,
    found: &Single,
) -> PyResult<Bound<'py, PyDict>> {
    let all = cloud.cloud.points();
    let own = points.iter();
    let own = own.filter_map(|&index| all.get(index as usize).copied());
    let own: Vec<Point> = own.collect();
    let second = found.others.first().unwrap_or(&found.best);
    Ok(dict!(py;
        "number" => number,
        "points" => points.len(),
        "best" => verdict(py, &found.best, &own)?,
        "runnerUp" => verdict(py, second, &own)?,
        "margin" => found.margin,
        "answer" => write_answer(&found.best.surface),
    ))
}

fn verdict<'py>(
    py: Python<'py>,
    verdict: &Verdict,
    points: &[Point],
) -> PyResult<Bound<'py, PyDict>> {
    let errors = StandardErrors::of(&verdict.surface, points);
    Ok(dict!(py;
        "type" => verdict.surface.kind().name(),
        "surface" => to_dict(py, &verdict.surface)?,
        "standardErrors" => errors_to_dict(py, &errors)?,
        "mean" => verdict.mean,
        "rms" => verdict.rms,
        "largest" => verdict.largest,
    ))
}

/// Passes progress on to Python, asks it for signals, and holds what it raises.
struct Listener {
    callback: Option<Py<PyAny>>,
    asked: Instant,
    raised: Option<PyErr>,
}

impl Listener {
    fn new(callback: Option<Py<PyAny>>) -> Self {
        Self {
            callback,
            asked: Instant::now(),
            raised: None,
        }
    }
}

impl Observer for Listener {
    fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        if self.callback.is_none() && self.asked.elapsed() < ASKED {
            return Ok(());
        }
        let heard = Python::attach(|py| {
            py.check_signals()?;
            if let Some(callback) = &self.callback {
                callback.call1(py, (stage.name(), fraction))?;
            }
            Ok(())
        });
        self.asked = Instant::now();
        heard.map_err(|raised| {
            self.raised = Some(raised);
            Cancelled
        })
    }
}
