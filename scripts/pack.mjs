// `npm run pack`: engine and command line as an npm package, in target/npm.

import { relative } from "node:path";
import { buildWasm } from "./build.mjs";
import { pack } from "./lib/pack.mjs";
import { ROOT } from "./lib/paths.mjs";
import { main, say } from "./lib/run.mjs";
import { setup } from "./setup.mjs";

await main(async () => {
  await setup();
  await buildWasm();
  say(`packed ${relative(ROOT, await pack())}`);
});
