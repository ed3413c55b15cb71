// From a list of files to reports, one model at a time.

import { fieldReportOf } from "./field-report.mjs";
import { Hashes } from "./hashing.mjs";
import { shareOut } from "./jobs.mjs";
import { unusable } from "./inputs.mjs";
import { eachModel, isOfTruth, unplacedAmong } from "./models.mjs";

/** @typedef {import("./engine.mjs").Engine} Engine */
/** @typedef {import("./inputs.mjs").File} File */
/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */
/** @typedef {import("../engine/engine.js").Model} Model */
/** @typedef {import("../engine/engine.js").Protocol} Protocol */
/** @typedef {import("../../www/shared/formats/results.mjs").HashedFile} HashedFile */

/**
 * @template {{ method: string }} R
 * @typedef {object} Request
 * @property {(model: Model, method: string | undefined) => R} report what is asked of a model about a
 *   method, or about the truth itself
 * @property {Record<string, import("../engine/engine.js").Override>} [overrides] by path, what is
 *   known better about a file than its name tells
 * @property {boolean} [self] scores the truth against itself instead of each submission
 * @property {(text: string) => void} [progress]
 * @property {(index: number) => boolean} [claim] which models are done here
 */

/**
 * The same as it can be said to another thread: by a protocol of the benchmark, or what the field reports.
 * @typedef {{ by: { protocol: Protocol } | import("./field-report.mjs").FieldAsked, overrides: Record<string, import("../engine/engine.js").Override>, self: boolean }} Asked
 */

/**
 * What became of the model at a place: reports with the engine's version and files, and what is to be told.
 * @template R
 * @typedef {{ index: number, results: (R & { engine: string, files: HashedFile[] })[], diagnostics: Diagnostic[] }} Evaluated
 */

/** @typedef {ReturnType<ReturnType<typeof scoredBy>>} Score */
/** @typedef {import("./field-report.mjs").FieldReport} FieldReport */

/**
 * @param {Asked["by"]} by
 * @returns {(model: Model, method: string | undefined) => Score | FieldReport}
 */
export function reportOf(by) {
  return "scale" in by ? fieldReportOf(by) : scoredBy(by.protocol);
}

/**
 * Reports on every submission by so many threads, as `evaluate` does by one.
 * @template {Score | FieldReport} R of what is asked by
 * @param {Engine} engine
 * @param {{ files: readonly File[] }} inputs
 * @param {Asked & { jobs: number, paths: readonly string[], progress: (text: string) => void }} how
 */
export async function evaluateBy(engine, { files }, { jobs, paths, progress, ...request }) {
  if (jobs <= 1) {
    const report = /** @type {(model: Model, method: string | undefined) => R} */ (reportOf(request.by));
    return evaluate(engine, files, { ...request, progress, report });
  }
  const answers = await shareOut({ task: "score", request }, { jobs, paths, files: files.length, progress });
  const shares = /** @type {{ models: Evaluated<R>[], stops: import("./models.mjs").Stop[] }[]} */ (answers);
  const all = { models: shares.flatMap(({ models }) => models), stops: shares.flatMap(({ stops }) => stops) };
  return together(all, unplacedAmong(engine, files, request.overrides), engine);
}

/**
 * What is asked of a model for a score.
 * @param {Protocol} protocol
 * @returns {(model: Model, method: string | undefined) => import("../engine/engine.js").Report & { surfacesFitted?: boolean }}
 */
export function scoredBy(protocol) {
  return (model, method) => {
    const report = model.score(method, protocol);
    return method !== undefined && model.info().fitted.includes(method) ? { ...report, surfacesFitted: true } : report;
  };
}

/**
 * Reports on every submission among the files. Gives the reports in the engine's order, by model
 * number, name and method, each with the engine's version and the files it was made of.
 * @template {{ method: string }} R
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Request<R>} request
 */
export async function evaluate(engine, files, request) {
  const { models, stops, unplaced, engine: able } = await evaluateEach(engine, files, request);
  return together({ models, stops }, unplaced, able);
}

/**
 * @template R
 * @param {{ models: Evaluated<R>[], stops: import("./models.mjs").Stop[] }} all in any order
 * @param {Diagnostic[]} unplaced
 * @param {Engine} engine
 */
function together({ models, stops }, unplaced, engine) {
  models.sort((a, b) => a.index - b.index);
  stops.sort((a, b) => a.index - b.index);
  const told = [...unplaced, ...stops.map(({ diagnostic }) => diagnostic)];
  return { results: models.flatMap(({ results }) => results), diagnostics: [...told, ...models.flatMap(({ diagnostics }) => diagnostics)], engine };
}

/**
 * The same, model by model.
 * @template {{ method: string }} R
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Request<R>} request
 */
export async function evaluateEach(engine, files, { report, overrides = {}, self = false, progress = () => {}, claim = () => true }) {
  /** @type {Evaluated<R>[]} */
  const models = [];
  const version = engine.version();
  const hashes = new Hashes();
  const hashing = files.map((file) => hashes.heard(file));
  const wanted = self ? isOfTruth : () => true;
  const read = await eachModel(engine, hashing, { wanted, overrides, progress, claim }, (model, inputs, _place, _able, index) => {
    const { reports, diagnostics } = scoreModel(model, { report, self });
    const listed = inputs.flatMap(({ path, role, method }) => {
      const sha256 = hashes.of(path);
      return sha256 === undefined ? [] : [listedFile({ path, role, method }, sha256)];
    });
    const results = reports.map((each) => ({
      ...each,
      engine: version,
      files: listed.filter(({ method }) => method === undefined || method === each.method),
    }));
    models.push({ index, results, diagnostics });
    hashes.clear();
  });
  return { models, ...read };
}

/**
 * @param {import("../engine/engine.js").PlacedFile} file
 * @param {string} sha256
 * @returns {HashedFile}
 */
function listedFile({ path, role, method }, sha256) {
  return { path, role, ...(method === undefined ? {} : { method }), sha256 };
}

/**
 * @template R
 * @param {Model} model
 * @param {{ report: (model: Model, method: string | undefined) => R, self: boolean }} how
 * @returns {{ reports: R[], diagnostics: Diagnostic[] }}
 */
function scoreModel(model, { report, self }) {
  const { name, hasTruth, methods, diagnostics } = model.info();
  /** @param {string} message @param {string} hint @param {Diagnostic["severity"]} [severity] */
  const unscored = (message, hint, severity) => ({
    reports: [],
    diagnostics: [...diagnostics, unusable(name, message, hint, severity)],
  });
  if (!hasTruth) {
    const hint = `Give ${name}_primitives.txt of the benchmark as well`;
    return unscored("there is no ground truth to score against", hint);
  }
  if (!self && methods.length === 0) {
    const hint =
      "Give a method's files in a folder named after it (pointCloud_primitives_MINE), " +
      "or score the truth against itself with --self";
    return unscored("there is no submission to score", hint, "note");
  }
  // No method: the truth itself.
  const submissions = self ? [undefined] : methods;
  return { reports: submissions.map((method) => report(model, method)), diagnostics };
}
