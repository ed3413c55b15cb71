// `npm run python`: the Python package as a wheel, which is left in target/wheels and installed in .tools/python.

import { relative } from "node:path";
import { buildWheel } from "./lib/python.mjs";
import { ROOT } from "./lib/paths.mjs";
import { main, say } from "./lib/run.mjs";

await main(async () => {
  say("building the Python package (the first time a few minutes)");
  const wheel = await buildWheel("wheel");
  say(`built ${relative(ROOT, wheel)}; .tools/python has it installed`);
});
