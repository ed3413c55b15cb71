// @ts-check
// What the field reports, summed up: over models, method against method, and by strata of primitives.
// What is computed is asked of the engine; here it is only said of what.

import { OTHER_TYPE } from "../../generated/declared/other-type.js";
import { STRATA } from "../../generated/declared/strata.js";

/**
 * @typedef {import("../../generated/engine/engine.js").FieldReport} FieldReport
 * @typedef {import("../../generated/engine/engine.js").By} By
 * @typedef {import("../../generated/engine/engine.js").Condition} Condition
 * @typedef {import("../../generated/engine/engine.js").Segment} Segment
 * @typedef {import("../../generated/engine/engine.js").Figure} Figure
 * @typedef {Pick<import("../../generated/engine/engine.js").FigureInfo, "key" | "title" | "better">} Wanted
 * @typedef {Pick<typeof import("../../generated/engine/engine.js"), "distribution" | "compareFigures" | "rates">} Counting what is asked of the engine
 * @typedef {FieldReport & { conditions?: readonly Condition[], segments?: readonly Segment[] }} Reported with what was asked for beside the figures
 */

/** What primitives can be told apart by. */
export const BY = STRATA.map(({ name }) => name);

/**
 * What is to be known about strata.
 * @param {By} by
 */
export function infoOf(by) {
  const info = STRATA.find(({ name }) => name === by);
  if (!info) {
    throw new RangeError(`no strata by ${by}`);
  }
  return info;
}

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
 * The stratum of each true primitive of a report, in their order.
 * @param {Reported} report
 * @param {By} by
 */
function strataIn({ primitives, conditions }, by) {
  const ofModel = conditions?.find((condition) => condition.by === by)?.stratum ?? infoOf(by).strata.at(-1) ?? "";
  return primitives.map(({ stratum, type }) => (by === "size" ? stratum : by === "type" ? (type ?? OTHER_TYPE) : ofModel));
}

/**
 * True primitives by stratum: how many of how many models, how well they coincide with their partner, and how
 * many are hits.
 * @param {Counting} engine
 * @param {readonly Reported[]} results
 * @param {By} by
 */
export function strataOf(engine, results, by) {
  return byMethod(results).flatMap(([method, own]) => {
    const rows = own.flatMap((report) => {
      const strata = strataIn(report, by);
      return report.primitives.map(({ iou }, at) => ({ iou, model: report.model, stratum: strata[at] }));
    });
    return infoOf(by).strata.flatMap((stratum) => {
      const inside = rows.filter((row) => row.stratum === stratum);
      if (inside.length === 0) {
        return [];
      }
      return {
        method,
        stratum,
        models: new Set(inside.map(({ model }) => model)).size,
        primitives: inside.length,
        iou: engine.distribution(Float64Array.from(inside, ({ iou }) => iou)) ?? null,
        found: engine.distribution(Float64Array.from(inside, ({ iou }) => (iou > 0.5 ? 1 : 0)))?.mean ?? null,
      };
    });
  });
}

/**
 * The figures of the models of each stratum, method by method: for what is a condition of a model.
 * @param {Counting} engine
 * @param {readonly Reported[]} results
 * @param {By} by
 * @param {readonly Wanted[]} figures
 */
export function spreadsByCondition(engine, results, by, figures) {
  if (!infoOf(by).isCondition) {
    return [];
  }
  return infoOf(by).strata.flatMap((stratum) => {
    const inside = results.filter(({ conditions }) => conditions?.some((each) => each.by === by && each.stratum === stratum));
    return spreadsOf(engine, inside, figures).map((spread) => ({ stratum, ...spread }));
  });
}

/** Stands for all strata together. */
export const ALL_SEGMENTS = "all";

/**
 * SHREC 2022's tables: how well the types of segments are told, and how well they are fitted; of all, and
 * by stratum where one is asked for.
 * @param {Counting} engine
 * @param {readonly Reported[]} results
 * @param {By} [by]
 */
export function recognitionOf(engine, results, by) {
  return byMethod(results).flatMap(([method, own]) => {
    const rows = own.flatMap((report) => {
      const strata = by ? strataIn(report, by) : [];
      return (report.segments ?? []).map((segment, at) => ({ segment, stratum: strata[at] ?? ALL_SEGMENTS }));
    });
    return (by ? infoOf(by).strata : [ALL_SEGMENTS]).flatMap((stratum) => {
      const inside = rows.filter((row) => row.stratum === stratum).map(({ segment }) => segment);
      if (inside.length === 0) {
        return [];
      }
      /** @param {(segment: Segment) => number | null} of */
      const spread = (of) => engine.distribution(Float64Array.from(inside, (segment) => of(segment) ?? NaN)) ?? null;
      return {
        method,
        stratum,
        segments: inside.length,
        rates: engine.rates(inside.map(({ type, answer }) => ({ type, answer }))),
        mfe: spread(({ mfe }) => mfe),
        hausdorff: spread(({ hausdorff }) => hausdorff),
        parameters: spread(({ parameters }) => parameters),
      };
    });
  });
}

/**
 * The place of each method by a figure, from 1, those equal to the digits shown sharing one; absent for those
 * without the figure.
 * @param {ReturnType<typeof spreadsOf>} spreads
 * @param {Pick<import("../../generated/engine/engine.js").FigureInfo, "key" | "better" | "decimals">} figure
 * @returns {ReadonlyMap<string, number>}
 */
export function ranksOf(spreads, { key, better, decimals }) {
  const values = spreads.flatMap(({ method, figures }) => {
    const mean = figures.find(({ figure }) => figure === key)?.spread?.mean;
    return mean === undefined ? [] : [{ method, mean: Number(mean.toFixed(decimals)) }];
  });
  /** @param {number} one @param {number} other */
  const isBetter = (one, other) => (better === "higher" ? one > other : one < other);
  return new Map(values.map(({ method, mean }) => [method, 1 + values.filter((each) => isBetter(each.mean, mean)).length]));
}
