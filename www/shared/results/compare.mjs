// @ts-check
// Scores that are claimed against scores that were found: digit by digit.

import { BY } from "./scores.mjs";

/**
 * @typedef {import("./scores.mjs").SetScores} SetScores
 * @typedef {import("./scores.mjs").Entry} Entry
 * @typedef {{ readonly model: string | undefined, readonly figure: string, readonly claimed: unknown, readonly found: unknown }} Difference of one model, or of the summary
 */

/** What only its author can have measured. */
const CLAIMED_ONLY = ["seconds"];

/**
 * Every figure that was found to be another than claimed. What an engine before did not know is not claimed
 * and differs from nothing; nor do times, which nobody can measure again.
 * @param {SetScores} claimed
 * @param {SetScores} given
 * @returns {readonly Difference[]}
 */
export function differencesOf(claimed, given) {
  // As a file would hold it, which knows no -0.
  /** @type {SetScores} */
  const found = JSON.parse(JSON.stringify(given));
  const whole = claimed.engine === found.engine;
  const byName = new Map(found.models.map((entry) => [entry.model, entry]));
  const models = claimed.models.flatMap((entry) => {
    const other = byName.get(entry.model);
    // One that could not be scored is told of as such.
    return other ? entryDifferences(entry, other, whole) : [];
  });
  const all = found.models.length === claimed.models.length;
  return all ? [...models, ...unlike(claimed.summary, found.summary, { model: undefined, figure: "summary", whole })] : models;
}

/**
 * @param {Entry} claimed
 * @param {Entry} found
 * @param {boolean} whole
 */
function entryDifferences(claimed, found, whole) {
  return ["points", "truth", "predicted", "typeErrors", "surfacesFitted", ...BY, "figures"].flatMap((figure) =>
    unlike(Reflect.get(claimed, figure), Reflect.get(found, figure), { model: claimed.model, figure, whole }),
  );
}

/**
 * @param {unknown} claimed
 * @param {unknown} found
 * @param {{ model: string | undefined, figure: string, whole: boolean }} of `whole`: what is found and not claimed is told, too
 * @returns {Difference[]}
 */
function unlike(claimed, found, { model, figure, whole }) {
  if (!isBranch(claimed) || !isBranch(found)) return Object.is(claimed, found) ? [] : [{ model, figure, claimed, found }];
  if (Array.isArray(found) && Array.isArray(claimed) && found.length !== claimed.length) {
    return [{ model, figure: `${figure}, how many`, claimed: claimed.length, found: found.length }];
  }
  const keys = [...new Set([...Object.keys(claimed), ...(whole ? Object.keys(found) : [])])].filter((key) => !CLAIMED_ONLY.includes(key));
  return keys.flatMap((key) => {
    const value = Reflect.get(claimed, key);
    return unlike(value, Reflect.get(found, key), { model, figure: `${figure} ${nameOf(key, value)}`, whole });
  });
}

/**
 * @param {unknown} value
 * @returns {value is object}
 */
function isBranch(value) {
  return typeof value === "object" && value !== null;
}

/**
 * Members of lists are called by what they are of.
 * @param {string} key
 * @param {unknown} value
 */
function nameOf(key, value) {
  return isBranch(value) && "stratum" in value ? String(value.stratum) : key;
}
