// What came of checking a claim, in lines to read.

import { oneLine } from "../../../www/shared/text.mjs";

/** @typedef {{ mark: "✓" | "✗" | "!", text: string }} Line */

/** Most lines of one kind; the rest is counted. */
const MOST_LINES = 20;

/**
 * @param {import("./rescore.mjs").Outcome} outcome
 * @param {string} claimedBy version of the engine that made the claim
 * @returns {Line[]}
 */
export function outcomeLines({ set, models, scored, unscored, differences, found }, claimedBy) {
  /** @type {Line[]} */
  const lines = [];
  const other = claimedBy !== found.engine ? `; claimed with engine ${claimedBy}, scored with ${found.engine}, whose figures can be others` : "";
  if (scored === models && differences.length === 0) {
    return [{ mark: "✓", text: `${set}: ${models} of ${models} models scored again, every digit the same${other}` }];
  }
  for (const { model, message } of unscored.slice(0, MOST_LINES)) lines.push({ mark: "✗", text: `${set}, ${oneLine(model)}: ${oneLine(message)}` });
  for (const { model, figure, claimed, found: value } of differences.slice(0, MOST_LINES)) {
    lines.push({ mark: "✗", text: `${set}, ${oneLine(model ?? "all models")}: ${oneLine(figure)}: claimed ${figureText(claimed)}, found ${figureText(value)}` });
  }
  const more = Math.max(0, unscored.length - MOST_LINES) + Math.max(0, differences.length - MOST_LINES);
  if (more > 0) lines.push({ mark: "✗", text: `${set}: and ${more} more` });
  lines.push({ mark: "✗", text: `${set}: ${scored} of ${models} models scored again, ${differences.length} figures differ${other}` });
  return lines;
}

/** @param {unknown} value */
function figureText(value) {
  return value === undefined ? "nothing" : oneLine(JSON.stringify(value));
}
