//! Runs a fitter over a folder of benchmark models and scores it: the harness the fitters are
//! tuned with.
//!
//! ```text
//! cargo run --release --example evaluate -- DIR [--method ht|pg] [--seed N] [--every N]
//!     [--only 9,14] [--noise SHARE] [--outliers SHARE] [--missing SHARE] [NAME=VALUE]…
//! ```
//! Noise is Gaussian, in diagonals; outliers are spread evenly over the bounding box; missing points
//! are cut away around one point. NAME=VALUE sets a parameter of the fitters.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::fit::{self, Method, Parameters};
use fit4cad::format::{Role, SourceFile, read_model};
use fit4cad::metrics::{Measure, Protocol, evaluate};
use fit4cad::model::{Model, Segmentation};

struct Options {
    folder: PathBuf,
    method: Method,
    seed: u64,
    every: usize,
    only: Vec<String>,
    noise: f64,
    outliers: f64,
    missing: f64,
    parameters: Parameters,
}

struct Row {
    name: String,
    points: usize,
    truth: usize,
    found: usize,
    dsc: f64,
    prediction_dsc: f64,
    types_right: usize,
    types: usize,
    mfe: f64,
    hausdorff: f64,
    d1: f64,
    seconds: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::read(std::env::args().skip(1))?;
    let mut rows = Vec::new();
    println!("model      points truth found    DSC  back types      MFE   dHaus      d1  seconds");
    for name in names(&options)? {
        let Some(model) = read(&options.folder, &name)? else {
            continue;
        };
        let row = run(&options, disturb(model, &options))?;
        println!("{row}");
        rows.push(row);
    }
    summarise(&mut rows);
    Ok(())
}

impl Options {
    fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut options = Self {
            folder: PathBuf::new(),
            method: Method::Hough,
            seed: 1,
            every: 1,
            only: Vec::new(),
            noise: 0.0,
            outliers: 0.0,
            missing: 0.0,
            parameters: Parameters::default(),
        };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--method" => {
                    options.method = match value()?.as_str() {
                        "ht" => Method::Hough,
                        "pg" => Method::Growing,
                        other => return Err(format!("no method `{other}`; ht or pg").into()),
                    }
                }
                "--seed" => options.seed = value()?.parse()?,
                "--every" => options.every = value()?.parse::<usize>()?.max(1),
                "--only" => options.only = value()?.split(',').map(|n| format!("PC{n}")).collect(),
                "--noise" => options.noise = value()?.parse()?,
                "--outliers" => options.outliers = value()?.parse()?,
                "--missing" => options.missing = value()?.parse()?,
                other => match other.split_once('=') {
                    Some((name, value)) => options.parameters.set(name, value.parse()?)?,
                    None => options.folder = PathBuf::from(other),
                },
            }
        }
        if options.folder.as_os_str().is_empty() {
            return Err("name the folder that holds PC1.txt, PC1_primitives.txt, …".into());
        }
        Ok(options)
    }
}

/// Models of the folder asked for, by number.
fn names(options: &Options) -> Result<Vec<String>, Box<dyn Error>> {
    let mut numbered: Vec<(u32, String)> = fs::read_dir(&options.folder)?
        .filter_map(|entry| {
            let file = entry.ok()?.file_name().into_string().ok()?;
            let name = file.strip_suffix(".txt")?;
            let number = name.strip_prefix("PC")?.parse().ok()?;
            let wanted = options.only.is_empty() || options.only.iter().any(|only| only == name);
            wanted.then(|| (number, name.to_owned()))
        })
        .collect();
    numbered.sort();
    Ok(numbered
        .into_iter()
        .map(|(_, name)| name)
        .step_by(options.every)
        .collect())
}

/// A model with a truth, or nothing where that is missing.
fn read(folder: &Path, name: &str) -> Result<Option<Model>, Box<dyn Error>> {
    let mut contents = Vec::new();
    for (role, ending) in [
        (Role::Cloud, ""),
        (Role::Primitives, "_primitives"),
        (Role::Parametric, "_parametric"),
        (Role::Implicit, "_implicit"),
    ] {
        let path = folder.join(format!("{name}{ending}.txt"));
        if path.exists() {
            contents.push((role, path.display().to_string(), fs::read(&path)?));
        }
    }
    let files: Vec<SourceFile<'_>> = contents
        .iter()
        .map(|(role, path, bytes)| SourceFile {
            path,
            role: *role,
            method: None,
            bytes,
        })
        .collect();
    let model = read_model(name, &files).0;
    let has_truth = model
        .truth
        .as_ref()
        .is_some_and(|truth| !truth.primitives.is_empty());
    Ok(has_truth.then_some(model))
}

