// `fit4cad import`.

import { createHash } from "node:crypto";
import { basename, join } from "node:path";
import { align } from "../../www/shared/formats/align.mjs";
import { WEAR } from "../../www/shared/results/wear.mjs";
import { CALLED, isStep, nameOfPart } from "../../www/shared/step.mjs";
import { loadCad } from "./cad.mjs";
import { tell } from "./diagnostics.mjs";
import { isStop, loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect, unusable } from "./inputs.mjs";
import { manifestOf, setOf } from "./set.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, number, numbersOf, readArguments } from "./usage.mjs";
import { makeFolder, problemOf, writeWhole } from "./write.mjs";

/** @typedef {import("./engine.mjs").Engine} Engine */
/** @typedef {import("./cad.mjs").Cad} Cad */
/** @typedef {import("./inputs.mjs").File} File */
/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */
/** @typedef {import("../cad/cad.js").ImportOptions} ImportOptions */
/** @typedef {import("../cad/cad.js").ImportReport} ImportReport */
/** @typedef {import("../engine/engine.js").Role} Role */
/** @typedef {Readonly<Record<string, number>>} Wear what is done to the points afterwards */
/** @typedef {Readonly<Record<string, string | boolean | undefined | (string | boolean)[]>>} Given values by the names of their options */
/**
 * A model before it is written.
 * @typedef {object} Made
 * @property {string} name
 * @property {number} points
 * @property {Readonly<Record<string, number>>} types
 * @property {Readonly<Partial<Record<Role, string>>>} texts
 * @property {ImportReport} report
 */

/**
 * What became of one STEP file.
 * @typedef {object} Imported
 * @property {string} model
 * @property {string} source path of the STEP file
 * @property {string} sha256 of its bytes
 * @property {number} points
 * @property {number} primitives
 * @property {Readonly<Record<string, number>>} types primitives of each type
 * @property {Readonly<Record<string, string>>} files SHA-256 of each file written, by its path
 * @property {ImportReport} report
 */

const OPTIONS = /** @type {const} */ ({
  out: { type: "string", default: "." },
  test: { type: "string" },
  bodies: { type: "string" },
  ...FORMAT_OPTIONS,
});

/**
 * Makes models of the STEP files that the arguments name; gives the exit code.
 * @param {readonly string[]} args
 */
export async function importParts(args) {
  const cad = await loadCad();
  const declared = cad.importOptions();
  const flags = /** @type {Record<string, { type: "string" | "boolean" }>} */ (
    Object.fromEntries([
      ...declared.map(({ name, value }) => [name, { type: value.kind === "flag" ? "boolean" : "string" }]),
      ...WEAR.map(({ name }) => [name, { type: "string" }]),
    ])
  );
  const { values: given, positionals } = readArguments(args, { ...OPTIONS, ...flags });
  /** @type {import("./usage.mjs").Values<typeof OPTIONS>} */
  const values = given;
  const format = formatOf(values, ["table", "json"]);
  const options = optionsOf(declared, given);
  const wear = numbersOf(WEAR, given);
  const bodies = bodiesOf(values.bodies);
  const test = number("test", values.test, { least: 0, most: 1 });
  if (positionals.length === 0) {
    throw new UsageError("give at least one STEP file, or a folder or zip of them");
  }
  makeFolder(values.out);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = await collect(positionals);
  // What is named outright is tried whatever its name; of folders and zips only what is called like STEP.
  const parts = inputs.files.filter(({ path }) => isStep(path) || positionals.includes(path));
  const run = new Run(cad, engine, { options, bodies, wear, out: values.out, seed: options.seed ?? 1, test });
  for (const [at, part] of parts.entries()) {
    progress.show(`importing ${at + 1} of ${parts.length}: ${basename(part.path)}`);
    await run.take(part);
  }
  progress.clear();
  const problems = [...inputs.diagnostics, ...run.problems];
  if (run.made.length > 1 || test !== undefined) {
    const at = join(values.out, "manifest.json");
    const text = manifestOf(run.made, { engine: engine.version(), options: { ...options, bodies }, wear, test, failed: run.failed });
    const problem = problemOf(() => writeWhole(at, text));
    if (problem !== undefined) problems.push(unusable(at, problem));
  }
  tell(engine, problems);
  if (parts.length === 0) {
    warn(`fit4cad import: there was no STEP file (${CALLED}, also .gz); see fit4cad import --help.`);
  }
  const told = run.made.map((made) => ({ engine: engine.version(), ...made }));
  await print(format === "json" ? `${JSON.stringify(told, null, 2)}\n` : table(run.made));
  return run.made.length === 0 || problems.some(({ severity }) => severity === "error") ? 1 : 0;
}

/**
 * The options of the import among the values given.
 * @param {ReturnType<Cad["importOptions"]>} declared
 * @param {Given} given
 */
