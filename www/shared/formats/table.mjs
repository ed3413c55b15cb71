// @ts-check
// A table for the eye: one aligned row per model and method, then each method's mean.

import { align } from "./align.mjs";
import { linesOf } from "./lines.mjs";
import { USUAL } from "./wanted.mjs";

/** @typedef {import("./lines.mjs").Line} Line */

const DIGITS = 4;
/** Marks submissions whose surfaces the engine fitted. */
const FITTED = "†";
const NOTE = "came without surfaces: types, MFE, dHaus and distances of parameters are of those fitted here";

/**
 * @param {readonly import("./results.mjs").Row[]} results
 * @param {readonly import("./measures.mjs").MethodSummary[]} summaries the engine's, of the same results
 * @param {import("./wanted.mjs").Wanted} [wanted]
 */
export function table(results, summaries, wanted = USUAL) {
  if (results.length === 0) {
    return "";
  }
  // Fixed, as the eye goes down a column.
  const { models, means } = linesOf(results, summaries, wanted, (value) => (value === null ? "n/a" : value.toFixed(wanted.digits ?? DIGITS)));
  const { means: short, measures } = wanted;
  const head = short ? ["method", "models"] : ["model", "method", "points", "truth", "predicted"];
  const rows = [...models, ...means].map((line, at) => [
    ...(short ? [line.method, String(line.models)] : labels(line, results[at]?.surfacesFitted === true)),
    ...line.figures.map(({ text }) => text),
    line.typeErrors === null ? "" : String(line.typeErrors),
  ]);
  const note = !short && results.some(({ surfacesFitted }) => surfacesFitted) ? `${FITTED} ${NOTE}\n` : "";
  return `${align([[...head, ...measures, "type errors"], ...rows], short ? 1 : 2)}\n${note}`;
}

/**
 * @param {Line} line
 * @param {boolean} isFitted
 */
function labels({ model, models, method, counts }, isFitted) {
  return counts
    ? [model, isFitted ? `${method} ${FITTED}` : method, ...counts.map((count) => (count === null ? "" : String(count)))]
    : [`mean of ${models}`, method, "", "", ""];
}
