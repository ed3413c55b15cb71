// @ts-check
// What the field reports, summed up: over models, method against method, and by strata of primitives.
// What is computed is asked of the engine; here it is only said of what.

import { OTHER_TYPE } from "../../generated/declared/other-type.js";
import { SIZE_STRATA } from "../../generated/declared/size-strata.js";
import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";

/**
 * @typedef {import("../../generated/engine/engine.js").FieldReport} FieldReport
 * @typedef {import("../../generated/engine/engine.js").Figure} Figure
 * @typedef {Pick<import("../../generated/engine/engine.js").FigureInfo, "key" | "title" | "better">} Wanted
 * @typedef {Pick<typeof import("../../generated/engine/engine.js"), "distribution" | "compareFigures">} Counting what is asked of the engine
 * @typedef {(typeof STRATA)[number]} Stratum
 */

/** What strata are called, in the order to show them. */
const ORDER = { size: SIZE_STRATA, type: [...SURFACE_TYPES.map(({ name }) => name), OTHER_TYPE] };

/** What primitives can be told apart by. */
export const STRATA = /** @type {const} */ (["size", "type"]);

/**
 * The methods in the order in which they first appear, each with its reports.
 * @template {{ method: string }} R
 * @param {readonly R[]} results
 */
function byMethod(results) {
  /** @type {Map<string, R[]>} */
  const methods = new Map();
  for (const result of results) {
    methods.set(result.method, [...(methods.get(result.method) ?? []), result]);
  }
  return [...methods];
}

/**
 * The values of a figure as the engine takes them.
 * @param {readonly FieldReport[]} results
 * @param {Figure} key
 */
function valuesOf(results, key) {
  return Float64Array.from(results, ({ figures }) => figures[key] ?? NaN);
}

/**
 * Over several models: the spread of each figure, method by method.
 * @param {Counting} engine
 * @param {readonly FieldReport[]} results
 * @param {readonly Wanted[]} figures
 */
export function spreadsOf(engine, results, figures) {
  return byMethod(results).map(([method, own]) => ({
    method,
    models: own.length,
    figures: figures.map(({ key }) => ({ figure: key, spread: engine.distribution(valuesOf(own, key)) ?? null })),
  }));
}

/**
 * Each method against each that comes after it, over the models that both have.
 * @param {Counting} engine
 * @param {readonly FieldReport[]} results
 * @param {readonly Wanted[]} figures
 */
export function comparisonsOf(engine, results, figures) {
  const methods = byMethod(results);
  return methods.flatMap(([one, own], at) =>
    methods.slice(at + 1).flatMap(([other, theirs]) => {
      const partners = new Map(theirs.map((result) => [result.model, result]));
      const pairs = own.flatMap((result) => {
        const partner = partners.get(result.model);
        return partner ? [[result, partner]] : [];
      });
      const left = pairs.flatMap(([result]) => (result ? [result] : []));
      const right = pairs.flatMap(([, partner]) => (partner ? [partner] : []));
      return figures.map(({ key, title, better }) => ({
        figure: key,
        title,
        method: one,
        against: other,
        ...engine.compareFigures(valuesOf(left, key), valuesOf(right, key), better === "higher"),
      }));
    }),
  );
}

/**
 * True primitives by stratum: how many, how well they coincide with their partner, and how many are
 * hits.
 * @param {Counting} engine
 * @param {readonly FieldReport[]} results
 * @param {Stratum} by
 */
export function strataOf(engine, results, by) {
  return byMethod(results).flatMap(([method, own]) => {
    const rows = own.flatMap(({ primitives }) => primitives);
    const strata = ORDER[by].map((stratum) => ({
      stratum,
      ious: rows.filter((row) => (by === "size" ? row.stratum : (row.type ?? OTHER_TYPE)) === stratum).map(({ iou }) => iou),
    }));
    return strata.filter(({ ious }) => ious.length > 0).map(({ stratum, ious }) => ({
      method,
      stratum,
      primitives: ious.length,
      iou: engine.distribution(Float64Array.from(ious)) ?? null,
      found: engine.distribution(Float64Array.from(ious, (iou) => (iou > 0.5 ? 1 : 0)))?.mean ?? null,
    }));
  });
}
