// @ts-check
// Which test model a model is. A name alone proves nothing: training models, and anybody's own, are called PC1 as well.

/** @typedef {import("./figures.mjs").TestModel} TestModel */

/**
 * What a model is: a test model by name and counts, or because the reader says so; named like one, but not that one; or none.
 * @typedef {{ readonly kind: "matched", readonly model: string, readonly said: boolean } | { readonly kind: "unlike", readonly model: string, readonly reason: string } | { readonly kind: "none" }} Match
 */

/** What the reader says a model is: the name of a test model, or that it is none. @typedef {string | null} Said */

/**
 * @param {TestModel} model
 * @param {readonly TestModel[]} tests
 * @param {Said} [said]
 * @returns {Match}
 */
export function matchOf({ name, points, truth }, tests, said) {
  if (said === null) {
    return { kind: "none" };
  }
  if (said !== undefined) {
    return { kind: "matched", model: said, said: true };
  }
  // A model's name may hold the folder that tells it from its namesake.
  const own = name.split("/").at(-1)?.toLowerCase();
  const test = tests.find((candidate) => candidate.name.toLowerCase() === own);
  if (!test) {
    return { kind: "none" };
  }
  const differences = [
    points === test.points ? [] : `${points} points for ${test.points}`,
    truth === test.truth ? [] : `${truth} true primitives for ${test.truth}`,
  ].flat();
  if (differences.length === 0) {
    return { kind: "matched", model: test.name, said: false };
  }
  return { kind: "unlike", model: test.name, reason: differences.join(", ") };
}
