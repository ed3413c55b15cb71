//! Many models side by side.
//!
//! With the feature `rayon` on as many cores as are asked for, without it one after the other; either way
//! each model is worked on by one thread, so that no result depends on how many there are.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::cloud::Cloud;
use crate::fit::{self, Cancelled, Fit, FitError, Method, Observer, Parameters, Stage};
use crate::metrics::{Protocol, Report, evaluate};
use crate::model::Segmentation;

/// How a batch is run, and how it is followed and stopped from another thread.
#[derive(Debug, Clone, Copy)]
pub struct Batch<'a> {
    /// How many models are worked on at once: 0 for as many as there are cores. One at a time without the
    /// feature `rayon`.
    pub jobs: usize,
    /// Counts the models that are done.
    pub done: &'a AtomicUsize,
    /// Once true, what has not begun is not begun, and fits end where they next tell how far they are.
    pub stop: &'a AtomicBool,
}

/// Fits primitives to many clouds, as [`fit::fit`] does to one; the answers stand in the order of the clouds
/// and are the same for any number of jobs. Memory is that of the clouds, and of one fit for each job.
///
/// ```
/// use std::sync::atomic::{AtomicBool, AtomicUsize};
/// use fit4cad::batch::{Batch, fit_all};
/// use fit4cad::fit::{Method, Parameters};
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let parts = [generate("flange", &options)?, generate("shaft", &options)?];
/// let clouds: Vec<_> = parts.iter().map(|part| &part.cloud).collect();
/// let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
/// let batch = Batch { jobs: 2, done: &done, stop: &stop };
/// let fits = fit_all(&clouds, Method::Hough, &Parameters::default(), 1, &batch);
/// assert_eq!((fits.len(), done.into_inner()), (2, 2));
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn fit_all(
    clouds: &[&Cloud],
    method: Method,
    parameters: &Parameters,
    seed: u64,
    batch: &Batch<'_>,
) -> Vec<Result<Fit, FitError>> {
    each(clouds, batch, |cloud| {
        fit::fit(cloud, method, parameters, seed, &mut Stopper(batch.stop))
    })
}

/// Scores many predictions, as [`evaluate`] does one; each case is a cloud, its truth and a prediction. The
/// reports stand in the order of the cases and are the same for any number of jobs.
pub fn score_all(
    cases: &[(&Cloud, &Segmentation, &Segmentation)],
    protocol: Protocol,
    batch: &Batch<'_>,
) -> Vec<Result<Report, Cancelled>> {
    each(cases, batch, |(cloud, truth, prediction)| {
        Ok(evaluate(cloud, truth, prediction, protocol))
    })
}

/// Ends a fit once it is to stop.
struct Stopper<'a>(&'a AtomicBool);

impl Observer for Stopper<'_> {
    fn progress(&mut self, _: Stage, _: f64) -> Result<(), Cancelled> {
        if self.0.load(Ordering::Relaxed) {
            Err(Cancelled)
        } else {
            Ok(())
        }
    }
}

/// Does something with each, in their order or side by side.
fn each<T: Sync, R: Send, E: From<Cancelled> + Send>(
    all: &[T],
    batch: &Batch<'_>,
    body: impl Fn(&T) -> Result<R, E> + Sync + Send,
) -> Vec<Result<R, E>> {
    let counted = |one: &T| {
        if batch.stop.load(Ordering::Relaxed) {
            return Err(Cancelled.into());
        }
        let result = body(one);
        batch.done.fetch_add(1, Ordering::Relaxed);
        result
    };
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        let threads = rayon::ThreadPoolBuilder::new().num_threads(batch.jobs);
        // One at a time, and not in chunks: a model may take a thousand times as long as the next.
        let run = || all.par_iter().with_max_len(1).map(counted).collect();
        if batch.jobs != 1
            && let Ok(pool) = threads.build()
        {
            return pool.install(run);
        }
    }
    all.iter().map(counted).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Options, generate, parts};

    #[test]
    fn answers_are_the_same_and_in_order_whatever_the_number_of_jobs() {
        let options = Options {
            spacing: 0.02,
            ..Options::default()
        };
        let models: Vec<_> = parts()
            .iter()
            .map(|part| generate(part.name, &options).unwrap())
            .collect();
        let clouds: Vec<&Cloud> = models.iter().map(|model| &model.cloud).collect();
        let run = |jobs| {
            let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(false));
            let batch = Batch {
                jobs,
                done: &done,
                stop: &stop,
            };
            let parameters = Parameters::default();
            let fits = fit_all(&clouds, Method::Growing, &parameters, 1, &batch);
            assert_eq!(done.load(Ordering::Relaxed), clouds.len());
            let fits: Vec<_> = fits.into_iter().map(|fit| fit.unwrap()).collect();
            let cases: Vec<_> = models
                .iter()
                .zip(&fits)
                .map(|(model, fit)| {
                    let truth = model.truth.as_ref().unwrap();
                    (&model.cloud, truth, &fit.segmentation)
                })
                .collect();
            let reports = score_all(&cases, Protocol::Definition, &batch);
            let reports: Vec<_> = reports.into_iter().map(|report| report.unwrap()).collect();
            (fits, reports)
        };
        assert_eq!(run(1), run(3));
    }

    #[test]
    fn what_is_stopped_begins_nothing() {
        let cloud = Cloud::default();
        let (done, stop) = (AtomicUsize::new(0), AtomicBool::new(true));
        let batch = Batch {
            jobs: 1,
            done: &done,
            stop: &stop,
        };
        let parameters = Parameters::default();
        let fits = fit_all(&[&cloud, &cloud], Method::Hough, &parameters, 1, &batch);
        assert!(fits.iter().all(|fit| *fit == Err(Cancelled.into())));
        assert_eq!(done.into_inner(), 0);
    }
}
