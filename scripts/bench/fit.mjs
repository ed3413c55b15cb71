// Fitting bare clouds: how well, how robustly, how fast, in how much memory; HT and PG side by side.

import { accuracy } from "./fit/accuracy.mjs";
import { degradation } from "./fit/degradation.mjs";
import { freeForm } from "./fit/free-form.mjs";
import { growth } from "./fit/growth.mjs";
import { METHODS, fitted } from "./fit/fitted.mjs";
import { models } from "./fit/models.mjs";

export const name = "fit";
export const about = "fitting bare clouds with HT and PG, one thread, processor time";

export async function measure(bench, { models: most, quick }) {
  const known = models(bench.engine);
  if (!known.real) {
    bench.note("the public files are not at hand; generated parts instead, without bars");
  }
  warmUp(bench.engine);
  accuracy(bench, known, { most: quick ? Math.min(most, 12) : most });
  degradation(bench, known, { most: quick ? 4 : Math.min(most, 40) });
  freeForm(bench, known, { most: quick ? 4 : most });
  await growth(bench, { sizes: quick ? [1e4, 1e5] : [1e4, 1e5, 1e6] });
}

/** Lets the machine code of both methods be made before anything is timed. */
function warmUp(engine) {
  const model = engine.Model.generate(engine.parts()[0].name, {});
  for (const method of METHODS) {
    fitted(model, method);
  }
  model.free();
}
