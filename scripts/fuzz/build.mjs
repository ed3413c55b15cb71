// Builds the fuzzer, with counters in the code under test where the toolchain can.

import { join } from "node:path";
import { ROOT } from "../lib/paths.mjs";
import { ask, run, say } from "../lib/run.mjs";

const ARGUMENTS = ["build", "--locked", "--quiet", "--profile", "fuzz", "--package", "fit4cad-fuzz"];

/** Gives the path of the program. */
export async function buildFuzzer() {
  // Windows starts no script in the place of rustc, and its linker gathers no counters.
  const guided = process.platform !== "win32";
  say(guided ? "building the fuzzer" : "building the fuzzer, which has to go blind on Windows: no counters tell it what it reaches");
  const env = guided ? { RUSTC_WORKSPACE_WRAPPER: join(ROOT, "scripts/fuzz/rustc.mjs") } : {};
  await run("cargo", ARGUMENTS, { env });
  const { target_directory: folder } = JSON.parse(ask("cargo", ["metadata", "--no-deps", "--format-version", "1"]) ?? "{}");
  return join(folder, "fuzz", process.platform === "win32" ? "fit4cad-fuzz.exe" : "fit4cad-fuzz");
}
