// Of several runs the least time of each cloud: what else ran on the machine is no time of the method's.
//
//   node scripts/results/fastest.mjs RUN.json… > times.json

import { readFileSync } from "node:fs";

/** @type {Map<string, number>} */
const least = new Map();
for (const path of process.argv.slice(2)) {
  for (const { model, seconds } of JSON.parse(readFileSync(path, "utf8"))) {
    least.set(model, Math.min(seconds, least.get(model) ?? Infinity));
  }
}
process.stdout.write(`${JSON.stringify(Array.from(least, ([model, seconds]) => ({ model, seconds })), null, 1)}\n`);
