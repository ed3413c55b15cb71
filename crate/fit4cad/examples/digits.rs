//! What a build of the engine for this machine makes of every generated part, to the last digit, as
//! JSON: the cloud and its truth, the primitives of both fitters and their measures. Under wasm it has
//! to be the same (`tests/node/digits.test.mjs`).
//!
//! ```text
//! cargo run --example digits
//! ```

use std::error::Error;

use fit4cad::cloud::Cloud;
use fit4cad::fit::{Method, Parameters, fit};
use fit4cad::format::{write_cloud, write_primitives, write_surfaces};
use fit4cad::metrics::{Measure, Protocol, evaluate};
use fit4cad::model::Segmentation;
use fit4cad::sample::{self, Options};
use fit4cad::surface::Form;
use serde_json::{Value, json};

/// Spacing of the points: few enough for every part to be fitted twice in seconds.
const SPACING: f64 = 0.02;
/// Noise of the points, and outliers for each.
const WORN: [(f64, f64); 2] = [(0.0, 0.0), (0.001, 0.02)];

fn main() -> Result<(), Box<dyn Error>> {
    let mut all = Vec::new();
    for (noise, outliers) in WORN {
        let options = Options {
            spacing: SPACING,
            noise,
            outliers,
            ..Options::default()
        };
        for part in sample::parts() {
            all.push(digits(part.name, &options)?);
        }
    }
    println!("{}", Value::from(all));
    Ok(())
}

/// What there is to say of one part.
fn digits(part: &str, options: &Options) -> Result<Value, Box<dyn Error>> {
    let model = sample::generate(part, options)?;
    let truth = model.truth.clone().unwrap_or_default();
    let mut found = serde_json::Map::new();
    for (name, method) in [("HT", Method::Hough), ("PG", Method::Growing)] {
        let parameters = Parameters::default();
        let fitted = fit(&model.cloud, method, &parameters, options.seed, &mut ())?.segmentation;
        let means = Protocol::ALL.map(|protocol| {
            let report = evaluate(&model.cloud, &truth, &fitted, protocol);
            Value::from(
                Measure::ALL
                    .map(|measure| report.mean.get(measure))
                    .to_vec(),
            )
        });
        let texts = texts(&model.cloud, &fitted);
        found.insert(name.to_owned(), json!({ "texts": texts, "means": means }));
    }
    Ok(json!({
        "part": part,
        "options": { "spacing": SPACING, "noise": options.noise, "outliers": options.outliers },
        "cloud": checksum(&write_cloud(&model.cloud)),
        "truth": texts(&model.cloud, &truth),
        "found": found,
    }))
}

/// The points of the primitives by their checksum, the surfaces in full.
fn texts(cloud: &Cloud, segmentation: &Segmentation) -> Value {
    json!({
        "primitives": checksum(&write_primitives(segmentation, cloud.numbering())),
        "parametric": write_surfaces(segmentation, Form::Parametric),
        "implicit": write_surfaces(segmentation, Form::Implicit),
    })
}

/// FNV-1a of 32 bits (Fowler, Noll and Vo).
fn checksum(text: &str) -> u32 {
    let bytes = text.bytes();
    bytes.fold(0x811c_9dc5, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}
