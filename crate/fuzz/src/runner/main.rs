//! Runs the targets on mutated inputs, keeps those that reach code no other reached, and stops at
//! what should not be: a panic, two seconds of work, memory out of proportion.
//!
//! `npm run fuzz` builds it with counters in the code under test (`scripts/fuzz/build.mjs`) and calls
//! it once a target. Built without, it mutates what it has, and says so. With a seed and a number of
//! runs it does the same every time.

mod corpus;
mod coverage;
mod fault;
mod memory;
mod mutate;
mod options;
mod random;
mod session;
mod watch;

use std::process::ExitCode;

use fuzz_targets::TARGETS;
use options::{Options, Task};

fn main() -> ExitCode {
    let options = match Options::from_arguments(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(problem) => {
            eprintln!("{problem}");
            return ExitCode::from(2);
        }
    };
    match &options.task {
        Task::List => {
            for target in TARGETS {
                println!("{} {}", target.name, target.quick);
            }
            ExitCode::SUCCESS
        }
        Task::Replay(target, file) => session::replay(target, file, &options),
        Task::Fuzz(target) => session::fuzz(target, &options),
    }
}