/// The model with noise, outliers and missing points as asked for.
fn disturb(mut model: Model, options: &Options) -> Model {
    if options.noise == 0.0 && options.outliers == 0.0 && options.missing == 0.0 {
        return model;
    }
    let mut random = fastrand::Rng::with_seed(7);
    let bounds = model.cloud.bounds();
    let sigma = options.noise * bounds.diagonal();
    let old = model.cloud.points();
    let middle = old[random.usize(..old.len())];
    let mut distances: Vec<f64> = old.iter().map(|p| (p - middle).norm()).collect();
    distances.sort_by(f64::total_cmp);
    let cut = ((old.len() as f64 * options.missing) as usize)
        .checked_sub(1)
        .map(|i| distances[i]);
    let mut points: Vec<Point> = Vec::with_capacity(old.len());
    let mut place = vec![None; old.len()];
    for (index, point) in old.iter().enumerate() {
        if cut.is_some_and(|cut| (point - middle).norm() <= cut) {
            continue;
        }
        place[index] = u32::try_from(points.len()).ok();
        points.push(point + Vector::from_fn(|_, _| sigma * gaussian(&mut random)));
    }
    for _ in 0..(points.len() as f64 * options.outliers) as usize {
        let at = Vector::from_fn(|_, _| random.f64());
        points.push(bounds.min + bounds.size().component_mul(&at));
    }
    if let Some(Segmentation { primitives }) = &mut model.truth {
        for primitive in primitives.iter_mut() {
            primitive.points = primitive
                .points
                .iter()
                .filter_map(|&index| place[index as usize])
                .collect();
        }
        primitives.retain(|primitive| !primitive.points.is_empty());
    }
    model.cloud = Cloud::new(points);
    model
}

/// A normal deviate (Box and Muller 1958).
fn gaussian(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}

fn run(options: &Options, model: Model) -> Result<Row, Box<dyn Error>> {
    let start = Instant::now();
    let fit = fit::fit(
        &model.cloud,
        options.method,
        &options.parameters,
        options.seed,
        &mut (),
    )?;
    let seconds = start.elapsed().as_secs_f64();
    let truth = model.truth.unwrap_or_default();
    let report = evaluate(
        &model.cloud,
        &truth,
        &fit.segmentation,
        Protocol::Definition,
    );
    let (mut types, mut types_right) = (0, 0);
    for row in &report.primitives {
        if let (Some(kind), Some(matched)) = (row.kind, row.matched) {
            types += 1;
            types_right += usize::from(report.predictions[matched].kind == Some(kind));
        }
    }
    let mean = |measure| report.mean.get(measure).unwrap_or(0.0);
    Ok(Row {
        name: model.name,
        points: model.cloud.len(),
        truth: truth.primitives.len(),
        found: fit.segmentation.primitives.len(),
        dsc: mean(Measure::Dsc),
        prediction_dsc: report.hidden.prediction_dsc.unwrap_or(0.0),
        types_right,
        types,
        mfe: mean(Measure::Mfe),
        hausdorff: mean(Measure::DHaus),
        d1: mean(Measure::D1),
        seconds,
    })
}

impl std::fmt::Display for Row {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:8} {:>8} {:>5} {:>5} {:.4} {:.3} {:>2}/{:<2} {:.1e} {:.1e} {:.1e} {:>8.3}",
            self.name,
            self.points,
            self.truth,
            self.found,
            self.dsc,
            self.prediction_dsc,
            self.types_right,
            self.types,
            self.mfe,
            self.hausdorff,
            self.d1,
            self.seconds,
        )
    }
}

fn summarise(rows: &mut [Row]) {
    if rows.is_empty() {
        println!("no model with a ground truth");
        return;
    }
    let count = rows.len() as f64;
    let mean = |value: fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / count;
    let right: usize = rows.iter().map(|row| row.types_right).sum();
    let types: usize = rows.iter().map(|row| row.types).sum();
    println!(
        "{} models: mean DSC {:.4}, from the prediction's side {:.4}, types right {:.4}",
        rows.len(),
        mean(|row| row.dsc),
        mean(|row| row.prediction_dsc),
        right as f64 / types.max(1) as f64,
    );
    println!(
        "mean MFE {:.2e}, dHaus {:.2e}, d1 {:.2e}",
        mean(|row| row.mfe),
        mean(|row| row.hausdorff),
        mean(|row| row.d1),
    );
    rows.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let last = rows.len() - 1;
    let (median, worst) = (rows[last / 2].seconds, rows[last].seconds);
    println!(
        "seconds per cloud: median {median:.3}, worst {worst:.3} ({})",
        rows[last].name
    );
    rows.sort_by(|a, b| a.dsc.total_cmp(&b.dsc));
    println!("worst DSC:");
    for row in rows.iter().take_while(|row| row.dsc < 0.95).take(40) {
        println!("  {row}");
    }
}
