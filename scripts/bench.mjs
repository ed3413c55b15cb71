// `npm run bench [-- SECTION… [OPTION…]]`: how fast, how big and how good the engine is, measured on
// the wasm that ships. A section is a file of scripts/bench that exports `name`, `about` and
// `measure(bench, options)`. Options, for the sections they mean something to:
//
//   --models N       at most N models of the training set, evenly spread
//   --quick          few models and no large clouds: a look, not a measurement
//   --markdown FILE  writes the tables as Markdown as well

import { readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { cpus } from "node:os";
import { parseArgs } from "node:util";
import { loadEngine } from "../bin/cli/engine.mjs";
import { buildWasm } from "./build.mjs";
import { Bench } from "./lib/bench.mjs";
import { ROOT } from "./lib/paths.mjs";
import { Plain, main } from "./lib/run.mjs";
import { setup } from "./setup.mjs";

/**
 * @typedef {object} Options
 * @property {number} models most models to look at
 * @property {boolean} quick
 * @property {string | undefined} markdown
 */

/**
 * @typedef {{ name: string, about: string, measure: (bench: Bench, options: Options) => void | Promise<void> }} Section
 * @returns {Promise<Section[]>}
 */
async function sections() {
  const folder = join(ROOT, "scripts/bench");
  const files = readdirSync(folder).filter((name) => name.endsWith(".mjs"));
  return Promise.all(files.sort().map((file) => import(pathToFileURL(join(folder, file)).href)));
}

function readOptions() {
  const { values, positionals } = parsed();
  const models = values.models === undefined ? Infinity : Number(values.models);
  if (!(models >= 1)) {
    throw new Plain(`--models ${values.models}: expected a whole number of at least 1`);
  }
  return { quick: values.quick, markdown: values.markdown, models, wanted: positionals };
}

function parsed() {
  try {
    const options = /** @type {const} */ ({
      models: { type: "string" },
      quick: { type: "boolean", default: false },
      markdown: { type: "string" },
    });
    return parseArgs({ options, allowPositionals: true });
  } catch (error) {
    throw new Plain(error instanceof Error ? error.message : String(error));
  }
}

await main(async () => {
  const all = await sections();
  const { wanted, ...options } = readOptions();
  const unknown = wanted.find((word) => !all.some(({ name }) => name === word));
  if (unknown) {
    throw new Plain(`no section "${unknown}"; there are ${all.map(({ name }) => name).join(", ")}`);
  }
  await setup();
  await buildWasm();
  const bench = new Bench(await loadEngine());
  const machine = `${cpus()[0]?.model ?? "unknown processor"}, Node ${process.versions.node}`;
  console.log(`${machine}; medians`);
  for (const section of all) {
    if (wanted.length === 0 || wanted.includes(section.name)) {
      console.log(`\n${section.name}: ${section.about}`);
      await section.measure(bench, options);
    }
  }
  if (options.markdown !== undefined) {
    writeFileSync(options.markdown, `Measured on ${machine}.\n${bench.markdown}`);
  }
  process.exitCode = bench.missed > 0 ? 1 : 0;
});
