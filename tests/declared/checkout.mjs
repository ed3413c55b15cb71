// A checkout whose engine declares one more measure, and in which no line outside Rust is another.

import { cpSync, mkdirSync, rmSync, symlinkSync } from "node:fs";
import { join, relative, sep } from "node:path";
import { writeDeclared } from "../../scripts/lib/declared.mjs";
import { ROOT, WASM_TARGET, npmCommand, tool } from "../../scripts/lib/paths.mjs";
import { run, runNode } from "../../scripts/lib/run.mjs";

const FEATURE = "one-more-measure";
const CHECKOUT = join(ROOT, "target", FEATURE);
/** What page and command line are made of, but for what is built. */
const SOURCES = ["bin", "www", "results", "scripts/lib", "vite.config.ts", "package.json", "CITATION.cff"];
const BUILT = ["bin/engine", "www/generated/engine", "www/generated/scorer", "www/generated/declared", "www/dist"];

/** Key and name of the measure that the feature declares. */
export const ONE_MORE = { key: "IoU", name: "Intersection over union (Jaccard index)" };

/** Builds the engine with the feature, copies the sources beside it, and gives the folder. */
export async function checkoutWithOneMoreMeasure() {
  const build = ["build", "--locked", "--quiet", "--target", WASM_TARGET];
  await run("cargo", [...build, "--package", "fit4cad-engine", "--features", FEATURE]);
  const wasm = join(ROOT, "target", WASM_TARGET, "debug/fit4cad_engine.wasm");
  rmSync(CHECKOUT, { recursive: true, force: true });
  mkdirSync(CHECKOUT, { recursive: true });
  for (const source of SOURCES) {
    cpSync(join(ROOT, source), join(CHECKOUT, source), { recursive: true, filter: (path) => !isBuilt(path) });
  }
  symlinkSync(join(ROOT, "node_modules"), join(CHECKOUT, "node_modules"), "junction");
  // The scorer is the engine without its workshop: here the whole engine stands in its place.
  for (const name of ["engine", "scorer"]) {
    const out = ["--target", "web", "--out-name", name, "--out-dir", join(CHECKOUT, "www/generated", name)];
    await run(tool("wasm-bindgen"), [...out, wasm]);
  }
  cpSync(join(CHECKOUT, "www/generated/engine"), join(CHECKOUT, "bin/engine"), { recursive: true });
  await writeDeclared({ engine: join(CHECKOUT, "bin/engine"), cad: join(CHECKOUT, "bin/cad") }, join(CHECKOUT, "www/generated/declared"));
  return CHECKOUT;
}

/**
 * Builds the page of the checkout; gives the folder to serve.
 * @param {string} checkout
 */
export async function pageOf(checkout) {
  await runNode(npmCommand("vite/bin/vite.js"), ["build", "--logLevel", "warn", "--config", join(checkout, "vite.config.ts")], {
    cwd: checkout,
  });
  return join(checkout, "www/dist");
}

/** @param {string} path */
function isBuilt(path) {
  return BUILT.includes(relative(ROOT, path).split(sep).join("/"));
}
