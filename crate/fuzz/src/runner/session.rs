//! A target run again and again.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io;
use std::panic;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use fuzz_targets::Target;

use crate::corpus::{self, Corpus};
use crate::coverage::Coverage;
use crate::fault::{Fault, Report};
use crate::memory;
use crate::mutate::mutate;
use crate::options::Options;
use crate::random::Random;
use crate::watch;

/// Bytes of memory that a byte of the input may cost.
const MEMORY_PER_BYTE: usize = 1_000;
/// Different faults of a target after which it is enough.
const ENOUGH: usize = 10;
/// Runs spent on making the input of a fault shorter.
const SHORTENING: usize = 2_000;
/// Runs between two looks at the clock.
const LOOK: u64 = 64;
/// Seconds between two lines that say how far it is.
const LINE: u64 = 30;

thread_local! {
    /// Where the last panic was, and its words.
    static PANIC: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
}

/// Keeps what a panic says, and prints it as well or not.
fn listen(aloud: bool) {
    let print = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if aloud {
            print(info);
        }
        let place = info
            .location()
            .map_or_else(String::new, ToString::to_string);
        let payload = info.payload();
        let owned = payload.downcast_ref::<String>().map(String::as_str);
        let words = owned.or_else(|| payload.downcast_ref::<&str>().copied());
        let words = words.unwrap_or("no words").to_owned();
        PANIC.with(|kept| *kept.borrow_mut() = Some((place, words)));
    }));
}

/// Runs a target on one input; what it did that it must not, where it did.
fn attempt(target: &Target, input: &[u8]) -> Option<Fault> {
    let (result, held) = memory::peak(|| panic::catch_unwind(|| (target.run)(input)));
    if result.is_err() {
        let (place, words) = PANIC.with(RefCell::take).unwrap_or_default();
        return Some(Fault::Panic(place, words));
    }
    let most = target.floor + MEMORY_PER_BYTE * input.len();
    (held > most).then_some(Fault::Memory(held))
}

/// Runs a target on an input from a file.
pub fn replay(target: &'static Target, file: &Path, options: &Options) -> ExitCode {
    let input = match std::fs::read(file) {
        Ok(input) => input,
        Err(error) => {
            eprintln!("{}: {error}", file.display());
            return ExitCode::from(2);
        }
    };
    let report = report(target, options);
    listen(true);
    watch::start(report.clone());
    watch::begin(1, &input);
    let start = Instant::now();
    let fault = attempt(target, &input);
    watch::over();
    if let Some(fault) = fault {
        report.tell(&fault, &input);
        return ExitCode::FAILURE;
    }
    println!(
        "{}: nothing wrong with it, after {:.3} s",
        target.name,
        start.elapsed().as_secs_f64()
    );
    ExitCode::SUCCESS
}

/// Runs a target on mutated inputs until the limit.
pub fn fuzz(target: &'static Target, options: &Options) -> ExitCode {
    let file = options.corpus.join(target.name);
    let kept = match corpus::read(&file) {
        Ok(kept) => kept,
        Err(error) => {
            eprintln!("{}: {error}", file.display());
            return ExitCode::from(2);
        }
    };
    listen(false);
    watch::start(report(target, options));
    let mut session = Session::new(target, options);
    let mut seeds = (target.seeds)();
    seeds.push(Vec::new());
    seeds.extend(kept);
    session.run_all(seeds);
    session.mutate_on();
    session.tell("done");
    if options.grow
        && let Err(error) = session.grow(&file)
    {
        eprintln!("{}: {error}", file.display());
        return ExitCode::from(2);
    }
    if session.faults.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn report(target: &Target, options: &Options) -> Report {
    Report {
        target: target.name,
        folder: options.found.clone(),
    }
}

struct Session<'a> {
    target: &'static Target,
    options: &'a Options,
    report: Report,
    random: Random,
    coverage: Coverage,
    corpus: Corpus,
    runs: u64,
    start: Instant,
    /// Places of the faults so far.
    faults: BTreeSet<String>,
}

impl<'a> Session<'a> {
    fn new(target: &'static Target, options: &'a Options) -> Self {
        Self {
            target,
            options,
            report: report(target, options),
            random: Random::new(options.seed),
            coverage: Coverage::new(true),
            corpus: Corpus::default(),
            runs: 0,
            start: Instant::now(),
            faults: BTreeSet::new(),
        }
    }

    /// Runs what there is to begin with.
    fn run_all(&mut self, inputs: Vec<Vec<u8>>) {
        let guided = self.coverage.edges() > 0;
        for mut input in inputs {
            input.truncate(self.target.longest);
            let (new, cost) = self.run(&input);
            if !guided || new {
                self.corpus.keep(input, cost);
            }
        }
    }

