// From a list of files to fitted models, one cloud at a time.

import { join } from "node:path";
import { SEGMENTATION } from "../../www/shared/roles.mjs";
import { isStop } from "./engine.mjs";
import { unusable } from "./inputs.mjs";
import { shareOut } from "./jobs.mjs";
import { eachModel, unplacedAmong } from "./models.mjs";
import { problemOf, writeWhole } from "./write.mjs";

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
 * @typedef {object} Primitive
 * @property {string | null} type
 * @property {number} points
 * @property {number | null} mfe
 * @property {import("../engine/engine.js").SurfaceInfo | null} surface
 * @property {import("../engine/engine.js").StandardErrorsInfo} standardErrors how sure the surface is
 */

/**
 * @typedef {object} Fitted
 * @property {string} model
 * @property {number} points
 * @property {number} seconds of fitting, without reading
 * @property {import("../engine/engine.js").NoiseInfo} noise that was given or measured
 * @property {Primitive[]} primitives
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
export async function fitAll(engine, files, how) {
  const { models, stops, unplaced, engine: able } = await fitEach(engine, files, how);
  return together({ models, stops }, unplaced, able);
}

/**
 * Fits every cloud by so many threads, as `fitAll` does by one, and writes what was found below `out`.
 * @param {Engine} engine
 * @param {{ files: readonly File[] }} inputs
 * @param {Settings & { out: string | undefined, jobs: number, paths: readonly string[], progress: (text: string) => void }} how
 */
export async function fitBy(engine, { files }, { jobs, paths, progress, ...request }) {
  if (jobs <= 1) {
    const { out, ...settings } = request;
    return fitAll(engine, files, {
      ...settings,
      progress,
      take: (able, model, method, texts) => out !== undefined && writeSubmission(able, out, model, method, texts),
    });
  }
  const answers = await shareOut({ task: "fit", request }, { jobs, paths, files: files.length, progress });
  const shares = /** @type {{ models: FittedAt[], stops: import("./models.mjs").Stop[] }[]} */ (answers);
  const all = { models: shares.flatMap(({ models }) => models), stops: shares.flatMap(({ stops }) => stops) };
  return together(all, unplacedAmong(engine, files), engine);
}

/** What became of the model at a place. @typedef {{ index: number, fitted?: Fitted, diagnostics: Diagnostic[] }} FittedAt */

/**
 * @param {{ models: FittedAt[], stops: import("./models.mjs").Stop[] }} all in any order
 * @param {Diagnostic[]} unplaced
 * @param {Engine} engine
 */
function together({ models, stops }, unplaced, engine) {
  models.sort((a, b) => a.index - b.index);
  stops.sort((a, b) => a.index - b.index);
  const told = [...unplaced, ...stops.map(({ diagnostic }) => diagnostic)];
  return { models: models.flatMap(({ fitted }) => fitted ?? []), diagnostics: [...told, ...models.flatMap(({ diagnostics }) => diagnostics)], engine };
}

/**
 * The same, model by model.
 * @param {Engine} engine
 * @param {readonly File[]} files
 * @param {Settings & { take: (engine: Engine, model: string, method: string, texts: Texts) => void, progress?: (text: string) => void, claim?: (index: number) => boolean }} how
 */
export async function fitEach(engine, files, { take, progress = () => {}, claim = () => true, ...settings }) {
  /** @type {FittedAt[]} */
  const models = [];
  const read = await eachModel(engine, files, { wanted: isCloud, progress, claim }, (model, _, place, able, index) => {
    const info = model.info();
    const { diagnostics } = info;
    if (info.points === 0) {
      models.push({ index, diagnostics });
      return;
    }
    const heard = throttled((stage, share) => progress(`${place}, ${stage} ${Math.round(100 * share)} %`));
    let fit;
    try {
      fit = fitModel(model, settings, heard);
    } catch (error) {
      if (isStop(error) || !(error instanceof Error)) {
        throw error;
      }
      // A parameter may suit the other clouds.
      models.push({ index, diagnostics: [...diagnostics, unusable(info.name, error.message)] });
      return;
    }
    const { name, seconds } = fit;
    const error = problemOf(() => take(able, info.name, name, model.write(name)));
    const fitted = {
      ...{ model: info.name, points: info.points, seconds, noise: noiseOf(model, name), primitives: listed(model, name), types: model.types(name) },
      ...(error === undefined ? {} : { error }),
    };
    models.push({ index, fitted, diagnostics });
  });
  return { models, ...read };
}

/**
 * Writes a submission's files below `out`, in the layout of the public test set.
 * @param {Engine} engine
 * @param {string} out
 * @param {string} model
 * @param {string} method
 * @param {Texts} texts
 */
export function writeSubmission(engine, out, model, method, texts) {
  for (const role of SEGMENTATION) {
    writeWhole(join(out, engine.pathOf("test-set", model, role, method)), texts[role]);
  }
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
  const errors = model.standardErrors(name);
  return model.primitives(name).flatMap(({ type, size, mfe, surface }, place) => {
    const standardErrors = errors[place];
    return standardErrors ? [{ type: type ?? null, points: size, mfe: mfe ?? null, surface: surface ?? null, standardErrors }] : [];
  });
}

/**
 * @param {Model} model
 * @param {string} name
 */
function noiseOf(model, name) {
  const noise = model.noise(name);
  if (noise === undefined) {
    throw new Error(`${name} was not fitted here`);
  }
  return noise;
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
