// @ts-check
// The measures in the order of the paper's tables.

import { MEASURES as DECLARED } from "../../generated/declared/measures.js";

/** @typedef {import("../../generated/engine/engine.js").Measure} Measure */

/** @type {readonly Measure[]} */
export const MEASURES = DECLARED.map(({ key }) => key);

/** @typedef {import("../../generated/engine/engine.js").MethodSummary} MethodSummary */

/** What a summary takes of a report. @typedef {{ method: string, mean: Readonly<Partial<Record<Measure, number | null>>>, type_errors: number | null }} Scored */

/**
 * The figures of many reports as the engine takes them: one call sums all of them up.
 * @param {readonly Scored[]} reports
 * @returns {import("../../generated/engine/engine.js").Scores}
 */
export function scoresOf(reports) {
  const methods = [...new Set(reports.map(({ method }) => method))];
  const places = new Map(methods.map((method, place) => [method, place]));
  return {
    methods,
    method: Uint32Array.from(reports, ({ method }) => places.get(method) ?? 0),
    measures: rowsOf(reports.map(({ mean }) => (measure) => mean[measure])),
    typeErrors: Uint32Array.from(reports, ({ type_errors }) => type_errors ?? 0),
  };
}

/**
 * Measures row after row in the order of the list, NaN where one cannot be had, as the engine takes them.
 * @param {readonly ((measure: Measure) => number | null | undefined)[]} rows
 */
export function rowsOf(rows) {
  const flat = new Float64Array(rows.length * MEASURES.length);
  rows.forEach((row, at) => {
    MEASURES.forEach((measure, column) => (flat[at * MEASURES.length + column] = row(measure) ?? NaN));
  });
  return flat;
}

/**
 * The methods with several models: those of which a mean says something.
 * @param {readonly MethodSummary[]} summaries
 */
export function ofSeveral(summaries) {
  return summaries.filter(({ models }) => models > 1);
}

/**
 * A method's mean of a measure; null where no model has it.
 * @param {MethodSummary} summary
 * @param {Measure} measure
 */
export function meanOf({ over }, measure) {
  return over[measure]?.mean ?? null;
}
