// @ts-check
// The lines of a table of results, before a format writes them: which there are, what they hold, which figure is best.

import { MEASURES as DECLARED } from "../../generated/declared/measures.js";
import { meanOf, ofSeveral } from "./measures.mjs";

/** @typedef {import("./measures.mjs").MethodSummary} MethodSummary */
/** @typedef {import("./results.mjs").Row} Row */
/** @typedef {import("./wanted.mjs").Wanted} Wanted */

/** A figure as it is written, and whether it is to stand out. @typedef {{ readonly text: string, readonly best: boolean }} Cell */

/**
 * A method on a model, or its mean over several.
 * @typedef {object} Line
 * @property {string} model empty where it is a mean
 * @property {number} models how many it is of
 * @property {string} method
 * @property {readonly [number, number, number | null] | undefined} counts points, true and predicted primitives of one model
 * @property {readonly Cell[]} figures in the order of the measures wanted
 * @property {number | null} typeErrors null where it is not known
 */

/** From so many rows on a table takes more than a page. */
export const LONG = 40;

/**
 * The lines of single models, none where means alone are wanted, and those of the means: of every method where they
 * stand alone, else of those with several models.
 * @param {readonly Row[]} results
 * @param {readonly MethodSummary[]} summaries the engine's, of the same results
 * @param {Wanted} wanted
 * @param {(value: number | null) => string} write a figure
 * @returns {{ models: Line[], means: Line[] }}
 */
export function linesOf(results, summaries, { means, measures, bold }, write) {
  const isPublished = new Set(results.filter((result) => result.published).map(({ method }) => method));
  const of = means ? summaries : ofSeveral(summaries);
  /** @param {(number | null)[][]} rows of one model, or all the means */
  const cells = (rows) => (bold ? marked(rows, measures, write) : rows.map((row) => row.map((value) => ({ text: write(value), best: false }))));
  const figures = cells(of.map((summary) => measures.map((measure) => meanOf(summary, measure))));
  return {
    models: means
      ? []
      : blocksOf(results).flatMap((block) => {
          const own = cells(block.map(({ mean }) => measures.map((measure) => mean[measure] ?? null)));
          return block.map(({ model, method, points, truth, predicted, type_errors: typeErrors }, at) => ({
            ...{ model, models: 1, method, typeErrors, figures: own[at] ?? [] },
            counts: /** @type {const} */ ([points, truth, predicted]),
          }));
        }),
    means: of.map(({ method, models, typeErrors }, at) => ({
      ...{ model: "", models, method, counts: undefined, figures: figures[at] ?? [] },
      typeErrors: isPublished.has(method) ? null : typeErrors,
    })),
  };
}

/**
 * The results of each model that stand together.
 * @param {readonly Row[]} results
 */
function blocksOf(results) {
  /** @type {Row[][]} */
  const blocks = [];
  for (const result of results) {
    const last = blocks.at(-1);
    if (last?.[0]?.model === result.model) {
      last.push(result);
    } else {
      blocks.push([result]);
    }
  }
  return blocks;
}

/**
 * The figures of rows, the best of each column marked where there are several. Those that read alike are alike.
 * @param {readonly (readonly (number | null)[])[]} rows
 * @param {readonly import("./measures.mjs").Measure[]} measures
 * @param {(value: number | null) => string} write
 * @returns {Cell[][]}
 */
function marked(rows, measures, write) {
  const best = measures.map((measure, column) => {
    const values = rows.flatMap((row) => (row[column] === null || row[column] === undefined ? [] : [Number(write(row[column]))]));
    if (values.length < 2) {
      return NaN;
    }
    const better = DECLARED.find(({ key }) => key === measure)?.better;
    return values.reduce((one, other) => ((better === "higher" ? other > one : other < one) ? other : one));
  });
  return rows.map((row) =>
    row.map((value, column) => {
      const text = write(value);
      return { text, best: value !== null && Number(text) === best[column] };
    }),
  );
}

/**
 * With so many digits after the point; as a power of ten, `3.2e-5`, where those would all be noughts and the value is none.
 * @param {number | null} value
 * @param {number} digits
 */
export function figure(value, digits) {
  if (value === null) {
    return "n/a";
  }
  const text = value.toFixed(digits);
  return value !== 0 && Number(text) === 0 ? value.toExponential(1) : text;
}
