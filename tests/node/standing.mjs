// A standing table of made-up models: what the tests of results share.

import { readFileSync, readdirSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { zipSync } from "fflate";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { folder } from "./support.mjs";

const PARTS = ["bracket", "flange", "elbow"];
const ARCHIVE = "https://answers.example/mine.zip";

export const SETS = `
[source]
repository = "https://example.com/data"
commit = "${"0".repeat(40)}"
archive = "https://data.example/public.zip"

[[sets]]
id = "made-up"
title = "Made up"
meaning = "Three parts."
part = "test"
numbers = [[1, 3]]

[[sets]]
id = "made-up-noise"
title = "Made up, noise"
meaning = "The same with noise."
of = "made-up"
degraded = { noise = 0.001, seed = 3 }
`;

/**
 * A whole `method.toml`, with lines that take the place of its own by their keys.
 * @param {Readonly<Record<string, string>>} other
 */
export function methodToml(other = {}) {
  const lines = Object.entries({ name: '"Mine"', year: "2026", kind: '"other"', trained_on: '"nothing"', added: "2026-11-29", authors: '[{ name = "We" }]', time: '{ platform = "native", machine = "a machine" }', answers: '{ called = "Imperfect", licence = "CC0-1.0", script = "scripts/results/mine.py" }', ...other });
  return lines.map(([key, value]) => `${key} = ${value}\n`).join("");
}

/** An archive of answers as `method.toml` names it. @param {string} sha256 */
export function archived(sha256) {
  return `{ called = "Imperfect", licence = "CC0-1.0", archive = "${ARCHIVE}", sha256 = "${sha256}" }`;
}

/**
 * Clouds and truth in `data`, answers of the method Imperfect in `answers`, a table without rows in `results`.
 * @param {import("node:test").TestContext} test
 */
export async function madeUp(test) {
  const engine = await loadEngine();
  /** @type {Record<string, string>} */
  const files = { "results/sets.toml": SETS };
  PARTS.forEach((part, at) => {
    const model = engine.Model.generate(part, { spacing: 0.04 });
    const method = model.imperfect(1);
    for (const [owner, top] of /** @type {const} */ ([[undefined, "data"], [method, "answers"]])) {
      for (const [role, text] of Object.entries(model.write(owner))) {
        files[`${top}/${engine.pathOf("test-set", `PC${at + 1}`, /** @type {import("../../bin/engine/engine.js").Role} */ (role), owner)}`] = text;
      }
    }
    model.free();
  });
  const root = folder(test, files);
  return { root, data: join(root, "data"), answers: join(root, "answers"), results: join(root, "results") };
}

/**
 * The files below a folder as a zip.
 * @param {string} root
 */
export function zipped(root) {
  const paths = readdirSync(root, { recursive: true }).map((path) => join(root, String(path))).filter((path) => statSync(path).isFile());
  return zipSync(Object.fromEntries(paths.map((path) => [relative(root, path), new Uint8Array(readFileSync(path))])));
}
