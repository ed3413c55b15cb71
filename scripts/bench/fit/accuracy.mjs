// How well and how fast: every measure of both methods, and the models that fall short.

import { METHODS, fitted, summary } from "./fitted.mjs";
import { evenly } from "./models.mjs";

/** @typedef {import("./fitted.mjs").Method} Method */
/** @typedef {import("./fitted.mjs").Fitted} Fitted */
/** @typedef {import("./fitted.mjs").Summary} Summary */
/** @typedef {Partial<Record<Method, number>>} Bars */
/**
 * @typedef {{ id: keyof Summary, label: string, show: (value: number) => string, least?: Bars, most?: Bars }} Figure
 * @param {number} value
 */
const share = (value) => value.toFixed(4);
/** @param {number} value */
const error = (value) => value.toExponential(1);
/** @param {number} value */
const seconds = (value) => value.toFixed(3);

/**
 * What is to be reached on the training set. Errors are over the diagonal of each primitive's points.
 * @type {readonly Figure[]}
 */
const FIGURES = [
  { id: "dsc", label: "mean DSC", show: share, least: { ht: 0.985, pg: 0.95 } },
  { id: "worst", label: "DSC of the worst model", show: share, least: { ht: 0.75, pg: 0.6 } },
  { id: "predictionDsc", label: "DSC from the prediction's side", show: share, least: { ht: 0.95, pg: 0.92 } },
  { id: "typeRight", label: "type right, share of matched", show: share, least: { ht: 0.99, pg: 0.97 } },
  { id: "mfe", label: "mean MFE", show: error, most: { ht: 0.0003 } },
  { id: "dHaus", label: "mean dHaus", show: error, most: { ht: 0.001 } },
  { id: "d1", label: "mean d1", show: error, most: { ht: 0.003 } },
  { id: "seconds", label: "seconds, median model", show: seconds, most: { ht: 0.3, pg: 0.25 } },
  { id: "slowest", label: "seconds, slowest model", show: seconds, most: { ht: 3, pg: 2 } },
];

/** Models with less are listed by name. */
const SHORT = 0.95;

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {import("./models.mjs").Known} known
 * @param {{ most: number }} how
 */
export function accuracy(bench, { real, list }, { most }) {
  const chosen = evenly(list, most);
  /** @type {Record<Method, (Fitted & { model: string })[]>} */
  const fits = { ht: [], pg: [] };
  for (const { name, open } of chosen) {
    const model = open();
    for (const method of METHODS) {
      fits[method].push({ model: name, ...fitted(model, method) });
    }
    model.free();
  }
  const summaries = { ht: summary(fits.ht), pg: summary(fits.pg) };
  bench.table({
    title: `${chosen.length} ${real ? "training models" : "generated parts"}`,
    note: real ? "In brackets what is to be reached." : undefined,
    head: ["", "HT", "PG"],
    rows: FIGURES.map((figure) => [
      figure.label,
      ...METHODS.map((method) => judged(figure, method, summaries[method][figure.id], real)),
    ]),
  });
  for (const method of METHODS) {
    short(bench, method, fits[method]);
  }
}

/**
 * @param {Figure} figure
 * @param {Method} method
 * @param {number} value
 * @param {boolean} real
 */
function judged({ show, least, most }, method, value, real) {
  const text = show(value);
  const [bar, sign] = least ? [least[method], "≥"] : [most?.[method], "≤"];
  if (!real || bar === undefined) {
    return text;
  }
  return { text, bar: `${sign} ${bar}`, met: least ? value >= bar : value <= bar };
}

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {Method} method
 * @param {readonly (Fitted & { model: string })[]} fits
 */
function short(bench, method, fits) {
  const below = fits
    .filter(({ report }) => (report.mean.DSC ?? 0) < SHORT)
    .sort((a, b) => (a.report.mean.DSC ?? 0) - (b.report.mean.DSC ?? 0));
  const title = `Models under a DSC of ${SHORT}: ${method.toUpperCase()}`;
  if (below.length === 0) {
    bench.note(`${title}: none`);
    return;
  }
  bench.table({
    title,
    head: ["model", "DSC", "prediction's side", "true", "found", "missed", "merged", "spurious", "type errors", "seconds"],
    rows: below.map(({ model, report, seconds }) => [
      model,
      (report.mean.DSC ?? 0).toFixed(4),
      (report.hidden.prediction_dsc ?? 0).toFixed(4),
      ...[report.truth, report.predicted].map(String),
      ...[report.hidden.missed, report.hidden.merged, report.hidden.spurious].map(({ length }) => String(length)),
      String(report.type_errors),
      seconds.toFixed(3),
    ]),
  });
}
