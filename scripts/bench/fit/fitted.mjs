// One fit, and what it is worth.

import { FITTERS } from "../../../www/generated/declared/fitters.js";
import { mean, median, timed } from "../../lib/bench.mjs";

/** @typedef {import("../../../bin/engine/engine.js").FitMethod} Method */
/** @typedef {import("../../../bin/engine/engine.js").Report} Report */
/** @typedef {ReturnType<typeof fitted>} Fitted */
/** @typedef {ReturnType<typeof summary>} Summary */

export const METHODS = FITTERS.map(({ name }) => name);

/**
 * Fits and scores by definition: `{ seconds, report, name }`.
 * @param {import("../../../bin/engine/engine.js").Model} model
 * @param {Method} method
 */
export function fitted(model, method) {
  const { value: name, seconds } = timed(() => model.fit(method, {}, 1, () => {}));
  return { name, seconds, report: model.score(name, "definition") };
}

/**
 * The figures of many fits of one method; missing ones are NaN.
 * @param {readonly Pick<Fitted, "report" | "seconds">[]} fits
 */
export function summary(fits) {
  const reports = fits.map(({ report }) => report);
  const seconds = fits.map((fit) => fit.seconds);
  const dsc = reports.map((report) => report.mean.DSC ?? 0);
  const { right, matched } = types(reports);
  return {
    dsc: mean(dsc),
    worst: Math.min(...dsc),
    predictionDsc: meanOfKnown(reports.map(({ hidden }) => hidden.prediction_dsc)),
    typeRight: right / matched,
    mfe: meanOfKnown(reports.map((report) => report.mean.MFE)),
    dHaus: meanOfKnown(reports.map((report) => report.mean.dHaus)),
    d1: meanOfKnown(reports.map((report) => report.mean.d1)),
    seconds: median(seconds),
    slowest: Math.max(...seconds),
  };
}

/**
 * How many true primitives of a known type have a match, and how many of these matches are of that type.
 * @param {readonly Report[]} reports
 */
function types(reports) {
  let [right, matched] = [0, 0];
  for (const { primitives, predictions } of reports) {
    const typeOf = new Map(predictions.map(({ prediction, type }) => [prediction, type]));
    for (const { type, match } of primitives) {
      if (type !== null && match !== null) {
        matched += 1;
        right += typeOf.get(match) === type ? 1 : 0;
      }
    }
  }
  return { right, matched };
}

/** @param {readonly (number | null)[]} values */
function meanOfKnown(values) {
  return mean(values.filter((value) => value !== null));
}
