//! Models with known truth: parts of the catalogue, and clouds made worse.

use std::collections::BTreeMap;

use fit4cad::model::Model;
use fit4cad::sample::{self, Degradation, OPTIONS, OptionInfo, Options, SEED, WEAR};
use pyo3::prelude::*;

use crate::cloud::Cloud;
use crate::dict::refused;
use crate::segmentation::Segmentation;

/// The option of that name among those there are, if the value is in its range.
fn known(options: &[&'static OptionInfo], name: &str, value: f64) -> PyResult<&'static str> {
    let known = options.iter().find(|known| known.name == name);
    let known = known.ok_or_else(|| {
        let names: Vec<&str> = options.iter().map(|known| known.name).collect();
        let names = names.join(", ");
        refused(format!("there is no option `{name}`; there are {names}"))
    })?;
    let (least, most) = (known.minimum, known.maximum);
    if !(least..=most).contains(&value) || (known.whole && value.fract() != 0.0) {
        let kind = if known.whole {
            "whole number"
        } else {
            "number"
        };
        let message = format!("`{name}` must be a {kind} from {least} to {most}, not {value}");
        return Err(refused(message));
    }
    Ok(known.name)
}

fn unset(name: &str) -> PyErr {
    refused(format!("`{name}` cannot be set from Python yet"))
}

/// How a part becomes a cloud, of the values given by the names of the options.
fn options_of(given: BTreeMap<String, f64>) -> PyResult<Options> {
    let mut options = Options::default();
    for (name, value) in given {
        match known(&OPTIONS, &name, value)? {
            "seed" => options.seed = value as u64,
            "spacing" => options.spacing = value,
            "noise" => options.noise = value,
            "outliers" => options.outliers = value,
            "missing" => options.missing = value,
            other => return Err(unset(other)),
        }
    }
    Ok(options)
}

/// What is done to the points of a model, and by which seed.
fn wear_of(given: BTreeMap<String, f64>) -> PyResult<(Degradation, u64)> {
    let all: Vec<&OptionInfo> = WEAR.into_iter().chain([&SEED]).collect();
    let (mut wear, mut seed) = (Degradation::default(), Options::default().seed);
    for (name, value) in given {
        match known(&all, &name, value)? {
            "seed" => seed = value as u64,
            "noise" => wear.noise = value,
            "outliers" => wear.outliers = value,
            "missing" => wear.missing = value,
            "density" => wear.density = value,
            other => return Err(unset(other)),
        }
    }
    Ok((wear, seed))
}

type Made = (Cloud, Option<Segmentation>);

fn made(model: Model) -> Made {
    (model.cloud.into(), model.truth.map(Segmentation::from))
}

/// Makes a part of the catalogue.
#[pyfunction]
pub(crate) fn generate(
    py: Python<'_>,
    part: &str,
    options: BTreeMap<String, f64>,
) -> PyResult<Made> {
    let options = options_of(options)?;
    let model = py.detach(|| sample::generate(part, &options));
    Ok(made(model.map_err(refused)?))
}

/// A cloud as a worse scan would show it, with what is left of its truth.
#[pyfunction]
#[pyo3(signature = (cloud, truth, options))]
pub(crate) fn degrade(
    py: Python<'_>,
    cloud: &Cloud,
    truth: Option<&Segmentation>,
    options: BTreeMap<String, f64>,
) -> PyResult<Made> {
    if options.contains_key("spacing") {
        return Err(refused(
            "the points are there already: no spacing can be asked for",
        ));
    }
    let (wear, seed) = wear_of(options)?;
    let model = Model {
        cloud: cloud.cloud.clone(),
        truth: truth.map(|truth| truth.segmentation.clone()),
        ..Model::default()
    };
    let worn = py.detach(|| sample::degraded(&model, &wear, seed));
    Ok(made(worn.map_err(refused)?))
}

/// A submission that is wrong on purpose, in ways that are common.
#[pyfunction]
pub(crate) fn imperfect(
    py: Python<'_>,
    name: &str,
    cloud: &Cloud,
    truth: &Segmentation,
    seed: u32,
) -> Segmentation {
    let model = Model {
        name: name.to_owned(),
        cloud: cloud.cloud.clone(),
        truth: Some(truth.segmentation.clone()),
        ..Model::default()
    };
    py.detach(|| sample::imperfect(&model, u64::from(seed)))
        .into()
}
