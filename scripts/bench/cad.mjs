// Fitting clouds that were made of parts from CAD, spread in every way an import knows, clean and with noise.

import { loadCad } from "../../bin/cli/cad.mjs";
import { mean } from "../lib/bench.mjs";
import { stepParts } from "../lib/samples.mjs";
import { METHODS, fitted } from "./fit/fitted.mjs";

/** @typedef {import("./fit/fitted.mjs").Method} Method */
/** @typedef {import("../../bin/engine/engine.js").Model} Model */
/** @typedef {import("../../bin/engine/engine.js").Report} Report */
/** @typedef {Record<Method, { dsc: number, predictionDsc: number, seconds: number }>} Scores */

export const name = "cad";
export const about = "fitting clouds of STEP parts with HT and PG";

const POINTS = 20_000;
/** Faces of fewer points are there to be seen, not to be found. */
const COUNTED = 10;
/** Standard deviation of the noise in each coordinate, over the diagonal of the cloud. */
const NOISE = 0.001;

/** What is to be reached on clean clouds. */
const CASES = /** @type {const} */ ([
  { spread: "even", noise: 0, least: 0.96 },
  { spread: "random", noise: 0, least: 0.93 },
  { spread: "scan", noise: 0, least: undefined },
  { spread: "even", noise: NOISE, least: undefined },
  { spread: "random", noise: NOISE, least: undefined },
  { spread: "scan", noise: NOISE, least: undefined },
]);

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {import("../bench.mjs").Options} options
 */
export async function measure(bench, { models: most, quick }) {
  const parts = stepParts().slice(0, quick ? Math.min(most, 3) : most);
  if (parts.length === 0) {
    bench.note("skipped: the STEP files are not at hand");
    return;
  }
  const cad = await loadCad();
  const cases = CASES.map((each) => ({ ...each, scores: parts.map(({ bytes }) => scoresOf(clouded(bench.engine, cad, bytes, each))) }));
  bench.table({
    title: `Mean DSC on ${parts.length} parts from CAD, ${POINTS.toLocaleString("en")} points each`,
    note: `True faces of at least ${COUNTED} points count. Noise has a standard deviation of ${100 * NOISE} % of the diagonal in each coordinate.`,
    head: ["", ...METHODS.flatMap((method) => ["DSC", "prediction's side", "s"].map((column) => `${method.toUpperCase()} ${column}`))],
    rows: cases.map(({ scores, least, ...each }) => [
      word(each),
      ...METHODS.flatMap((method) => {
        const dsc = average(scores, method, "dsc");
        const text = dsc.toFixed(4);
        return [
          least === undefined ? text : { text, bar: `≥ ${least}`, met: dsc >= least },
          average(scores, method, "predictionDsc").toFixed(3),
          average(scores, method, "seconds").toFixed(2),
        ];
      }),
    ]),
  });
  bench.table({
    title: "DSC of each part",
    head: ["", ...cases.flatMap((each) => METHODS.map((method) => `${word(each)}, ${method.toUpperCase()}`))],
    rows: parts.map(({ path }, at) => [path, ...cases.flatMap(({ scores }) => METHODS.map((method) => (scores[at]?.[method].dsc ?? NaN).toFixed(3)))]),
  });
}

/** @param {{ spread: string, noise: number }} how */
function word({ spread, noise }) {
  return noise === 0 ? spread : `${spread}, noise`;
}

/**
 * @param {readonly Scores[]} scores
 * @param {Method} method
 * @param {"dsc" | "predictionDsc" | "seconds"} what
 */
function average(scores, method, what) {
  return mean(scores.map((of) => of[method][what]));
}

/**
 * The model of a part.
 * @param {import("../../bin/cli/engine.mjs").Engine} engine
 * @param {import("../../bin/cli/cad.mjs").Cad} cad
 * @param {Uint8Array} bytes
 * @param {{ spread: "even" | "random" | "scan", noise: number }} how
 */
function clouded(engine, cad, bytes, { spread, noise }) {
  const part = cad.Part.read(bytes);
  const sampled = part.sample("part", { points: POINTS, spread });
  const files = /** @type {[import("../../bin/engine/engine.js").Role, string][]} */ (Object.entries(sampled.files()));
  sampled.free();
  part.free();
  const inputs = files.map(([role, text]) => {
    const content = new TextEncoder().encode(text);
    return { path: role, role, size: content.length, read: () => content };
  });
  const clean = engine.Model.read("part", inputs);
  if (noise === 0) return clean;
  const model = clean.degraded({ noise, seed: 1 });
  clean.free();
  return model;
}

/**
 * What both methods reach on a model, which is freed.
 * @param {Model} model
 * @returns {Scores}
 */
function scoresOf(model) {
  const of = Object.fromEntries(
    METHODS.map((method) => {
      const { report, seconds } = fitted(model, method);
      return [method, { dsc: countedDsc(report), predictionDsc: report.hidden.prediction_dsc ?? 0, seconds }];
    }),
  );
  model.free();
  return /** @type {Scores} */ (of);
}

/**
 * Mean DSC of the true primitives that are counted.
 * @param {Report} report
 */
function countedDsc({ primitives }) {
  return mean(primitives.filter(({ size }) => size >= COUNTED).map(({ DSC }) => DSC ?? 0));
}
