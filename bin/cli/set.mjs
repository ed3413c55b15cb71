// A set of models made of STEP files: which part of it a model is in, and what is written down of it.

import { createHash } from "node:crypto";

/** @typedef {import("./import.mjs").Imported} Imported */

/** The folders of a set that is split, as the benchmark calls them. */
const TRAINING = "training_set";
const TEST = "test_set";

/**
 * The folder of a model. Drawn from its name and the seed alone: a part that is added moves no other.
 * @param {string} model
 * @param {number} seed
 * @param {number | undefined} test the share of the test set, where there is to be one
 */
export function setOf(model, seed, test) {
  if (test === undefined) return "";
  const drawn = createHash("sha256").update(`${seed} ${model}`).digest().readUInt32BE(0) / 2 ** 32;
  return drawn < test ? TEST : TRAINING;
}

/**
 * Everything that is needed to make the set again, or to see that it is the same.
 * @param {readonly Imported[]} made
 * @param {{ engine: string, options: object, wear: object, test: number | undefined, failed: readonly { source: string, reason: string }[] }} how
 */
export function manifestOf(made, { engine, options, wear, test, failed }) {
  const manifest = {
    engine,
    options,
    degradation: wear,
    ...(test === undefined ? {} : { testShare: test }),
    models: made.map(({ report, ...model }) => ({
      ...model,
      faces: report.faces.length,
      leftOut: report.lost,
      diagonal: report.diagonal,
      spacing: report.spacing,
    })),
    failed,
    statistics: statisticsOf(made),
  };
  return `${JSON.stringify(manifest, null, 2)}\n`;
}

/** @param {readonly Imported[]} made */
function statisticsOf(made) {
  /** @type {Record<string, number>} */
  const types = {};
  for (const [type, count] of made.flatMap((model) => Object.entries(model.types))) {
    types[type] = (types[type] ?? 0) + count;
  }
  const sum = (/** @type {"points" | "primitives"} */ of) => made.reduce((total, model) => total + model[of], 0);
  return { models: made.length, points: sum("points"), primitives: sum("primitives"), types };
}
