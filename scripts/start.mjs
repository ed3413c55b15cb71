// Sets up, builds and serves the page; changes to the page's own files show at once.

import { npmCommand } from "./lib/paths.mjs";
import { main, runNode, say } from "./lib/run.mjs";
import { buildWasm } from "./build.mjs";
import { setup } from "./setup.mjs";

await main(async () => {
  await setup();
  say("building the engine and the renderer");
  await buildWasm();
  say("serving the page; Ctrl+C ends it");
  await runNode(npmCommand("vite/bin/vite.js"), process.argv.slice(2));
});
