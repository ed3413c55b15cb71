//! The command line.

use std::path::PathBuf;
use std::time::Duration;

use fuzz_targets::{PLANTED, TARGETS, Target};

/// What to do.
pub enum Task {
    /// Name the targets, with the runs that a quick look gives each.
    List,
    /// Run a target on one input.
    Replay(&'static Target, PathBuf),
    /// Run it on many.
    Fuzz(&'static Target),
}

/// Everything asked for.
pub struct Options {
    /// What to do.
    pub task: Task,
    /// Seed of the mutations.
    pub seed: u64,
    /// How many runs, if that is the limit.
    pub runs: Option<u64>,
    /// For how long, if that is the limit.
    pub time: Option<Duration>,
    /// Folder with a file of inputs for each target.
    pub corpus: PathBuf,
    /// Folder for inputs that do harm.
    pub found: PathBuf,
    /// Whether to leave in the corpus what was worth keeping, and nothing else.
    pub grow: bool,
    /// Whether to write each input to a file before it is run, for what ends the process at once.
    pub careful: bool,
}

const USAGE: &str = "usage: fit4cad-fuzz --list | TARGET [--runs N] [--seconds N] [--seed N] [--corpus FOLDER] \
                     [--found FOLDER] [--grow] [--careful] [--replay FILE]";

impl Options {
    /// Reads them.
    ///
    /// # Errors
    /// What is wrong with them, for the reader.
    pub fn from_arguments(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let mut options = Self {
            task: Task::List,
            seed: 1,
            runs: None,
            time: None,
            corpus: folder.join("corpus"),
            found: folder.join("found"),
            grow: false,
            careful: false,
        };
        let (mut target, mut replay, mut list) = (None, None, false);
        let mut arguments = arguments;
        while let Some(argument) = arguments.next() {
            let mut value = || {
                arguments
                    .next()
                    .ok_or_else(|| format!("{argument} needs a value\n{USAGE}"))
            };
            match argument.as_str() {
                "--list" => list = true,
                "--grow" => options.grow = true,
                "--careful" => options.careful = true,
                "--runs" => options.runs = Some(number(&value()?)?),
                "--seconds" => options.time = Some(Duration::from_secs(number(&value()?)?)),
                "--seed" => options.seed = number(&value()?)?,
                "--corpus" => options.corpus = PathBuf::from(value()?),
                "--found" => options.found = PathBuf::from(value()?),
                "--replay" => replay = Some(PathBuf::from(value()?)),
                name if !name.starts_with('-') && target.is_none() => target = Some(find(name)?),
                _ => return Err(format!("what is `{argument}`?\n{USAGE}")),
            }
        }
        options.task = match (target, replay) {
            (None, None) if list => Task::List,
            (Some(target), Some(file)) => Task::Replay(target, file),
            (Some(target), None) => Task::Fuzz(target),
            (None, _) => return Err(USAGE.to_owned()),
        };
        if options.runs.is_none() && options.time.is_none() {
            options.time = Some(Duration::from_secs(60));
        }
        Ok(options)
    }
}

fn find(name: &str) -> Result<&'static Target, String> {
    let all = || TARGETS.iter().chain(PLANTED);
    all().find(|target| target.name == name).ok_or_else(|| {
        let names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
        format!(
            "there is no target `{name}`; there are {}",
            names.join(", ")
        )
    })
}

fn number(text: &str) -> Result<u64, String> {
    let plain = text.replace(['_', ','], "");
    plain
        .parse()
        .map_err(|_| format!("`{text}` is not a whole number"))
}
