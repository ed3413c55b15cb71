// What noise, outliers and missing data cost. The noise level is not given to the fitters.

import { METHODS, fitted, summary } from "./fitted.mjs";
import { evenly } from "./models.mjs";

/**
 * Lengths over the diagonal of the cloud; the bar is for HT on the training set.
 * @type {readonly { label: string, options: Omit<import("../../../bin/engine/engine.js").SampleOptions, "spacing">, least?: number }[]}
 */
const CASES = [
  { label: "as they are", options: {} },
  { label: "noise of 0.05 %", options: { noise: 0.0005 }, least: 0.92 },
  { label: "noise of 0.1 %", options: { noise: 0.001 }, least: 0.88 },
  { label: "noise of 0.2 %", options: { noise: 0.002 }, least: 0.84 },
  { label: "noise of 0.5 %", options: { noise: 0.005 }, least: 0.72 },
  { label: "5 % outliers", options: { outliers: 0.05 } },
  { label: "20 % cut away", options: { missing: 0.2 } },
];

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {import("./models.mjs").Known} known
 * @param {{ most: number }} how
 */
export function degradation(bench, { real, list }, { most }) {
  const chosen = evenly(list, most);
  const fits = CASES.map((each) => ({ ...each, ...noFits() }));
  for (const { open } of chosen) {
    const clean = open();
    for (const each of fits) {
      const model = clean.degraded(each.options);
      for (const method of METHODS) {
        each[method].push(fitted(model, method));
      }
      model.free();
    }
    clean.free();
  }
  const columns = ["DSC", "prediction's side", "type right", "median s", "slowest s"];
  bench.table({
    title: `Degraded clouds: ${chosen.length} ${real ? "training models" : "generated parts"}`,
    note: "Normal noise in each coordinate, its standard deviation in shares of the cloud's diagonal.",
    head: ["", ...METHODS.flatMap((method) => columns.map((column) => `${method.toUpperCase()} ${column}`))],
    rows: fits.map(({ label, least, ...of }) => [
      label,
      ...METHODS.flatMap((method) => figures(summary(of[method]), method === "ht" && real ? least : undefined)),
    ]),
  });
}

/** @returns {Record<import("./fitted.mjs").Method, import("./fitted.mjs").Fitted[]>} */
function noFits() {
  return { ht: [], pg: [] };
}

/**
 * @param {import("./fitted.mjs").Summary} summary
 * @param {number | undefined} least
 */
function figures({ dsc, predictionDsc, typeRight, seconds, slowest }, least) {
  const text = dsc.toFixed(3);
  return [
    least === undefined ? text : { text, bar: `≥ ${least}`, met: dsc >= least },
    predictionDsc.toFixed(3),
    typeRight.toFixed(3),
    seconds.toFixed(2),
    slowest.toFixed(2),
  ];
}
