// Fitting bare clouds: how well, how robustly, how fast, in how much memory; HT and PG side by side.

import { accuracy } from "./fit/accuracy.mjs";
import { degradation } from "./fit/degradation.mjs";
import { freeForm } from "./fit/free-form.mjs";
import { growth, warmUp } from "./fit/growth.mjs";
import { models } from "./fit/models.mjs";
import { motion } from "./fit/motion.mjs";

export const name = "fit";
export const about = "fitting bare clouds with HT and PG, one thread, processor time";

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {import("../bench.mjs").Options} options
 */
export async function measure(bench, { models: most, quick }) {
  const known = models(bench.engine);
  if (!known.real) {
    bench.note("the public files are not at hand; generated parts instead, without bars");
  }
  warmUp(bench.engine);
  accuracy(bench, known, { most: quick ? Math.min(most, 12) : most });
  degradation(bench, known, { most: quick ? 4 : Math.min(most, 40) });
  motion(bench, known, { most: quick ? 4 : Math.min(most, 38) });
  freeForm(bench, known, { most: quick ? 4 : most });
  await growth(bench, { sizes: quick ? [1e4, 1e5] : [1e4, 1e5, 1e6] });
}
