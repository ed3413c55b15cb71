// @ts-check
// What can be done to the points of a model.

import { WEAR } from "../../generated/declared/wear.js";

export { WEAR };

/**
 * How much of each is done, and the seed that decides where.
 * @typedef {Readonly<Record<string, number>> & { seed: number }} Wear
 */

/**
 * What was done to the points, in words: `noise 0.001, seed 1`.
 * @param {Wear} wear
 */
export function wearWords(wear) {
  return Object.entries(wear).map(([name, value]) => `${name} ${value}`).join(", ");
}
