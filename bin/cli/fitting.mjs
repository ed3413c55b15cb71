// From a list of files to fitted models, one cloud at a time.

import { eachModel } from "./models.mjs";

/**
 * Fits the cloud of every model among the files, in the engine's order of models. Gives
 * `{ models, diagnostics }`; `take` gets each model's written files as soon as they are there, so
 * that they need not be held. What `take` throws ends the run.
 */
export function fitAll(engine, files, { method, parameters, seed, take, progress = () => {} }) {
  const models = [];
  const found = [];
  const unread = eachModel(engine, files, { wanted: isCloud, progress }, (model, _, place) => {
    const info = model.info();
    found.push(...info.diagnostics);
    if (info.points === 0) {
      return;
    }
    const heard = throttled((stage, share) => progress(`${place}, ${stage} ${Math.round(100 * share)} %`));
    const { name, seconds } = fitModel(model, { method, parameters, seed, progress: heard });
    take(info.name, name, model.write(name));
    models.push({ model: info.name, points: info.points, seconds, primitives: listed(model, name) });
  });
  return { models, diagnostics: [...unread, ...found] };
}

const isCloud = ({ role }) => role === "cloud";

/** Fits one model and takes the time: `{ name, seconds }`, the name being the submission's. */
export function fitModel(model, { method, parameters = {}, seed = 1, progress }) {
  const start = performance.now();
  const name = model.fit(method, parameters, seed, progress);
  return { name, seconds: (performance.now() - start) / 1000 };
}

function listed(model, name) {
  return model.primitives(name).map(({ type, size, mfe }) => ({ type, points: size, mfe: mfe ?? null }));
}

/** Passes on what comes at least a tenth of a second after what was passed on before. */
function throttled(report) {
  let last = -Infinity;
  return (...what) => {
    const now = performance.now();
    if (now - last >= 100) {
      last = now;
      report(...what);
    }
  };
}
