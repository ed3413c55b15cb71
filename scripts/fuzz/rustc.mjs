#!/usr/bin/env node
// Between cargo and rustc: has counters put into the code under test, and into nothing else. Not into the fuzzer, whose
// own work would look like the target's.

import { spawnSync } from "node:child_process";

/** By the name that rustc is told. */
const UNDER_TEST = ["fit4cad", "fit4cad_step", "fit4cad_view", "fuzz_targets"];
const COUNTERS = [
  "-Cpasses=sancov-module",
  "-Cllvm-args=-sanitizer-coverage-level=3",
  "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
];

const [rustc = "rustc", ...given] = process.argv.slice(2);
const name = given[given.indexOf("--crate-name") + 1] ?? "";
const args = UNDER_TEST.includes(name) ? [...given, ...COUNTERS] : given;
// Its share of processors is promised through files that Node does not pass on.
const { CARGO_MAKEFLAGS: _, ...env } = process.env;
const { status } = spawnSync(rustc, args, { stdio: "inherit", env });
process.exitCode = status ?? 1;
