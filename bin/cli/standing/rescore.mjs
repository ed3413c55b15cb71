// Scores again what a scores.json claims, from files that are known by their SHA-256.

import { differencesOf } from "../../../www/shared/results/compare.mjs";
import { isStop, loadEngineApart } from "../engine.mjs";
import { scored, setScores } from "./entry.mjs";
import { fitInto } from "./known.mjs";

/**
 * @typedef {import("../engine.mjs").Engine} Engine
 * @typedef {import("../../engine/engine.js").Role} Role
 * @typedef {import("../../../www/shared/results/scores.mjs").Entry} Entry
 * @typedef {import("../../../www/shared/results/scores.mjs").SetScores} SetScores
 * @typedef {import("../../../www/shared/results/compare.mjs").Difference} Difference
 */

/**
 * What became of the claims about one set.
 * @typedef {object} Outcome
 * @property {string} set
 * @property {number} models claimed
 * @property {number} scored of them
 * @property {readonly { model: string, message: string }[]} unscored what kept the others from being scored
 * @property {readonly Difference[]} differences
 * @property {SetScores} found
 */

/**
 * @param {Engine} engine
 * @param {SetScores} claimed
 * @param {{ known: import("./known.mjs").Known, method: string, fitter?: import("../../../www/shared/results/method.mjs").FitMethod | undefined, progress?: (text: string) => void }} how
 * @returns {Promise<{ outcome: Outcome, engine: Engine }>} the engine is another one where the first stopped in the middle of a model
 */
export async function rescore(engine, claimed, { known, method, fitter, progress = () => {} }) {
  let able = engine;
  /** @type {ReturnType<typeof scored>[]} */
  const rows = [];
  /** @type {{ model: string, message: string }[]} */
  const unscored = [];
  for (const [at, entry] of claimed.models.entries()) {
    progress(`${claimed.set}, ${at + 1} of ${claimed.models.length}: ${entry.model}`);
    try {
      const row = rescoreModel(able, entry, { known, method, fitter, scale: claimed.scale });
      if (typeof row === "string") unscored.push({ model: entry.model, message: row });
      else rows.push(row);
    } catch (error) {
      unscored.push({ model: entry.model, message: isStop(error) ? "the engine ran out of memory, or failed, on this model" : error instanceof Error ? error.message : String(error) });
      if (isStop(error)) able = (await loadEngineApart()).engine;
    }
  }
  const found = setScores(able, claimed.set, rows, claimed.scale);
  const outcome = { set: claimed.set, models: claimed.models.length, scored: rows.length, unscored, differences: differencesOf(claimed, found), found };
  return { outcome, engine: able };
}

/**
 * A model scored again, or why it cannot be.
 * @param {Engine} engine
 * @param {Entry} entry
 * @param {{ known: import("./known.mjs").Known, method: string, fitter: import("../../../www/shared/results/method.mjs").FitMethod | undefined, scale: SetScores["scale"] }} how
 */
function rescoreModel(engine, { model: name, inputs, answers }, { known, method, fitter, scale }) {
  const truth = filesOf(inputs, known, undefined);
  if (typeof truth === "string") return `of the ground truth, ${truth}`;
  if (fitter !== undefined) {
    const cloud = engine.Model.read(name, truth.filter(({ role }) => role === "cloud"));
    fitInto(cloud, fitter, known);
    cloud.free();
  }
  const answer = filesOf(answers, known, method);
  if (typeof answer === "string") {
    return fitter === undefined ? `of the answers, ${answer}` : `the fitter found something else here: of the answers, ${answer}`;
  }
  const model = engine.Model.read(name, [...truth, ...answer]);
  const row = scored(model, method, { name, inputs, answers, scale });
  model.free();
  return row;
}

/**
 * The files with these hashes, or which of them is not there.
 * @param {Entry["inputs"]} hashes
 * @param {import("./known.mjs").Known} known
 * @param {string | undefined} method
 */
function filesOf(hashes, known, method) {
  /** @type {(import("../inputs.mjs").File & { role: Role, method?: string })[]} */
  const files = [];
  const each = /** @type {[Role, string | readonly string[]][]} */ (Object.entries(hashes));
  for (const [role, hash] of each.flatMap(([role, of]) => [of].flat().map((one) => /** @type {const} */ ([role, one])))) {
    const file = known.get(hash);
    if (!file) return `the ${role} file with the SHA-256 ${hash.slice(0, 12)}… is not among the files given`;
    files.push({ ...file, role, ...(method === undefined ? {} : { method }) });
  }
  return files;
}
