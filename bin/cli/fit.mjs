// `fit4cad fit`.

import { SURFACE_TYPES } from "../../www/generated/declared/surface-types.js";
import { align } from "../../www/shared/formats/align.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { fitBy } from "./fitting.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect } from "./inputs.mjs";
import { JOBS_OPTIONS, jobsOf } from "./jobs.mjs";
import { METHODS, givenParameters, parameterOptions } from "./parameters.mjs";
import { recognise } from "./single.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, number, readArguments } from "./usage.mjs";
import { makeFolder } from "./write.mjs";

const OPTIONS = /** @type {const} */ ({
  method: { type: "string" },
  out: { type: "string" },
  ...FORMAT_OPTIONS,
  seed: { type: "string", default: "1" },
  single: { type: "boolean", default: false },
  ...JOBS_OPTIONS,
});

/**
 * Fits what the arguments name; gives the exit code.
 * @param {readonly string[]} args
 */
export async function fit(args) {
  const engine = await loadEngine();
  const options = parameterOptions();
  /** @type {Record<string, { type: "string" }>} */
  const flags = Object.fromEntries(options.map(({ flag }) => [flag, { type: "string" }]));
  const { values: given, positionals } = readArguments(args, { ...OPTIONS, ...flags });
  /** @type {import("./usage.mjs").Values<typeof OPTIONS>} */
  const values = given;
  if (values.single) {
    return single(engine, values, positionals);
  }
  if (values.method === undefined) {
    throw new UsageError(`choose a method: ${METHODS.map((name) => `--method ${name}`).join(" or ")}`);
  }
  const method = choice("method", values.method.toLowerCase(), METHODS);
  const format = formatOf(values, ["table", "json"]);
  const seed = number("seed", values.seed, { least: 0, most: 2 ** 32 - 1, whole: true });
  const parameters = givenParameters(options, method, given);
  const jobs = jobsOf(values);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const { out } = values;
  if (out !== undefined) {
    // Before anything is fitted that could then not be kept.
    makeFolder(out);
  }

  progress.show("looking for files");
  const inputs = await collect(positionals);
  const { models, diagnostics, engine: able } = await fitBy(engine, inputs, {
    ...{ method, parameters, seed, out, jobs, paths: positionals },
    progress: (text) => progress.show(`fitting ${text}`),
  });
  progress.clear();

  const problems = [...inputs.diagnostics, ...diagnostics];
  tell(able, problems);
  const unwritten = models.flatMap(({ error }) => error ?? []);
  for (const error of unwritten) {
    warn(`fit4cad fit: ${error}`);
  }
  if (models.length === 0) {
    warn("fit4cad fit: there was no cloud to fit; see fit4cad fit --help.");
  }
  const made = models.map((model) => ({ engine: engine.version(), ...model }));
  await print(format === "json" ? `${JSON.stringify(made, null, 2)}\n` : table(models));
  const failed = models.length === 0 || unwritten.length > 0 || problems.some(({ severity }) => severity === "error");
  return failed ? 1 : 0;
}

/**
 * Takes each cloud, or each of its segments, for one primitive; gives the exit code.
 * @param {import("./engine.mjs").Engine} engine
 * @param {import("./usage.mjs").Values<typeof OPTIONS>} values
 * @param {readonly string[]} paths
 */
function single(engine, values, paths) {
  if (values.method !== undefined) {
    throw new UsageError("--single takes no method: it tries every type of surface");
  }
  if (values.jobs !== undefined) {
    throw new UsageError("--single takes no --jobs: it is quick");
  }
  if (paths.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  return recognise(engine, paths, { out: values.out, json: formatOf(values, ["table", "json"]) === "json" });
}

/** @param {readonly import("./fitting.mjs").Fitted[]} models */
function table(models) {
  if (models.length === 0) {
    return "";
  }
  const types = SURFACE_TYPES.map(({ name }) => name);
  const head = ["model", "points", "seconds", "primitives", ...types.map((type) => type.toLowerCase()), "noise"];
  const rows = models.map(({ model, points, seconds, noise, primitives, types: counts }) => [
    model,
    String(points),
    seconds.toFixed(3),
    String(primitives.length),
    ...types.map((type) => String(counts[type])),
    `${noise.deviation.toExponential(1)} ${noise.source}`,
  ]);
  return `${align([head, ...rows], 1)}\n`;
}
