// @ts-check
// JSON: everything, as the engine reports it, each report with the files it was made of.

/** @param {readonly import("./results.mjs").Row[]} results */
export function json(results) {
  return `${JSON.stringify(results, null, 2)}\n`;
}
