//! Runs a fitter over a folder of benchmark models and scores it: the harness the fitters are
//! tuned with.
//!
//! ```text
//! cargo run --release --example evaluate -- DIR [--method ht|pg] [--seed N] [--every N]
//!     [--only 9,14] [--at-least PRIMITIVES] [--counted POINTS] [--thin FACTOR] [--drop SHARE] [--turn] [--noise SHARE] [--levels SHARE,…]
//!     [--digits N] [--outliers SHARE] [--missing SHARE] [--lost] [--diagnose] [--moved]
//!     [NAME=VALUE]…
//! ```
//! DIR holds PC1.txt, PC1_primitives.txt, …, by any names; `parts` stands for the catalogue of generated parts and
//! for combs of narrow grooves ([`comb`]). `--method oracle` hands the true surfaces to the stages that every fitter shares: what is lost
//! then, they lose. `--counted` leaves true primitives of fewer points out of the mean DSC. How clouds are made harder is told in [`stress`]. `--lost` lists the primitives
//! that were not found well, `--diagnose` also says at which stage each was lost. `--levels` runs all for each of several
//! levels of noise, a line each; `--told 1` tells the fitters what noise was added, as the parameter `noise` does, any other
//! number so many times of it. `--moved`
//! scores nothing, but counts the points whose labels change when the cloud is moved, turned, scaled or shuffled
//! ([`moved`]). NAME=VALUE sets a parameter of the fitters.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use fit4cad::fit::{self, Method, Parameters, Search};
use fit4cad::format::{Role, SourceFile, read_model};
use fit4cad::metrics::{Measure, Protocol, Report, evaluate};
use fit4cad::model::Model;
use fit4cad::sample;
use stress::Stress;

mod comb;
mod diagnose;
mod moved;
mod oracle;
mod stress;

struct Options {
    folder: PathBuf,
    finder: Finder,
    seed: u64,
    every: usize,
    only: Vec<String>,
    at_least: usize,
    counted: usize,
    stress: Stress,
    lost: bool,
    diagnose: bool,
    moved: bool,
    told: f64,
    levels: Vec<f64>,
    parameters: Parameters,
}

/// What finds the surfaces.
#[derive(Clone, Copy)]
enum Finder {
    Method(Method),
    Oracle,
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
    noise: f64,
    seconds: f64,
    lost: Vec<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut options = Options::read(std::env::args().skip(1))?;
    let mut measured = false;
    for level in std::mem::take(&mut options.levels) {
        options.stress.noise = level;
        let rows = wanted(&options)?.map(|model| {
            let (model, noise) = model?;
            run(&options, model, noise)
        });
        let rows = rows.collect::<Result<Vec<Row>, _>>()?;
        let seconds: f64 = rows.iter().map(|row| row.seconds).sum();
        let mean = seconds / rows.len().max(1) as f64;
        println!("noise {level}: {}, {mean:.3} s a cloud", means(&rows));
        measured = true;
    }
    if measured {
        return Ok(());
    }
    if let (true, Finder::Method(method)) = (options.moved, options.finder) {
        return compare(&options, method);
    }
    let mut rows = Vec::new();
    println!(
        "model      points truth found    DSC  back types      MFE   dHaus      d1   noise  seconds"
    );
    for model in wanted(&options)? {
        let (model, noise) = model?;
        let row = run(&options, model, noise)?;
        println!("{row}");
        for lost in row.lost.iter().filter(|_| options.lost || options.diagnose) {
            println!("    {lost}");
        }
        rows.push(row);
    }
    summarise(&mut rows);
    Ok(())
}

/// Compares answers for clouds that show the same.
fn compare(options: &Options, method: Method) -> Result<(), Box<dyn Error>> {
    println!("{}", moved::head());
    let mut rows = Vec::new();
    for model in wanted(options)? {
        let (model, _) = model?;
        let row = moved::run(
            &model.name,
            &model.cloud,
            method,
            &options.parameters,
            options.seed,
        )?;
        println!("{row}");
        rows.push(row);
    }
    moved::summarise(&rows);
    Ok(())
}

