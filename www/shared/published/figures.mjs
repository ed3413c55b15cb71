// @ts-check
// The published methods' figures, scored anew: what a new method is measured against.

import { PUBLISHED } from "../../generated/declared/published.js";

/** @typedef {import("../../generated/engine/engine.js").Measure} Measure */
/** @typedef {import("../../generated/engine/engine.js").Protocol} Protocol */
/** @typedef {import("./methods.mjs").PublishedMethod} PublishedMethod */

/** A test model, by what tells it from others of its name. @typedef {{ readonly name: string, readonly points: number, readonly truth: number }} TestModel */

/** @type {readonly TestModel[]} */
export const TEST_MODELS = Object.entries(PUBLISHED.models).map(([name, { points, truth }]) => ({ name, points, truth }));

/**
 * A published figure by a protocol, or as the paper prints it; null where there is none.
 * @param {string} model
 * @param {PublishedMethod} method
 * @param {Protocol | "paper"} by
 * @param {Measure} measure
 */
export function published(model, method, by, measure) {
  return PUBLISHED.models[model]?.[method][by][PUBLISHED.measures.indexOf(measure)] ?? null;
}
