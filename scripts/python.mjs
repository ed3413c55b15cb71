// `npm run python [-- --test]`: the Python package as a wheel, which is left in target/wheels and installed in
// .tools/python; with --test also tested, in a fresh environment that has nothing but what the wheel asks for.

import { statSync } from "node:fs";
import { relative } from "node:path";
import { parseArgs } from "node:util";
import { buildWheel, testWheel } from "./lib/python.mjs";
import { ROOT } from "./lib/paths.mjs";
import { Plain, main, say } from "./lib/run.mjs";

function readOptions() {
  try {
    return parseArgs({ options: { test: { type: "boolean", default: false } } }).values;
  } catch (error) {
    throw new Plain(error instanceof Error ? error.message : String(error));
  }
}

await main(async () => {
  const { test } = readOptions();
  say("building the Python package (the first time a few minutes)");
  const wheel = await buildWheel("wheel");
  say(`built ${relative(ROOT, wheel)}, ${(statSync(wheel).size / 1e6).toFixed(1)} MB; .tools/python has it installed`);
  if (test) {
    say("testing it in an environment of its own");
    await testWheel(wheel);
  }
});