impl Options {
    fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, Box<dyn Error>> {
        let mut options = Self {
            folder: PathBuf::new(),
            finder: Finder::Method(Method::Hough),
            seed: 1,
            every: 1,
            only: Vec::new(),
            at_least: 1,
            counted: 1,
            stress: Stress::default(),
            lost: false,
            diagnose: false,
            moved: false,
            told: 0.0,
            levels: Vec::new(),
            parameters: Parameters::default(),
        };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--method" => {
                    options.finder = match value()?.as_str() {
                        "ht" => Finder::Method(Method::Hough),
                        "pg" => Finder::Method(Method::Growing),
                        "oracle" => Finder::Oracle,
                        other => {
                            return Err(format!("no method `{other}`; ht, pg or oracle").into());
                        }
                    }
                }
                "--seed" => options.seed = value()?.parse()?,
                "--every" => options.every = value()?.parse::<usize>()?.max(1),
                "--only" => options.only = value()?.split(',').map(name_of).collect(),
                "--at-least" => options.at_least = value()?.parse()?,
                "--counted" => options.counted = value()?.parse()?,
                "--thin" => options.stress.thin = value()?.parse()?,
                "--drop" => options.stress.drop = value()?.parse()?,
                "--turn" => options.stress.turn = true,
                "--noise" => options.stress.noise = value()?.parse()?,
                "--levels" => {
                    options.levels = value()?
                        .split(',')
                        .map(str::parse)
                        .collect::<Result<_, _>>()?;
                }
                "--digits" => options.stress.digits = Some(value()?.parse()?),
                "--outliers" => options.stress.outliers = value()?.parse()?,
                "--missing" => options.stress.missing = value()?.parse()?,
                "--lost" => options.lost = true,
                "--diagnose" => options.diagnose = true,
                "--moved" => options.moved = true,
                "--told" => options.told = value()?.parse()?,
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

/// The name of a model by its number, or as it is.
fn name_of(text: &str) -> String {
    match text.parse::<u32>() {
        Ok(number) => format!("PC{number}"),
        Err(_) => text.to_owned(),
    }
}

/// The models asked for that are large enough, made as hard as asked for, each with the standard deviation of its noise.
fn wanted(options: &Options) -> Result<Models<'_, (Model, f64)>, Box<dyn Error>> {
    let is_large = |model: &Model| {
        let truth = model.truth.as_ref();
        truth.map_or(0, |truth| truth.primitives.len()) >= options.at_least
    };
    let models = models(options)?.filter_map(move |model| match model {
        Ok(model) => is_large(&model).then(|| {
            let diagonal = model.cloud.bounds().diagonal();
            let model = options.stress.apply(model);
            Ok((model, options.stress.noise * diagonal))
        }),
        Err(error) => Some(Err(error)),
    });
    Ok(Box::new(models))
}

/// The models asked for, read or made one at a time.
fn models(options: &Options) -> Result<Models<'static>, Box<dyn Error>> {
    if options.folder == Path::new("parts") {
        let parts = sample::parts().iter();
        let generated = parts.map(|part| Ok(sample::generate(part.name, &Default::default())?));
        let only = options.only.clone();
        let is_wanted = move |model: &Result<Model, _>| {
            let name = model.as_ref().map_or("", |model| &model.name);
            only.is_empty() || only.iter().any(|only| only == name)
        };
        let combs = comb::combs().into_iter().map(Ok);
        return Ok(Box::new(generated.chain(combs).filter(is_wanted)));
    }
    let folder = options.folder.clone();
    let names = names(options)?.into_iter();
    Ok(Box::new(
        names.filter_map(move |name| read(&folder, &name).transpose()),
    ))
}

type Models<'o, T = Model> = Box<dyn Iterator<Item = Result<T, Box<dyn Error>>> + 'o>;

