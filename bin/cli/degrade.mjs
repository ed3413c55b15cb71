// `fit4cad degrade`.

import { join } from "node:path";
import { SAMPLE_OPTIONS } from "../../www/generated/declared/sample-options.js";
import { WEAR, wearWords } from "../../www/shared/results/wear.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { collect, unusable } from "./inputs.mjs";
import { bareName } from "./standing/entry.mjs";
import { setsOf } from "./standing/folder.mjs";
import { degradeAll } from "./standing/known.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, numbersOf, readArguments } from "./usage.mjs";
import { makeFolder, problemOf, writeWhole } from "./write.mjs";

const SEED = SAMPLE_OPTIONS.filter(({ name }) => name === "seed");
const FLAGS = /** @type {Record<string, { type: "string" }>} */ (Object.fromEntries([...WEAR, ...SEED].map(({ name }) => [name, { type: "string" }])));

const OPTIONS = /** @type {const} */ ({
  set: { type: "string" },
  out: { type: "string", default: "." },
});

/**
 * Makes worse scans of models, with their truth; gives the exit code.
 * @param {readonly string[]} args
 */
export async function degrade(args) {
  const { values: given, positionals } = readArguments(args, { ...OPTIONS, ...FLAGS });
  /** @type {import("./usage.mjs").Values<typeof OPTIONS>} */
  const values = given;
  const how = howOf(values.set, numbersOf([...WEAR, ...SEED], given));
  if (positionals.length === 0) throw new UsageError("give at least one file, folder or zip with models and their truth");
  makeFolder(values.out);
  const engine = await loadEngine();
  const inputs = await collect(positionals);
  /** @type {Map<string, string>} */
  const made = new Map();
  const problems = [...inputs.diagnostics];
  await degradeAll(engine, inputs.files, how, (path, text, model) => {
    progress.show(`${model}: ${wearWords(how.degraded)}`);
    if (made.has(path)) problems.push(unusable(path, `there are several models called ${bareName(model)}; the last is kept`, "Give the models of one set at a time", "warning"));
    const problem = problemOf(() => writeWhole(join(values.out, path), text));
    if (problem === undefined) made.set(path, model);
    else problems.push(unusable(path, problem));
  });
  progress.clear();
  const lacking = how.models.filter((model) => ![...made.values()].includes(model));
  if (lacking.length > 0) problems.push(unusable(values.set ?? "", `the set has ${lacking.join(", ")}, of which there is no cloud with its truth among the files`));
  tell(engine, problems);
  if (made.size === 0) warn("fit4cad degrade: nothing was made. It needs a cloud with its truth; see fit4cad degrade --help.");
  await print([...made.keys()].map((path) => `${join(values.out, path)}\n`).join(""));
  return made.size === 0 || problems.some(({ severity }) => severity === "error") ? 1 : 0;
}

/**
 * Which models are made worse, and how.
 * @param {string | undefined} set
 * @param {Record<string, number>} numbers
 * @returns {{ models: readonly string[], degraded: import("../../www/shared/results/wear.mjs").Wear }}
 */
function howOf(set, numbers) {
  if (set === undefined) {
    if (!WEAR.some(({ name }) => numbers[name] !== undefined)) throw new UsageError(`say what is to be done: ${WEAR.map(({ name }) => `--${name} N`).join(", ")}, or --set NAME`);
    return { models: [], degraded: { ...numbers, seed: numbers.seed ?? 1 } };
  }
  if (Object.keys(numbers).length > 0) throw new UsageError("--set says all that is to be done: leave the other options out");
  const { sets } = setsOf();
  const found = sets.find(({ id }) => id === set);
  if (!found?.degraded) {
    throw new UsageError(`--set ${set}: expected ${sets.flatMap(({ id, degraded }) => (degraded ? [id] : [])).join(", ")}`);
  }
  return { models: found.models, degraded: found.degraded };
}
