// @ts-check
// What a set of models comes to. Every figure is the engine's; here it is only said of what.

import { FIGURES } from "../../generated/declared/figures.js";
import { MEASURES } from "../formats/measures.mjs";
import { strataOf } from "../formats/field-sums.mjs";
import { BY } from "./scores.mjs";

/**
 * @typedef {import("./scores.mjs").Entry} Entry
 * @typedef {import("./scores.mjs").Summary} Summary
 * @typedef {import("../formats/field-sums.mjs").Counting} Counting
 * @typedef {import("../../generated/engine/engine.js").FieldReport} FieldReport
 */

/**
 * Sums up the models of a set, given with what the field reports of the same.
 * @param {Counting} engine
 * @param {readonly Entry[]} entries
 * @param {readonly FieldReport[]} reports
 * @returns {Summary}
 */
export function summaryOf(engine, entries, reports) {
  /** @param {(entry: Entry) => number | null | undefined} of */
  const spread = (of) => engine.distribution(Float64Array.from(entries, (entry) => of(entry) ?? NaN)) ?? null;
  /**
   * @template {string} Key
   * @param {readonly Key[]} keys
   * @param {(entry: Entry, key: Key) => number | null | undefined} of
   */
  const spreads = (keys, of) => /** @type {Record<Key, ReturnType<typeof spread>>} */ (
    Object.fromEntries(keys.map((key) => [key, spread((entry) => of(entry, key))]))
  );
  const by = BY.map((protocol) => /** @type {const} */ ([protocol, spreads(MEASURES, (entry, measure) => entry[protocol][measure])]));
  const figures = spreads(FIGURES.map(({ key }) => key), (entry, figure) => entry.figures[figure]);
  /** @param {"type" | "size"} which */
  const strata = (which) => strataOf(engine, reports, which).map(({ stratum, primitives, iou, found }) => ({ stratum, primitives, iou, found }));
  return {
    models: entries.length,
    typeErrors: entries.reduce((sum, { typeErrors }) => sum + typeErrors, 0),
    surfacesFitted: entries.filter(({ surfacesFitted }) => surfacesFitted).length,
    seconds: spread(({ seconds }) => seconds),
    types: strata("type"),
    sizes: strata("size"),
    .../** @type {import("./scores.mjs").Figures<any>} */ (Object.fromEntries([...by, ["figures", figures]])),
  };
}
