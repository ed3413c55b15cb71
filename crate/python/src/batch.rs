//! Many models side by side, on as many cores as are asked for.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use fit4cad::batch::{Batch, fit_all, score_all};
use fit4cad::cloud;
use fit4cad::fit::FitError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cloud::Cloud;
use crate::dict::refused;
use crate::fit::{method_of, parameters_of};
use crate::report::to_dict;
use crate::score::protocol_of;
use crate::segmentation::Segmentation;

/// How often the interpreter hears how many are done, and is asked for Ctrl-C.
const HEARD: Duration = Duration::from_millis(20);

/// Fits primitives to many clouds; `progress(done, of)` hears how many are done, and what it raises ends all.
#[pyfunction]
#[pyo3(signature = (clouds, method, parameters, seed = 1, jobs = 0, progress = None))]
pub(crate) fn fit_many(
    py: Python<'_>,
    clouds: Vec<PyRef<'_, Cloud>>,
    method: &str,
    parameters: BTreeMap<String, f64>,
    seed: u32,
    jobs: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Vec<Segmentation>> {
    let method = method_of(method)?;
    let parameters = parameters_of(method, &parameters)?;
    let clouds: Vec<&cloud::Cloud> = clouds.iter().map(|cloud| &cloud.cloud).collect();
    let fitted = followed(py, clouds.len(), jobs, progress, |batch| {
        fit_all(&clouds, method, &parameters, u64::from(seed), batch)
    })?;
    let fitted = fitted.into_iter();
    let segmentations = fitted.map(|fit| fit.map(Segmentation::from));
    segmentations
        .collect::<Result<_, FitError>>()
        .map_err(refused)
}

/// A case of a batch: model, method, cloud, truth and prediction.
type Case<'py> = (
    String,
    String,
    PyRef<'py, Cloud>,
    PyRef<'py, Segmentation>,
    PyRef<'py, Segmentation>,
);

/// Every measure of many predictions.
#[pyfunction]
#[pyo3(signature = (cases, protocol, jobs = 0, progress = None))]
pub(crate) fn score_many<'py>(
    py: Python<'py>,
    cases: Vec<Case<'py>>,
    protocol: &str,
    jobs: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let protocol = protocol_of(protocol)?;
    let bare: Vec<_> = cases
        .iter()
        .map(|(_, _, cloud, truth, prediction)| {
            (&cloud.cloud, &truth.segmentation, &prediction.segmentation)
        })
        .collect();
    let reports = followed(py, bare.len(), jobs, progress, |batch| {
        score_all(&bare, protocol, batch)
    })?;
    let rows = cases.iter().zip(reports);
    rows.map(|((model, method, ..), report)| {
        let report = report.map_err(refused)?;
        to_dict(py, model, method, &report)
    })
    .collect()
}

/// Runs a batch on threads of its own, while this one, which alone hears of signals, tells Python how far
/// it is; what Python raises stops the batch.
fn followed<T: Send>(
    py: Python<'_>,
    of: usize,
    jobs: usize,
    progress: Option<Py<PyAny>>,
    run: impl FnOnce(&Batch<'_>) -> T + Send,
) -> PyResult<T> {
    let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
    let batch = Batch {
        jobs,
        done: &done,
        stop: &stop,
    };
    py.detach(|| {
        thread::scope(|scope| {
            let running = scope.spawn(|| run(&batch));
            let (mut told, mut raised) = (0, None);
            while !running.is_finished() {
                thread::park_timeout(HEARD);
                let now = done.load(Ordering::Relaxed);
                let heard = Python::attach(|py| {
                    py.check_signals()?;
                    if let Some(progress) = progress.as_ref().filter(|_| now != told) {
                        progress.call1(py, (now, of))?;
                    }
                    Ok(())
                });
                told = now;
                if let Err(error) = heard {
                    stop.store(true, Ordering::Relaxed);
                    raised = Some(error);
                    break;
                }
            }
            let found = running.join();
            match (raised, found) {
                (Some(error), _) => Err(error),
                (None, Ok(found)) => {
                    if let Some(progress) = progress.as_ref().filter(|_| told != of) {
                        Python::attach(|py| progress.call1(py, (of, of)).map(drop))?;
                    }
                    Ok(found)
                }
                (None, Err(_)) => Err(refused("a thread of the batch ended in the middle")),
            }
        })
    })
}
