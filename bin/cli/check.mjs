// `fit4cad check`.

import { join } from "node:path";
import { findings as table } from "../../www/shared/formats/findings.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect, unusable } from "./inputs.mjs";
import { eachModel, isOfTruth } from "./models.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, readArguments } from "./usage.mjs";
import { makeFolder, problemOf, writeWhole } from "./write.mjs";

/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */

const OPTIONS = /** @type {const} */ ({
  ...FORMAT_OPTIONS,
  write: { type: "string" },
});

const FORMS = /** @type {const} */ (["parametric", "implicit"]);

/**
 * Audits every ground truth that the arguments name; gives the exit code.
 * @param {readonly string[]} args
 */
export async function check(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const format = formatOf(values, ["table", "json"]);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = await collect(positionals);
  /** @type {import("../engine/engine.js").Audit[]} */
  const audits = [];
  const problems = [...inputs.diagnostics];
  const writer = values.write === undefined ? undefined : new Writer(values.write, problems);
  /** @param {string} text */
  const show = (text) => progress.show(`checking ${text}`);
  const read = await eachModel(engine, inputs.files, { wanted: isOfTruth, progress: show }, (model, _files, _place, able) => {
    const { name, hasTruth } = model.info();
    audits.push(model.audit());
    if (!hasTruth) {
      problems.push(unusable(name, "there is no ground truth to check", `Give ${name}_primitives.txt as well`));
    } else {
      writer?.write(able, name, model.corrected());
    }
  });
  progress.clear();

  const told = [...problems, ...read.diagnostics];
  tell(read.engine, told);
  if (audits.length === 0) {
    warn("fit4cad check: nothing could be checked. A check needs a cloud and its truth; see fit4cad check --help.");
  }
  for (const { path, numbers } of writer?.written ?? []) {
    warn(`wrote ${path}: replaced the vectors of primitives ${numbers.join(", ")}`);
  }
  const made = audits.map((audit) => ({ engine: engine.version(), ...audit }));
  await print(format === "json" ? `${JSON.stringify(made, null, 2)}\n` : table(audits));
  const wrong = audits.some(({ findings }) => findings.some(({ severity }) => severity !== "note"));
  const failed = told.some(({ severity }) => severity === "error");
  return audits.length === 0 || wrong || failed ? 1 : 0;
}

/** Writes corrected surface files, each once, and remembers which. */
class Writer {
  /** @type {{ path: string, numbers: number[] }[]} */
  written = [];
  /** @type {Set<string>} */
  #paths = new Set();

  /**
   * @param {string} folder
   * @param {Diagnostic[]} problems gets what could not be written
   */
  constructor(folder, problems) {
    makeFolder(folder);
    this.folder = folder;
    this.problems = problems;
  }

  /**
   * @param {import("./engine.mjs").Engine} engine
   * @param {string} name of the model
   * @param {import("../engine/engine.js").Corrected} corrected
   */
  write(engine, name, { corrections, ...texts }) {
    for (const form of FORMS) {
      const text = texts[form];
      if (text === undefined) {
        continue;
      }
      const path = join(this.folder, engine.pathOf("beside", name, form));
      const problem = this.#writeOnce(path, text);
      if (problem === undefined) {
        const own = corrections.filter((correction) => correction.form === form);
        this.written.push({ path, numbers: own.map(({ primitive }) => primitive) });
      } else {
        this.problems.push(unusable(path, problem));
      }
    }
  }

  /**
   * What keeps the file from being written.
   * @param {string} path
   * @param {string} text
   */
  #writeOnce(path, text) {
    if (this.#paths.has(path)) {
      return "it was not written: two models have this name; check their folders one at a time";
    }
    this.#paths.add(path);
    return problemOf(() => writeWhole(path, text));
  }
}
