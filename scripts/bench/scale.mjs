// How time and memory grow with what is brought: many models, and large ones.

import { measureEngine } from "./scale/engine.mjs";
import { measurePage } from "./scale/page.mjs";

export const name = "scale";
export const about = "growth with the number of models, of points and of primitives";

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {import("../bench.mjs").Options} options
 */
export async function measure(bench, options) {
  await measureEngine(bench, options);
  await measurePage(bench, options);
}
