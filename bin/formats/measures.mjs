// @ts-check
// The measures in the order of the paper's tables.

/** @typedef {keyof import("../engine/engine.js").Measures} Measure */

/** @type {readonly Measure[]} */
export const MEASURES = ["DSC", "PPV", "TPR", "TNR", "NPV", "ACC", "MFE", "dHaus", "d1"];

/** @typedef {Pick<import("../engine/engine.js").Report, "method" | "mean">} Scored */

/**
 * Mean over the reports that have the measure, or null where none has.
 * @param {readonly Pick<Scored, "mean">[]} reports
 * @param {Measure} measure
 */
export function meanOf(reports, measure) {
  const values = reports.map(({ mean }) => mean[measure]).filter((value) => value !== null);
  return values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;
}

/**
 * The methods in the order in which they first appear.
 * @param {readonly Pick<Scored, "method">[]} reports
 */
export function methodsOf(reports) {
  return [...new Set(reports.map(({ method }) => method))];
}

/**
 * The reports of each method that has several: those of which a mean says something.
 * @template {Pick<Scored, "method">} R
 * @param {readonly R[]} reports
 */
export function byMethod(reports) {
  return methodsOf(reports)
    .map((method) => ({ method, own: reports.filter((report) => report.method === method) }))
    .filter(({ own }) => own.length > 1);
}
