// @ts-check
// The paper's two methods as rows beside one's own, on the models that are its test models.

import { TEST_MODELS, published } from "../published/figures.mjs";
import { matchOf } from "../published/match.mjs";
import { PUBLISHED_METHODS } from "../published/methods.mjs";
import { MEASURES } from "./measures.mjs";

/** @typedef {import("./results.mjs").Row} Row */

/**
 * The results, and after those of each test model the published ones, by the same protocol.
 * @param {readonly Row[]} results those of a model stand together
 * @returns {Row[]}
 */
export function withPublished(results) {
  const taken = new Set(results.map(({ method }) => method));
  const names = PUBLISHED_METHODS.map((method) => ({ method, name: unlike(`${method} (published)`, taken) }));
  return results.flatMap((result, at) => {
    const { model: name, points, truth, protocol } = result;
    const match = matchOf({ name, points, truth }, TEST_MODELS);
    if (match.kind !== "matched" || results[at + 1]?.model === name) {
      return [result];
    }
    /** @param {(typeof names)[number]} of @returns {import("./results.mjs").PublishedResult} */
    const row = ({ method, name: called }) => ({
      ...{ model: name, method: called, protocol, points, truth, predicted: null, type_errors: null },
      mean: Object.fromEntries(MEASURES.map((measure) => [measure, published(match.model, method, protocol, measure)])),
      ...{ engine: "", files: [], published: true },
    });
    return [result, ...names.map(row)];
  });
}

/**
 * The name, changed where a submission has it: figures of two are never put under one.
 * @param {string} name
 * @param {ReadonlySet<string>} taken
 */
function unlike(name, taken) {
  let free = name;
  while (taken.has(free)) {
    free += "*";
  }
  return free;
}
