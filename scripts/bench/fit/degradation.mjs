// What noise, outliers and missing data cost. The noise level is not given to the fitters.

import { METHODS, fitted, summary } from "./fitted.mjs";
import { evenly } from "./models.mjs";

/** Lengths over the diagonal of the cloud; the bar is for HT on the training set. */
const CASES = [
  { label: "as they are", options: {} },
  { label: "noise of 0.05 %", options: { noise: 0.0005 }, least: 0.92 },
  { label: "noise of 0.1 %", options: { noise: 0.001 }, least: 0.85 },
  { label: "noise of 0.2 %", options: { noise: 0.002 }, least: 0.75 },
  { label: "noise of 0.5 %", options: { noise: 0.005 } },
  { label: "5 % outliers", options: { outliers: 0.05 } },
  { label: "20 % cut away", options: { missing: 0.2 } },
];

export function degradation(bench, { real, list }, { most }) {
  const chosen = evenly(list, most);
  const fits = CASES.map(() => ({ ht: [], pg: [] }));
  for (const { open } of chosen) {
    const clean = open();
    CASES.forEach(({ options }, at) => {
      const model = clean.degraded(options);
      for (const method of METHODS) {
        fits[at][method].push(fitted(model, method));
      }
      model.free();
    });
    clean.free();
  }
  const columns = ["DSC", "prediction's side", "type right", "median s", "slowest s"];
  bench.table({
    title: `Degraded clouds: ${chosen.length} ${real ? "training models" : "generated parts"}`,
    note: "Normal noise in each coordinate, its standard deviation in shares of the cloud's diagonal.",
    head: ["", ...METHODS.flatMap((method) => columns.map((column) => `${method.toUpperCase()} ${column}`))],
    rows: CASES.map(({ label, least }, at) => [
      label,
      ...METHODS.flatMap((method) => figures(summary(fits[at][method]), method === "ht" && real ? least : undefined)),
    ]),
  });
}

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
