//! Whether the runner finds the faults that are planted for it, writes their inputs down, and finds them
//! in those again.

#![allow(clippy::unwrap_used, reason = "helpers of tests are tests")]

use std::path::PathBuf;
use std::process::{Command, Output};

fn runner(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_fit4cad-fuzz"))
        .args(arguments)
        .output()
        .unwrap()
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).unwrap();
    }
    folder
}

/// Runs a target until it must have failed; the file of the input that did it.
fn fails(target: &str, word: &str) -> PathBuf {
    let folder = folder(target);
    let found = folder.to_str().unwrap();
    let run = runner(&[target, "--runs", "20000", "--found", found]);
    let said = String::from_utf8(run.stdout).unwrap();
    assert_eq!(run.status.code(), Some(1), "{said}");
    assert!(said.contains(word), "{said}");
    let file = std::fs::read_dir(&folder).unwrap().next().unwrap().unwrap();
    assert!(said.contains(file.path().to_str().unwrap()), "{said}");
    file.path()
}

#[test]
fn a_hang_memory_and_a_panic_are_found_and_found_again() {
    for (target, word) in [
        ("planted-hang", "a hang"),
        ("planted-allocation", "too much memory"),
        ("planted-exhaustion", "too much memory"),
        ("planted-assertion", "a panic at"),
    ] {
        let input = fails(target, word);
        let again = runner(&[target, "--replay", input.to_str().unwrap()]);
        let said = String::from_utf8(again.stdout).unwrap();
        assert_eq!(again.status.code(), Some(1), "{said}");
        assert!(said.contains(word), "{said}");
    }
}

#[test]
fn a_seed_gives_the_same_runs_again_and_no_fault_is_no_failure() {
    let told = |seed: &str| {
        let run = runner(&[
            "paths",
            "--runs",
            "3000",
            "--seed",
            seed,
            "--found",
            folder("none").to_str().unwrap(),
        ]);
        let said = String::from_utf8(run.stdout).unwrap();
        assert_eq!(run.status.code(), Some(0), "{said}");
        said.split_once(" runs").unwrap().0.to_owned()
    };
    assert_eq!(told("5"), told("5"));
    assert!(told("5").contains("3000"));
}

#[test]
fn what_is_not_understood_is_told() {
    for arguments in [
        &["nosuch"][..],
        &["paths", "--runs", "many"],
        &["--replay", "x"],
        &["paths", "--what"],
    ] {
        let run = runner(arguments);
        assert_eq!(run.status.code(), Some(2));
        assert!(!run.stderr.is_empty() && run.stdout.is_empty());
    }
}
