//! Running a fitter on a model.

use std::collections::BTreeMap;

use fit4cad::fit::{self, Cancelled, Observer, Parameters, Stage};
use js_sys::Function;
use serde::Deserialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsError, JsValue};

use crate::model::Model;

/// How surfaces are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum FitMethod {
    /// Votes in parameter space.
    Ht,
    /// Primitive growing from neighbourhoods.
    Pg,
}

impl From<FitMethod> for fit::Method {
    fn from(method: FitMethod) -> Self {
        match method {
            FitMethod::Ht => Self::Hough,
            FitMethod::Pg => Self::Growing,
        }
    }
}

/// Values by parameter name; those left out have their defaults.
#[derive(Debug, Clone, Default, Deserialize, Tsify)]
#[serde(transparent)]
pub struct FitParameters(#[tsify(type = "Record<string, number>")] pub BTreeMap<String, f64>);

#[wasm_bindgen]
impl Model {
    /// Fits primitives to the bare cloud and keeps them as a submission; gives its name, which is
    /// that of the method, with the number of points where only some were fitted, and one behind it if it is taken. The same cloud, parameters and seed give
    /// the same primitives. `progress` hears the stage and how much of it is done; what it throws
    /// ends the fit and reaches the caller.
    ///
    /// # Errors
    /// If a parameter is unknown or out of its range, the noise given larger than the cloud, or `progress` throws.
    pub fn fit(
        &mut self,
        method: Ts<FitMethod>,
        parameters: Ts<FitParameters>,
        seed: u32,
        #[wasm_bindgen(unchecked_param_type = "(stage: string, fraction: number) => void")]
        progress: Option<Function>,
    ) -> Result<String, JsValue> {
        let method = fit::Method::from(method.to_rust().map_err(JsError::from)?);
        let given = parameters.to_rust().map_err(JsError::from)?;
        let mut parameters = Parameters::default();
        for (name, value) in given.0 {
            parameters.set(&name, value).map_err(JsError::from)?;
        }
        let mut listener = Listener {
            callback: progress,
            thrown: None,
        };
        let cloud = &self.model.cloud;
        let seed = u64::from(seed);
        let fitted = fit::fit(cloud, method, &parameters, seed, &mut listener);
        let fitted = fitted.map_err(|error| {
            let thrown = listener.thrown.take();
            thrown.unwrap_or_else(|| JsError::from(error).into())
        })?;
        let name = self.free_name(&fitted.title(method));
        self.noise.insert(name.clone(), fitted.noise);
        self.model.submit(&name, fitted.segmentation);
        Ok(name)
    }
}

impl Model {
    /// `HT`, or `HT 2` where there is an `HT` already, and so on.
    pub(crate) fn free_name(&self, method: &str) -> String {
        let mut name = method.to_owned();
        let mut number = 2u32;
        while self.methods().any(|taken| taken == name) {
            name = format!("{method} {number}");
            number += 1;
        }
        name
    }
}

/// Passes progress on to JavaScript and holds what it throws.
struct Listener {
    callback: Option<Function>,
    thrown: Option<JsValue>,
}

impl Observer for Listener {
    fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        let Some(callback) = &self.callback else {
            return Ok(());
        };
        let called = callback.call2(&JsValue::NULL, &stage.name().into(), &fraction.into());
        called.map(|_| ()).map_err(|thrown| {
            self.thrown = Some(thrown);
            Cancelled
        })
    }
}
