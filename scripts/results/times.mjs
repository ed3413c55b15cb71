// How long a fitter of the playground takes for each cloud, as `fit4cad submit --times` reads it: processor time of the
// one thread, which does not hang on what else the machine is busy with.
//
//   node scripts/results/times.mjs ht PATH… > times.json

import { loadEngine } from "../../bin/cli/engine.mjs";
import { fitModel } from "../../bin/cli/fitting.mjs";
import { collect } from "../../bin/cli/inputs.mjs";
import { eachModel } from "../../bin/cli/models.mjs";
import { METHODS } from "../../bin/cli/parameters.mjs";
import { choice } from "../../bin/cli/usage.mjs";

const [name = "", ...paths] = process.argv.slice(2);
const method = choice("method", name, METHODS);
/** @type {{ model: string, seconds: number }[]} */
const times = [];
await eachModel(await loadEngine(), (await collect(paths)).files, { wanted: ({ role }) => role === "cloud" }, (model) => {
  const { name: called, points } = model.info();
  if (points === 0) return;
  // The engine is compiled a second time, faster, while it runs: the first of two fits pays for that.
  const seconds = Array.from({ length: 2 }, () => {
    const before = process.cpuUsage();
    fitModel(model, { method });
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1e6;
  });
  times.push({ model: called, seconds: Math.min(...seconds) });
});
process.stdout.write(`${JSON.stringify(times, null, 1)}\n`);
