//! How the time and memory of a fit grow with the cloud: one part at about 10 k, 100 k and 1 M points.
//!
//! ```text
//! cargo run --release --example growth -- [PART]
//! ```
//! Memory is the most that the fit held at a time beyond the cloud itself, counted by the allocator.

use std::error::Error;
use std::time::Instant;

use fit4cad::fit::{self, Method, Parameters};
use fit4cad::sample::{self, Options};

#[path = "../tests/counting/mod.rs"]
mod counting;

/// Spacings, in diagonals, and the points they lead to are told apart by factors of about ten.
const COARSEST: f64 = 0.0077;

fn main() -> Result<(), Box<dyn Error>> {
    let part = std::env::args().nth(1).unwrap_or("bracket".to_owned());
    let coarse = generate(&part, COARSEST)?.cloud.len() as f64;
    println!("method   points primitives  seconds  bytes a point");
    for goal in [1e4, 1e5, 1e6] {
        // Points grow with the inverse square of the spacing.
        let spacing = COARSEST * (coarse / goal).sqrt();
        let model = generate(&part, spacing)?;
        for (name, method) in [("ht", Method::Hough), ("pg", Method::Growing)] {
            let start = Instant::now();
            let (fit, bytes) = counting::peak(|| {
                fit::fit(&model.cloud, method, &Parameters::default(), 1, &mut ())
            });
            let fit = fit?;
            let seconds = start.elapsed().as_secs_f64();
            let points = model.cloud.len();
            println!(
                "{name:6} {points:>8} {:>10} {seconds:>8.2} {:>14.0}",
                fit.segmentation.primitives.len(),
                bytes as f64 / points as f64
            );
        }
    }
    Ok(())
}

fn generate(part: &str, spacing: f64) -> Result<fit4cad::model::Model, Box<dyn Error>> {
    let options = Options {
        spacing,
        ..Options::default()
    };
    Ok(sample::generate(part, &options)?)
}