function optionsOf(declared, given) {
  const numbers = declared.flatMap(({ name, value }) => (value.kind === "number" ? [{ name, ...value }] : []));
  /** @type {Record<string, string | number | boolean>} */
  const options = numbersOf(numbers, given);
  for (const { name, value } of declared) {
    const word = given[name];
    if (typeof word === "string" && value.kind === "choice") options[name] = choice(name, word, value.words);
    else if (word === true) options[name] = true;
  }
  if (options.points !== undefined && options.spacing !== undefined) {
    throw new UsageError("give --points or --spacing, not both");
  }
  return /** @type {ImportOptions} */ (options);
}

/**
 * The numbers of bodies asked for, separated by commas; `undefined` for all.
 * @param {string | undefined} word
 */
function bodiesOf(word) {
  const expected = { least: 1, most: 4_294_967_295, whole: true };
  return word?.split(",").flatMap((each) => number("bodies", each.trim(), expected) ?? []);
}

/** One run of the command: what was made so far, and what went wrong. */
class Run {
  #cad;
  #engine;
  #how;
  /** @type {Set<string>} */
  #names = new Set();
  /** @type {Imported[]} */
  made = [];
  /** @type {{ source: string, reason: string }[]} */
  failed = [];
  /** @type {Diagnostic[]} */
  problems = [];

  /**
   * @param {Cad} cad
   * @param {Engine} engine
   * @param {{ options: ImportOptions, bodies: readonly number[] | undefined, wear: Wear, out: string, seed: number, test: number | undefined }} how
   */
  constructor(cad, engine, how) {
    this.#cad = cad;
    this.#engine = engine;
    this.#how = how;
  }

  /**
   * Makes a model of a file; what keeps it from being made is told, and the others go on.
   * @param {File} file
   */
  async take(file) {
    try {
      const bytes = file.read();
      this.#write(file.path, bytes, this.#model(bytes, this.#nameOf(file.path)));
    } catch (error) {
      const stopped = isStop(error);
      const reason = stopped ? "the reader of STEP ran out of memory, or failed, on this file" : error instanceof Error ? error.message : String(error);
      this.failed.push({ source: file.path, reason });
      this.problems.push(unusable(file.path, reason));
      // Its memory may be in any state.
      if (stopped) this.#cad = await loadCad();
    }
  }

  /**
   * @param {Uint8Array} bytes
   * @param {string} name
   * @returns {Made}
   */
  #model(bytes, name) {
    const { options, bodies, wear, seed } = this.#how;
    const part = this.#cad.Part.read(bytes);
    if (bodies !== undefined) part.keep(Uint32Array.from(bodies));
    const sampled = part.sample(name, options);
    const report = sampled.report();
    const files = sampled.files();
    sampled.free();
    part.free();
    const inputs = /** @type {[Role, string][]} */ (Object.entries(files)).map(([role, text]) => {
      const content = new TextEncoder().encode(text);
      return { path: role, role, size: content.length, read: () => content };
    });
    const clean = this.#engine.Model.read(name, inputs);
    const model = Object.keys(wear).length > 0 ? clean.degraded({ ...wear, seed }) : clean;
    const { points } = model.info();
    const types = Object.fromEntries(Object.entries(model.types()));
    const texts = model === clean ? files : model.write();
    if (model !== clean) model.free();
    clean.free();
    return { name, points, types, texts, report };
  }

  /**
   * @param {string} source
   * @param {Uint8Array} bytes
   * @param {Made} model
   */
  #write(source, bytes, { name, points, types, texts, report }) {
    const { out, seed, test } = this.#how;
    const folder = setOf(name, seed, test);
    /** @type {Record<string, string>} */
    const files = {};
    for (const [role, text] of /** @type {[Role, string][]} */ (Object.entries(texts))) {
      const path = join(folder, this.#engine.pathOf("beside", name, role));
      writeWhole(join(out, path), text);
      files[path] = sha256(text);
    }
    const primitives = Object.values(types).reduce((sum, count) => sum + count, 0);
    this.made.push({ model: name, source, sha256: sha256(bytes), points, primitives, types, files, report });
    for (const text of report.doubts) this.problems.push(unusable(source, text, "", "warning"));
  }

  /**
   * The name of the file, made one that no model before has.
   * @param {string} path
   */
  #nameOf(path) {
    const own = this.#engine.fileName(nameOfPart(path));
    let name = own;
    for (let at = 2; this.#names.has(name.toLowerCase()); at += 1) name = `${own}-${at}`;
    this.#names.add(name.toLowerCase());
    return name;
  }
}

/** @param {string | Uint8Array} content */
function sha256(content) {
  return createHash("sha256").update(content).digest("hex");
}

/** @param {readonly Imported[]} made */
function table(made) {
  if (made.length === 0) return "";
  const rows = made.map(({ model, points, primitives, report: { faces, lost, bodies, diagonal, spacing } }) => [
    model,
    String(points),
    String(primitives),
    String(bodies),
    String(faces.length),
    String(lost),
    diagonal.toPrecision(4),
    spacing.toPrecision(3),
  ]);
  return `${align([["model", "points", "primitives", "bodies", "faces", "left out", "diagonal, mm", "spacing, mm"], ...rows], 1)}\n`;
}
