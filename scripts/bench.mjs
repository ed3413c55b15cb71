// `npm run bench [-- SECTION…]`: how fast and how big the engine is, measured on the wasm that ships.
// A section is a file of scripts/bench that exports `name`, `about` and `measure(bench)`.

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { cpus } from "node:os";
import { loadEngine } from "../bin/cli/engine.mjs";
import { buildWasm } from "./build.mjs";
import { Bench } from "./lib/bench.mjs";
import { ROOT } from "./lib/paths.mjs";
import { Plain, main } from "./lib/run.mjs";
import { setup } from "./setup.mjs";

async function sections() {
  const folder = join(ROOT, "scripts/bench");
  const files = readdirSync(folder).filter((name) => name.endsWith(".mjs"));
  return Promise.all(files.sort().map((file) => import(pathToFileURL(join(folder, file)).href)));
}

await main(async () => {
  const all = await sections();
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((word) => !all.some(({ name }) => name === word));
  if (unknown) {
    throw new Plain(`no section "${unknown}"; there are ${all.map(({ name }) => name).join(", ")}`);
  }
  await setup();
  await buildWasm();
  const bench = new Bench(await loadEngine());
  console.log(`${cpus()[0]?.model ?? "unknown processor"}, Node ${process.versions.node}; medians`);
  for (const section of all) {
    if (wanted.length === 0 || wanted.includes(section.name)) {
      console.log(`\n${section.name}: ${section.about}`);
      await section.measure(bench);
    }
  }
  process.exitCode = bench.missed > 0 ? 1 : 0;
});
