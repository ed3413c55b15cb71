// Fitting bare clouds.

import { median } from "../lib/bench.mjs";

export const name = "fit";
export const about = "fitting generated parts as they come, one thread";

const METHODS = ["ht", "pg"];

export function measure(bench) {
  const models = bench.engine.parts().map((part) => bench.engine.Model.generate(part.name, {}));
  const points = models.map((model) => model.info().points);
  bench.note(`${models.length} parts, median ${median(points)} points`);
  for (const method of METHODS) {
    const runs = models.map((model) => {
      const start = performance.now();
      const fitted = model.fit(method, {}, 1);
      const seconds = (performance.now() - start) / 1000;
      return { seconds, DSC: model.score(fitted, "definition").mean.DSC ?? 0 };
    });
    const label = method.toUpperCase();
    bench.figure(`${label}, median part`, median(runs.map(({ seconds }) => seconds)), "s", { digits: 3 });
    bench.figure(`${label}, slowest part`, Math.max(...runs.map(({ seconds }) => seconds)), "s", { digits: 3 });
    bench.figure(`${label}, mean DSC`, runs.reduce((sum, { DSC }) => sum + DSC, 0) / runs.length, "");
  }
  for (const model of models) {
    model.free();
  }
}
