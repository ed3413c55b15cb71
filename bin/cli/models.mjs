// From a list of files to models, grouped by their names and read one at a time.

import { isStop, loadEngineApart } from "./engine.mjs";
import { unusable } from "./inputs.mjs";

/** @typedef {import("./engine.mjs").Engine} Engine */
/** @typedef {import("./inputs.mjs").File} File */
/** @typedef {import("../engine/engine.js").Model} Model */
/** @typedef {import("../engine/engine.js").PlacedFile} PlacedFile */
/** @typedef {import("../engine/engine.js").Override} Override */
/** @typedef {PlacedFile & File} ModelFile */

/**
 * @typedef {object} Choice
 * @property {(file: PlacedFile) => boolean} [wanted] which files are read; all where it is left out
 * @property {Record<string, Override>} [overrides] by path, what is known better than a name tells
 * @property {(text: string) => void} [progress]
 * @property {(index: number) => boolean} [claim] which models are done here; all where it is left out
 */

/** A model that the engine could not bear, by its place. @typedef {{ index: number, diagnostic: import("./inputs.mjs").Diagnostic }} Stop */

/**
 * Whether a placed file is the cloud or of the ground truth, and no method's.
 * @param {PlacedFile} file
 */
export const isOfTruth = ({ method }) => method === undefined;

/**
 * Reads each model among the files, in the engine's order, hands it to `visit(model, files, place)`
 * with the files it was read from, its place in the row for the terminal and the engine it is in, and
 * releases it. Gives the diagnostics of files that belong to no model, and of models that the engine
 * could not bear (also by their places, as `stops`): the others get a fresh one, and the last is given back,
 * fit for what is to come.
 * Anything else that `visit` throws ends the run.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Choice} choice
 * @param {(model: Model, files: readonly ModelFile[], place: string, engine: Engine, index: number) => void} visit
 */
export async function eachModel(engine, files, { wanted = () => true, overrides = {}, progress = () => {}, claim = () => true }, visit) {
  const grouping = engine.group(files.map(({ path }) => path), overrides);
  const unplaced = grouping.unplaced.map(({ path, reason }) => unusable(path, reason, "", "warning"));
  /** @type {Stop[]} */
  const stops = [];
  const byPath = new Map(files.map((file) => [file.path, file]));
  let able = engine;
  for (const [index, { name, files: placed }] of grouping.models.entries()) {
    if (!claim(index)) continue;
    const place = `${index + 1} of ${grouping.models.length}: ${name}`;
    progress(place);
    const own = placed.filter(wanted).flatMap((file) => {
      const content = byPath.get(file.path);
      return content ? [told({ ...content, ...file }, (share) => progress(`${place}, reading ${share} %`))] : [];
    });
    try {
      visitModel(able, name, own, (model) => visit(model, own, place, able, index));
    } catch (error) {
      if (!isStop(error)) {
        throw error;
      }
      const diagnostic = unusable(name, "the engine ran out of memory, or failed, on this model", "Thin the cloud, or score fewer results at a time");
      stops.push({ index, diagnostic });
      able = (await loadEngineApart()).engine;
    }
  }
  return { diagnostics: [...unplaced, ...stops.map(({ diagnostic }) => diagnostic)], unplaced, stops, engine: able };
}

/** Shorter parts of a file are looked at, longer ones are its pieces. */
const LOOKED_AT = 2 ** 18;

/**
 * The same file; where it is read in pieces, it is told how much of it is, in hundredths.
 * @param {ModelFile} file
 * @param {(share: number) => void} tell
 * @returns {ModelFile}
 */
function told(file, tell) {
  const { part, size } = file;
  if (!part) return file;
  return {
    ...file,
    part: (from, to) => {
      if (to - from > LOOKED_AT) tell(Math.round((100 * to) / size));
      return part(from, to);
    },
  };
}

/**
 * The diagnostics of files that belong to no model.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Record<string, Override>} [overrides]
 */
export function unplacedAmong(engine, files, overrides = {}) {
  const grouping = engine.group(files.map(({ path }) => path), overrides);
  return grouping.unplaced.map(({ path, reason }) => unusable(path, reason, "", "warning"));
}

/**
 * @param {Engine} engine
 * @param {string} name
 * @param {readonly ModelFile[]} files
 * @param {(model: Model) => void} visit
 */
function visitModel(engine, name, files, visit) {
  const model = engine.Model.read(name, [...files]);
  visit(model);
  // After a failure there is nothing left to be released from.
  model.free();
}
