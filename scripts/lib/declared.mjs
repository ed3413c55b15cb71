// What Rust declares, as modules that page, command line and formats import before any wasm
// is loaded: one module a list, so that each part of the page carries what it shows and no more.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { ROOT } from "./paths.mjs";

/** The figures of the paper's methods, which the crate holds as data. */
export const PUBLISHED = join(ROOT, "crate/fit4cad/src/metrics/published.json");
const PUBLISHED_ROWS = `Readonly<Record<"PG" | "HT", Readonly<Record<Protocol | "paper", readonly (number | null)[]>>>>`;
const PUBLISHED_TYPE = `{ readonly measures: readonly Measure[]; readonly models: Readonly<Record<string, { readonly points: number; readonly truth: number } & ${PUBLISHED_ROWS}>> }`;

/**
 * Writes a module for each list that the engine and the module for STEP files declare.
 * @param {{ engine: string, cad: string }} modules folders of the two, as wasm-bindgen made them
 * @param {string} folder where the modules go, emptied before
 */
export async function writeDeclared({ engine, cad }, folder) {
  const { declarations } = await load(engine, "engine");
  const { importOptions } = await load(cad, "cad");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const [key, list] of Object.entries(declarations())) {
    write(folder, key, list, `import type { Declarations } from "../engine/engine.js"`, `Readonly<Declarations["${key}"]>`);
  }
  write(folder, "importOptions", importOptions(), `import type { OptionInfo } from "../cad/cad.js"`, "readonly OptionInfo[]");
  const { measures, models } = JSON.parse(readFileSync(PUBLISHED, "utf8"));
  write(folder, "published", { measures, models }, `import type { Measure, Protocol } from "../engine/engine.js"`, PUBLISHED_TYPE);
}

/**
 * @param {string} folder
 * @param {string} name
 */
async function load(folder, name) {
  // Another address each time: it may have been built anew since it was last imported.
  const module = await import(`${pathToFileURL(join(folder, `${name}.js`)).href}?built=${Date.now()}`);
  module.initSync({ module: readFileSync(join(folder, `${name}_bg.wasm`)) });
  return module;
}

/**
 * @param {string} folder
 * @param {string} key
 * @param {unknown} list
 * @param {string} imported what declares the type
 * @param {string} type
 */
function write(folder, key, list, imported, type) {
  const words = key.split(/(?=[A-Z])/);
  const file = join(folder, words.join("-").toLowerCase());
  const name = words.join("_").toUpperCase();
  writeFileSync(`${file}.js`, `export const ${name} = ${JSON.stringify(list)};\n`);
  writeFileSync(`${file}.d.ts`, `${imported};\n\nexport declare const ${name}: ${type};\n`);
}
