// A table for the eye: one aligned row per model and method, then each method's mean.

import { align } from "./align.mjs";
import { MEASURES, byMethod, meanOf } from "./measures.mjs";

const HEAD = ["model", "method", "points", "truth", "predicted", ...MEASURES, "type errors"];
const TEXT_COLUMNS = 2;

export function table(reports) {
  if (reports.length === 0) {
    return "";
  }
  const rows = reports.map((report) => [
    report.model,
    report.method,
    ...[report.points, report.truth, report.predicted].map(String),
    ...MEASURES.map((measure) => figure(report.mean[measure])),
    String(report.type_errors),
  ]);
  return `${align([HEAD, ...rows, ...meanRows(reports)], TEXT_COLUMNS)}\n`;
}

/** The mean over the models of each method that has several. */
function meanRows(reports) {
  return byMethod(reports).map(({ method, own }) => [
    `mean of ${own.length}`,
    method,
    ...["", "", ""],
    ...MEASURES.map((measure) => figure(meanOf(own, measure))),
    String(own.reduce((sum, { type_errors }) => sum + type_errors, 0)),
  ]);
}

function figure(value) {
  return value === null ? "n/a" : value.toFixed(4);
}
