// From a list of files to fitted models, one cloud at a time.

import { eachModel } from "./models.mjs";
import { problemOf } from "./write.mjs";

/** @typedef {import("./engine.mjs").Engine} Engine */
/** @typedef {import("./inputs.mjs").File} File */
/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */
/** @typedef {import("../engine/engine.js").Model} Model */
/** @typedef {import("../engine/engine.js").FitMethod} FitMethod */
/** @typedef {import("../engine/engine.js").Texts} Texts */

/**
 * How a fitter is to be run.
 * @typedef {object} Settings
 * @property {FitMethod} method
 * @property {Record<string, number>} [parameters] by name; those left out have their defaults
 * @property {number} [seed]
 */

/**
 * Hears the stage of a fit, and how much of the stage is done, 0 to 1.
 * @typedef {(stage: string, share: number) => void} OnStage
 */

/**
 * @typedef {object} Fitted
 * @property {string} model
 * @property {number} points
 * @property {number} seconds of fitting, without reading
 * @property {{ type: string | null, points: number, mfe: number | null }[]} primitives
 * @property {import("../engine/engine.js").Types} types how many primitives are of each type
 * @property {string} [error] why its files could not be written
 */

/**
 * Fits the cloud of every model among the files, in the engine's order of models. `take` gets each
 * model's written files as soon as they are there, so that they need not be held; where it throws
 * `NotWritten`, the model says so and the others go on.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Settings & { take: (engine: Engine, model: string, method: string, texts: Texts) => void, progress?: (text: string) => void }} how
 */
export async function fitAll(engine, files, { take, progress = () => {}, ...settings }) {
  /** @type {Fitted[]} */
  const models = [];
  /** @type {Diagnostic[]} */
  const found = [];
  const read = await eachModel(engine, files, { wanted: isCloud, progress }, (model, _, place, able) => {
    const info = model.info();
    found.push(...info.diagnostics);
    if (info.points === 0) {
      return;
    }
    const heard = throttled((stage, share) => progress(`${place}, ${stage} ${Math.round(100 * share)} %`));
    const { name, seconds } = fitModel(model, settings, heard);
    const error = problemOf(() => take(able, info.name, name, model.write(name)));
    models.push({
      ...{ model: info.name, points: info.points, seconds, primitives: listed(model, name), types: model.types(name) },
      ...(error === undefined ? {} : { error }),
    });
  });
  return { models, diagnostics: [...read.diagnostics, ...found], engine: read.engine };
}

/** @param {import("../engine/engine.js").PlacedFile} file */
const isCloud = ({ role }) => role === "cloud";

/**
 * Fits one model and takes the time; the name is the submission's.
 * @param {Model} model
 * @param {Settings} settings
 * @param {OnStage} [progress]
 */
export function fitModel(model, { method, parameters = {}, seed = 1 }, progress = () => {}) {
  const start = performance.now();
  const name = model.fit(method, parameters, seed, progress);
  return { name, seconds: (performance.now() - start) / 1000 };
}

/**
 * @param {Model} model
 * @param {string} name
 */
function listed(model, name) {
  return model.primitives(name).map(({ type, size, mfe }) => ({ type: type ?? null, points: size, mfe: mfe ?? null }));
}

/**
 * Passes on what comes at least a tenth of a second after what was passed on before.
 * @param {OnStage} report
 * @returns {OnStage}
 */
function throttled(report) {
  let last = -Infinity;
  return (stage, share) => {
    const now = performance.now();
    if (now - last >= 100) {
      last = now;
      report(stage, share);
    }
  };
}
