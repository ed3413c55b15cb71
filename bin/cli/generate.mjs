// `fit4cad generate`.

import { join } from "node:path";
import { PARTS } from "../../www/generated/declared/parts.js";
import { SAMPLE_OPTIONS } from "../../www/generated/declared/sample-options.js";
import { loadEngine } from "./engine.mjs";
import { print } from "./terminal.mjs";
import { UsageError, numbersOf, readArguments } from "./usage.mjs";
import { writeWhole } from "./write.mjs";

/** @typedef {import("../engine/engine.js").SampleOptions} SampleOptions */
/** @typedef {import("../engine/engine.js").Role} Role */

const SAMPLING = /** @type {Record<keyof SampleOptions, { type: "string" }>} */ (
  Object.fromEntries(SAMPLE_OPTIONS.map(({ name }) => [name, { type: "string" }]))
);

const OPTIONS = /** @type {const} */ ({
  list: { type: "boolean", default: false },
  ...SAMPLING,
  imperfect: { type: "boolean", default: false },
  name: { type: "string" },
  out: { type: "string", default: "." },
});

/**
 * Makes a part's files, or lists the parts; gives the exit code.
 * @param {readonly string[]} args
 */
export async function generate(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  /** @type {SampleOptions} */
  const options = numbersOf(SAMPLE_OPTIONS, values);
  const engine = await loadEngine();
  if (values.list) {
    if (positionals.length > 0) {
      throw new UsageError("--list takes no part");
    }
    await list();
    return 0;
  }
  const [part, ...others] = positionals;
  if (part === undefined || others.length > 0) {
    throw new UsageError("give one part; --list shows them");
  }
  if (!PARTS.some(({ name }) => name === part)) {
    throw new UsageError(`there is no part "${part}"; --list shows what there is`);
  }
  const name = values.name ?? part;
  if (!/^[^/\\]+$/.test(name)) {
    throw new UsageError(`--name ${name}: expected a name of files, without folders`);
  }
  const files = make(engine, part, options, { name, imperfect: values.imperfect });
  const paths = Object.entries(files).map(([file, text]) => ({ path: join(values.out, file), text }));
  for (const { path, text } of paths) {
    writeWhole(path, text);
  }
  // Only now: a reader that has gone ends the command.
  await print(paths.map(({ path }) => `${path}\n`).join(""));
  return 0;
}

async function list() {
  const width = Math.max(...PARTS.map(({ name }) => name.length));
  await print(PARTS.map(({ name, description }) => `${name.padEnd(width)}  ${description}\n`).join(""));
}

/**
 * The files of a part by their names.
 * @param {import("./engine.mjs").Engine} engine
 * @param {string} part
 * @param {SampleOptions} options
 * @param {{ name: string, imperfect: boolean }} how
 * @returns {Record<string, string>}
 */
function make(engine, part, options, { name, imperfect }) {
  let model;
  try {
    model = engine.Model.generate(part, options);
  } catch (error) {
    // The engine says what is wrong with the options (a spacing of a millionth, say).
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
  try {
    const files = filesOf(engine, model, name);
    return imperfect ? { ...files, ...filesOf(engine, model, name, model.imperfect(options.seed ?? 1)) } : files;
  } finally {
    model.free();
  }
}

/**
 * The files of the truth, or of a method's submission, by path.
 * @param {import("./engine.mjs").Engine} engine
 * @param {import("../engine/engine.js").Model} model
 * @param {string} name
 * @param {string} [method]
 * @returns {Record<string, string>}
 */
function filesOf(engine, model, name, method) {
  const texts = /** @type {[Role, string][]} */ (Object.entries(model.write(method)));
  return Object.fromEntries(texts.map(([role, text]) => [engine.pathOf("beside", name, role, method), text]));
}
