// Every test there is. `npm test -- NAME…` runs only the steps whose names contain one of the words.

import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { buildPage, buildWasm } from "./build.mjs";
import { fuzzQuickly } from "./fuzz.mjs";
import { denyCrates } from "./lib/deny.mjs";
import { ROOT, WASM_TARGET, npmCommand } from "./lib/paths.mjs";
import { testPython } from "./lib/python.mjs";
import { Plain, main, run, runNode } from "./lib/run.mjs";
import { circles, tell } from "./lib/rust-modules.mjs";
import { runNodeTests, runSteps, summarise } from "./lib/steps.mjs";
import { setup } from "./setup.mjs";

const CLIPPY = ["clippy", "--locked", "--quiet"];
const DENY = ["--", "-D", "warnings"];
const ROOTS = ["fit4cad", "engine", "scorer", "step", "view", "fuzz", "cad", "hdf5", "python"].map((name) => `crate/${name}/src/lib.rs`);
const BOUNDARIES = ["--package", "fit4cad-engine", "--package", "fit4cad-view"];

/** @type {import("./lib/steps.mjs").Step[]} */
const STEPS = [
  {
    name: "rustfmt",
    lane: "rust",
    run: () => run("cargo", ["fmt", "--all", "--check"]),
  },
  {
    name: "wasm build",
    lane: "page",
    run: buildWasm,
  },
  {
    name: "tsc --strict",
    lane: "page",
    needs: ["wasm build"],
    run: async () => {
      for (const project of [".", "tests/node"]) {
        await runNode(npmCommand("typescript/bin/tsc"), ["--noEmit", "--project", project]);
      }
    },
  },
  {
    name: "oxlint, with types",
    lane: "page",
    needs: ["wasm build"],
    run: () => runNode(npmCommand("oxlint/bin/oxlint"), ["--type-aware", "--deny-warnings"]),
  },
  {
    name: "page build",
    lane: "page",
    needs: ["wasm build"],
    run: buildPage,
  },
  {
    name: "clippy, native",
    lane: "rust",
    run: () => run("cargo", [...CLIPPY, "--workspace", "--all-targets", ...DENY]),
  },
  {
    name: "clippy, wasm",
    lane: "rust",
    run: () => {
      const targets = ["--lib", "--test", "*"];
      return run("cargo", [...CLIPPY, "--target", WASM_TARGET, ...BOUNDARIES, ...targets, ...DENY]);
    },
  },
  {
    name: "circles of Rust modules",
    lane: "rust",
    run: async () => {
      const found = ROOTS.flatMap((root) => circles(join(ROOT, root)));
      if (found.length > 0) {
        throw new Plain(found.map((circle) => ["a circle:", ...tell(circle)].join("\n  ")).join("\n"));
      }
    },
  },
  {
    name: "licences, versions and faults of crates",
    lane: "rust",
    run: denyCrates,
  },
  {
    // What is packed is not built again: `cargo publish --dry-run --package fit4cad` does that too.
    name: "crate, packed",
    lane: "rust",
    run: () => run("cargo", ["package", "--locked", "--quiet", "--no-verify", "--allow-dirty", "--package", "fit4cad"]),
  },
  {
    name: "Rust tests, native",
    lane: "rust",
    runner: "cargo",
    run: () => run("cargo", ["test", "--locked", "--workspace", "--no-fail-fast"], { capture: true }),
  },
  {
    name: "Rust tests, wasm under Node",
    lane: "rust",
    runner: "cargo",
    run: () =>
      run(
        "cargo",
        [
          ...["test", "--locked", "--no-fail-fast", "--target", WASM_TARGET],
          ...["--package", "fit4cad", ...BOUNDARIES, "--lib", "--test", "*"],
        ],
        { capture: true },
      ),
  },
  {
    name: "command line",
    // The page's lane has the browser, which takes as long as all the rest of this one.
    lane: "rust",
    runner: "node",
    needs: ["wasm build"],
    run: () => runNodeTests(testFiles("tests/node", ".test.mjs")),
  },
  {
    name: "one more measure",
    lane: "rust",
    runner: "node",
    needs: ["wasm build"],
    run: () => runNodeTests(testFiles("tests/declared", ".test.mjs")),
  },
  {
    name: "Python",
    lane: "rust",
    runner: "pytest",
    needs: ["wasm build"],
    run: testPython,
  },
  {
    name: "fuzzing, a minute",
    lane: "rust",
    needs: ["wasm build"],
    run: fuzzQuickly,
  },
  {
    name: "browser tests",
    lane: "page",
    runner: "playwright",
    needs: ["page build"],
    run: async () => {
      const { ensureBrowser } = await import("./lib/browser.mjs");
      await ensureBrowser();
      return runNode(npmCommand("@playwright/test/cli.js"), ["test", "--reporter", "list"], {
        capture: true,
      });
    },
  },
];

/**
 * @param {string} folder
 * @param {string} ending
 */
function testFiles(folder, ending) {
  const path = join(ROOT, folder);
  return existsSync(path)
    ? readdirSync(path)
        .filter((name) => name.endsWith(ending))
        .sort()
        .map((name) => join(path, name))
    : [];
}

await main(async () => {
  const words = process.argv.slice(2);
  const chosen = STEPS.filter(
    ({ name }) => words.length === 0 || words.some((word) => name.includes(word)),
  );
  await setup();
  const well = summarise(await runSteps(chosen));
  process.exitCode = well ? 0 : 1;
});
