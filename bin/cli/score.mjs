// `fit4cad score`.

import { PROTOCOLS } from "../../www/generated/declared/protocols.js";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { withPublished } from "../../www/shared/formats/published-rows.mjs";
import { scoresOf } from "../../www/shared/formats/measures.mjs";
import { corrections } from "./corrections.mjs";
import { inOneLine, tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { evaluateBy } from "./evaluate.mjs";
import { FIELD_OPTIONS, fieldOf, scoreField } from "./field.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect } from "./inputs.mjs";
import { JOBS_OPTIONS, jobsOf } from "./jobs.mjs";
import { TABLE_OPTIONS, areColumns, refuseBesideField, wantedOf } from "./tables.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, readArguments } from "./usage.mjs";

const OPTIONS = /** @type {const} */ ({
  protocol: { type: "string", default: "definition" },
  ...FIELD_OPTIONS,
  ...TABLE_OPTIONS,
  ...FORMAT_OPTIONS,
  self: { type: "boolean", default: false },
  ...JOBS_OPTIONS,
  as: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
});

const NAMES = /** @type {(keyof typeof FORMATS)[]} */ (Object.keys(FORMATS));

/**
 * Scores what the arguments name; gives the exit code.
 * @param {readonly string[]} args
 */
export async function score(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const field = fieldOf(areColumns(values) ? { ...values, measures: undefined } : values);
  const format = formatOf(values, NAMES);
  if (field) {
    refuseBesideField(values);
  }
  const { wanted, published } = wantedOf(field ? { ...values, measures: undefined } : values, format);
  const overrides = corrections(values.as);
  const jobs = jobsOf(values);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = await collect(positionals);
  refuseUnknown(Object.keys(overrides), inputs.files);
  const how = {
    ...{ jobs, paths: positionals },
    overrides,
    self: values.self,
    progress: /** @param {string} text */ (text) => progress.show(`scoring ${text}`),
  };
  if (field) {
    return scoreField(engine, inputs, { ...how, field, format });
  }
  const protocol = choice("protocol", values.protocol, PROTOCOLS.map(({ name }) => name));
  const { results, diagnostics, engine: able } = await /** @type {typeof evaluateBy<import("./evaluate.mjs").Score>} */ (evaluateBy)(engine, inputs, { ...how, by: { protocol } });
  progress.clear();

  const problems = [...inputs.diagnostics, ...diagnostics];
  tell(able, format === "json" ? besides(able, problems, results) : problems);
  if (results.length === 0) {
    warn("fit4cad score: nothing could be scored. A score needs a cloud, its truth and a submission; see fit4cad score --help.");
  }
  const rows = published ? withPublished(results) : results;
  if (published && rows.length === results.length) {
    warn("fit4cad score: --published adds nothing: no model is one of the 35 test models, by name, points and true primitives.");
  }
  await print(FORMATS[format].write(rows, able.summarise(scoresOf(rows)), wanted));
  const failed = results.length === 0 || problems.some(({ severity }) => severity === "error");
  return failed ? 1 : 0;
}

/**
 * @param {readonly string[]} corrected paths
 * @param {readonly import("./inputs.mjs").File[]} files
 */
function refuseUnknown(corrected, files) {
  const known = new Set(files.map(({ path }) => path));
  for (const path of corrected.filter((candidate) => !known.has(candidate))) {
    throw new UsageError(`--as …:${path}: there is no such file among those given`);
  }
}

/**
 * JSON holds the diagnostics of its reports itself; only the others are left for the terminal.
 * @param {import("./engine.mjs").Engine} engine
 * @param {readonly import("./inputs.mjs").Diagnostic[]} problems
 * @param {readonly import("../../www/shared/formats/results.mjs").Result[]} results
 */
function besides(engine, problems, results) {
  const told = new Set(results.flatMap(({ diagnostics }) => inOneLine(engine, diagnostics)));
  const lines = inOneLine(engine, problems);
  return problems.filter((_, at) => !told.has(lines[at] ?? ""));
}
