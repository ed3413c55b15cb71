// The engine for Node: ready once imported. `init` is there so that the same lines run in a bundler.

import { readFileSync } from "node:fs";
import { initSync } from "./bin/engine/engine.js";

export * from "./bin/engine/engine.js";

const output = initSync({ module: readFileSync(new URL("./bin/engine/engine_bg.wasm", import.meta.url)) });

export default async function init() {
  return output;
}
