// @ts-check
// A table for the eye: one aligned row per model and method, then each method's mean.

import { align } from "./align.mjs";
import { MEASURES, meanOf, ofSeveral } from "./measures.mjs";

/** @typedef {import("../../generated/engine/engine.js").Report & { surfacesFitted?: boolean }} Report */
/** @typedef {import("./measures.mjs").MethodSummary} MethodSummary */

const HEAD = ["model", "method", "points", "truth", "predicted", ...MEASURES, "type errors"];
const TEXT_COLUMNS = 2;

/** Marks submissions whose surfaces the engine fitted. */
const FITTED = "†";
const NOTE = "came without surfaces: types, MFE, dHaus and distances of parameters are of those fitted here";

/**
 * @param {readonly Report[]} reports
 * @param {readonly MethodSummary[]} summaries the engine's, of the same reports
 */
export function table(reports, summaries) {
  if (reports.length === 0) {
    return "";
  }
  const rows = reports.map((report) => [
    report.model,
    report.surfacesFitted ? `${report.method} ${FITTED}` : report.method,
    ...[report.points, report.truth, report.predicted].map(String),
    ...MEASURES.map((measure) => figure(report.mean[measure])),
    String(report.type_errors),
  ]);
  const note = reports.some(({ surfacesFitted }) => surfacesFitted) ? `${FITTED} ${NOTE}\n` : "";
  return `${align([HEAD, ...rows, ...meanRows(summaries)], TEXT_COLUMNS)}\n${note}`;
}

/**
 * The mean over the models of each method that has several.
 * @param {readonly MethodSummary[]} summaries
 */
function meanRows(summaries) {
  return ofSeveral(summaries).map((summary) => [
    `mean of ${summary.models}`,
    summary.method,
    ...["", "", ""],
    ...MEASURES.map((measure) => figure(meanOf(summary, measure))),
    String(summary.typeErrors),
  ]);
}

/** @param {number | null} value */
function figure(value) {
  return value === null ? "n/a" : value.toFixed(4);
}
