// Every test there is. `npm test -- NAME…` runs only the steps whose names contain one of the words.

import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { buildPage, buildWasm } from "./build.mjs";
import { ROOT, WASM_TARGET, npmCommand } from "./lib/paths.mjs";
import { main, run, runNode } from "./lib/run.mjs";
import { runSteps, summarise } from "./lib/steps.mjs";
import { setup } from "./setup.mjs";

const CLIPPY = ["clippy", "--locked", "--quiet"];
const DENY = ["--", "-D", "warnings"];
const BOUNDARIES = ["--package", "fit4cad-engine", "--package", "fit4cad-view"];

const STEPS = [
  {
    name: "rustfmt",
    run: () => run("cargo", ["fmt", "--all", "--check"]),
  },
  {
    name: "wasm build",
    run: buildWasm,
  },
  {
    name: "tsc --strict",
    needs: ["wasm build"],
    run: () => runNode(npmCommand("typescript/bin/tsc"), ["--noEmit", "--project", ROOT]),
  },
  {
    name: "clippy, native",
    run: () => run("cargo", [...CLIPPY, "--workspace", "--all-targets", ...DENY]),
  },
  {
    name: "clippy, wasm",
    run: () => {
      const targets = ["--lib", "--test", "*"];
      return run("cargo", [...CLIPPY, "--target", WASM_TARGET, ...BOUNDARIES, ...targets, ...DENY]);
    },
  },
  {
    name: "Rust tests, native",
    runner: "cargo",
    run: () => run("cargo", ["test", "--locked", "--workspace", "--no-fail-fast"], { capture: true }),
  },
  {
    name: "Rust tests, wasm under Node",
    runner: "cargo",
    run: () =>
      run(
        "cargo",
        ["test", "--locked", "--target", WASM_TARGET, "--package", "fit4cad-engine", "--test", "*"],
        { capture: true },
      ),
  },
  {
    name: "command line",
    runner: "node",
    needs: ["wasm build"],
    run: () =>
      run(
        process.execPath,
        ["--test", "--test-reporter", "spec", ...testFiles("tests/node", ".test.mjs")],
        { capture: true },
      ),
  },
  {
    name: "page build",
    needs: ["wasm build"],
    run: buildPage,
  },
  {
    name: "browser tests",
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