/// Models with a truth in the folder asked for, by number and name.
fn names(options: &Options) -> Result<Vec<String>, Box<dyn Error>> {
    let mut numbered: Vec<(u32, String)> = fs::read_dir(&options.folder)?
        .filter_map(|entry| {
            let file = entry.ok()?.file_name().into_string().ok()?;
            let name = file.strip_suffix(".txt")?;
            let number = name
                .strip_prefix("PC")
                .and_then(|digits| digits.parse().ok());
            let has_truth = options
                .folder
                .join(format!("{name}_primitives.txt"))
                .exists();
            let wanted = options.only.is_empty() || options.only.iter().any(|only| only == name);
            (wanted && has_truth).then(|| (number.unwrap_or(0), name.to_owned()))
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

fn run(options: &Options, model: Model, noise: f64) -> Result<Row, Box<dyn Error>> {
    let mut parameters = options.parameters;
    if options.told > 0.0 {
        parameters.set("noise", options.told * noise)?;
    }
    let (parameters, seed) = (&parameters, options.seed);
    let start = Instant::now();
    let (found, deviation) = match options.finder {
        Finder::Method(method) => {
            let fit = fit::fit(&model.cloud, method, parameters, seed, &mut ())?;
            (fit.segmentation, fit.noise.deviation)
        }
        Finder::Oracle => (oracle::fit(&model, parameters)?, 0.0),
    };
    let seconds = start.elapsed().as_secs_f64();
    let truth = model.truth.clone().unwrap_or_default();
    let report = evaluate(&model.cloud, &truth, &found, Protocol::Definition);
    let mut lost = lost(&report);
    if let (true, Finder::Method(method)) = (options.diagnose, options.finder) {
        let mut search = Search::new(&model.cloud, parameters, seed);
        fit::find(&mut search, method, &mut ())?;
        lost = diagnose::diagnose(&search, &truth, &found, &report);
    }
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
        found: found.primitives.len(),
        dsc: counted_dsc(&report, options.counted),
        prediction_dsc: report.hidden.prediction_dsc.unwrap_or(0.0),
        types_right,
        types,
        mfe: mean(Measure::Mfe),
        hausdorff: mean(Measure::DHaus),
        d1: mean(Measure::D1),
        noise: deviation / model.cloud.bounds().diagonal(),
        seconds,
        lost,
    })
}

/// Mean DSC of the true primitives of at least so many points.
fn counted_dsc(report: &Report, least: usize) -> f64 {
    let rows = report.primitives.iter().filter(|row| row.size >= least);
    let of = rows.map(|row| row.classification[Measure::Dsc].unwrap_or(0.0));
    let (sum, count) = of.fold((0.0, 0usize), |(sum, count), dsc| (sum + dsc, count + 1));
    sum / count.max(1) as f64
}

/// A line for each primitive that nothing found matches well.
fn lost(report: &Report) -> Vec<String> {
    let found = |place: usize| {
        let prediction = &report.predictions[place];
        let kind = prediction.kind.map_or("?", |kind| kind.name());
        format!("{kind} {} of {} points", prediction.number, prediction.size)
    };
    let rows = report.primitives.iter();
    rows.filter_map(|row| {
        let dsc = row.classification[Measure::Dsc].unwrap_or(0.0);
        (dsc < 0.9).then(|| {
            let kind = row.kind.map_or("?", |kind| kind.name());
            let matched = row.matched.map_or("nothing".to_owned(), found);
            format!(
                "{kind} {} of {} points: {dsc:.3}, {matched}",
                row.number, row.size
            )
        })
    })
    .collect()
}

impl std::fmt::Display for Row {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:8} {:>8} {:>5} {:>5} {:.4} {:.3} {:>2}/{:<2} {:.1e} {:.1e} {:.1e} {:.1e} {:>8.3}",
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
            self.noise,
            self.seconds,
        )
    }
}

/// How well the models were found, on average.
fn means(rows: &[Row]) -> String {
    let count = rows.len().max(1) as f64;
    let mean = |value: fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / count;
    let right: usize = rows.iter().map(|row| row.types_right).sum();
    let types: usize = rows.iter().map(|row| row.types).sum();
    format!(
        "{} models: mean DSC {:.4}, from the prediction's side {:.4}, types right {:.4}",
        rows.len(),
        mean(|row| row.dsc),
        mean(|row| row.prediction_dsc),
        right as f64 / types.max(1) as f64,
    )
}

fn summarise(rows: &mut [Row]) {
    if rows.is_empty() {
        println!("no model with a ground truth");
        return;
    }
    println!("{}", means(rows));
    let count = rows.len() as f64;
    let mean = |value: fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / count;
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
