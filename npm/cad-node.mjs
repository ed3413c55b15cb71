// What reads and writes STEP, for Node: ready once imported.

import { readFileSync } from "node:fs";
import { initSync } from "./bin/cad/cad.js";

export * from "./bin/cad/cad.js";

const output = initSync({ module: readFileSync(new URL("./bin/cad/cad_bg.wasm", import.meta.url)) });

export default async function init() {
  return output;
}
