// Files that are known by what they hold: whatever they are called, and wherever they lie.

import { FITTERS } from "../../../www/generated/declared/fitters.js";
import { fitModel } from "../fitting.mjs";
import { unusable } from "../inputs.mjs";
import { eachModel } from "../models.mjs";
import { bareName, sha256 } from "./entry.mjs";

/**
 * @typedef {import("../engine.mjs").Engine} Engine
 * @typedef {import("../inputs.mjs").File} File
 * @typedef {import("../../engine/engine.js").Role} Role
 * @typedef {import("../../../www/shared/results/sets.mjs").ModelSet} ModelSet
 * @typedef {Omit<File, "size">} Kept
 */

/** Files by the SHA-256 of their content. */
export class Known {
  /** @type {Map<string, File>} */
  #files = new Map();

  /** @param {string} hash */
  get(hash) {
    return this.#files.get(hash);
  }

  /**
   * Takes files in. What cannot be read is told and left out.
   * @param {readonly File[]} files
   */
  take(files) {
    /** @type {import("../inputs.mjs").Diagnostic[]} */
    const problems = [];
    for (const file of files) {
      try {
        this.#files.set(sha256(file.read()), file);
      } catch (error) {
        problems.push(unusable(file.path, error instanceof Error ? error.message : String(error)));
      }
    }
    return problems;
  }

  /**
   * A text that was made here.
   * @param {string} path
   * @param {string} text
   */
  add(path, text) {
    const content = new TextEncoder().encode(text);
    this.#files.set(sha256(content), { path, size: content.length, read: () => content });
  }
}

/**
 * Makes every model among the files that is called like one of a degraded set worse, and takes in what comes of it.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {ModelSet} set
 * @param {Known} known
 */
export async function degradeInto(engine, files, set, known) {
  return degradeAll(engine, files, set, (path, text) => known.add(path, text));
}

/**
 * The texts of every model of a degraded set, made of the models that it is of.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Pick<ModelSet, "models" | "degraded">} set all models where it names none
 * @param {(path: string, text: string, model: string) => void} take
 */
export async function degradeAll(engine, files, { models, degraded }, take) {
  if (!degraded) return engine;
  const { engine: able } = await eachModel(engine, files, { wanted: ({ method }) => method === undefined }, (model, _files, _place, now) => {
    const { name, hasTruth } = model.info();
    if (!hasTruth || (models.length > 0 && !models.includes(bareName(name)))) return;
    const worse = model.degraded(degraded);
    for (const [role, text] of /** @type {[Role, string][]} */ (Object.entries(worse.write()))) {
      take(now.pathOf("test-set", bareName(name), role), text, bareName(name));
    }
    worse.free();
  });
  return able;
}

/**
 * Fits a cloud as a row says that it was fitted, with default parameters, and takes in what is found.
 * @param {import("../../engine/engine.js").Model} model
 * @param {import("../../../www/shared/results/method.mjs").FitMethod} fitter
 * @param {Known} known
 */
export function fitInto(model, fitter, known) {
  const { name } = fitModel(model, { method: fitter });
  for (const [role, text] of Object.entries(model.write(name))) known.add(`${FITTERS.find((each) => each.name === fitter)?.title ?? fitter}/${role}`, text);
}