    fn mutate_on(&mut self) {
        let guided = self.coverage.edges() > 0;
        let mut input = Vec::new();
        let mut line = LINE;
        while !self.is_over() {
            input.clear();
            input.extend_from_slice(self.corpus.pick(&mut self.random));
            let other = self.corpus.pick(&mut self.random);
            mutate(
                &mut input,
                other,
                self.target.words,
                self.target.longest,
                &mut self.random,
            );
            let (new, cost) = self.run(&input);
            if guided && new {
                self.corpus.keep(input.clone(), cost);
            }
            if self.start.elapsed().as_secs() >= line {
                self.tell("so far");
                line += LINE;
            }
        }
    }

    fn is_over(&self) -> bool {
        let enough = self.options.runs.is_some_and(|most| self.runs >= most);
        // Short of the first thousands of runs the clock is looked at every time.
        let look = self.corpus.mean_cost() > 100_000 || self.runs.is_multiple_of(LOOK);
        let late = || {
            self.options
                .time
                .is_some_and(|most| self.start.elapsed() >= most)
        };
        self.faults.len() >= ENOUGH || enough || (look && late())
    }

    /// Runs an input; whether it reached something new, and how many nanoseconds it took.
    fn run(&mut self, input: &[u8]) -> (bool, u64) {
        self.runs += 1;
        if self.options.careful {
            let _ = std::fs::create_dir_all(&self.options.found);
            let _ = std::fs::write(
                self.options
                    .found
                    .join(format!("{}-last", self.target.name)),
                input,
            );
        }
        watch::begin(self.runs, input);
        self.coverage.reset();
        let start = Instant::now();
        let fault = attempt(self.target, input);
        let cost = start.elapsed().as_nanos() as u64;
        let new = self.coverage.collect() > 0;
        watch::over();
        if let Some(fault) = fault
            && self.faults.insert(fault.place().to_owned())
        {
            let (fault, input) = self.shorten(fault, input.to_vec());
            self.report.tell(&fault, &input);
        }
        (new, cost)
    }

    /// Makes the input of a fault shorter while it does the same.
    fn shorten(&mut self, fault: Fault, input: Vec<u8>) -> (Fault, Vec<u8>) {
        let (mut fault, mut input) = (fault, input);
        let mut piece = input.len().div_ceil(2);
        let mut tries = 0;
        while piece > 0 && tries < SHORTENING && !matches!(fault, Fault::Memory(_)) {
            let mut at = 0;
            while at < input.len() && tries < SHORTENING {
                tries += 1;
                let mut shorter = input.clone();
                shorter.drain(at..(at + piece).min(input.len()));
                watch::begin(self.runs, &shorter);
                match attempt(self.target, &shorter) {
                    Some(same) if same.place() == fault.place() => (fault, input) = (same, shorter),
                    _ => at += piece,
                }
                watch::over();
            }
            piece /= 2;
        }
        (fault, input)
    }

    fn tell(&self, when: &str) {
        let seconds = self.start.elapsed().as_secs_f64();
        let edges = self.coverage.edges();
        let guided = if edges > 0 {
            format!(
                "{} of {edges} edges reached, {} inputs kept",
                self.coverage.reached(),
                self.corpus.len()
            )
        } else {
            "blind: built without counters".to_owned()
        };
        println!(
            "{}: {when}, {} runs in {seconds:.1} s ({:.0} a second), {} faults, {guided}",
            self.target.name,
            self.runs,
            self.runs as f64 / seconds.max(1e-9),
            self.faults.len(),
        );
    }

    /// Leaves the shortest inputs that together reach all that was reached, but for what seeds do.
    fn grow(&self, file: &Path) -> io::Result<()> {
        let mut coverage = Coverage::new(false);
        let mut run = self.runs;
        let mut reaches_more = |input: &[u8]| {
            // A number of its own, by which one long run is told from many short ones.
            run += 1;
            watch::begin(run, input);
            coverage.reset();
            let sound = attempt(self.target, input).is_none();
            watch::over();
            coverage.collect() > 0 && sound
        };
        for mut seed in (self.target.seeds)() {
            seed.truncate(self.target.longest);
            reaches_more(&seed);
        }
        let candidates = self.corpus.by_length().into_iter();
        let chosen: Vec<&[u8]> = candidates.filter(|input| reaches_more(input)).collect();
        let count = corpus::write(file, &chosen)?;
        println!(
            "{}: {count} of {} inputs kept in {}",
            self.target.name,
            chosen.len(),
            file.display()
        );
        Ok(())
    }
}
