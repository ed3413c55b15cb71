// The module for STEP files under Node.

import { instantiate } from "./engine.mjs";

/** @typedef {typeof import("../cad/cad.js")} Cad */

const GLUE = new URL("../cad/cad.js", import.meta.url);
const WASM = new URL("../cad/cad_bg.wasm", import.meta.url);

let instances = 0;

/** A fresh instance: one that has stopped in the middle of something is of no more use. Throws `NotBuilt`. */
export async function loadCad() {
  return (await cadInstance()).cad;
}

/** The same with its memory, which nothing else grows. */
export async function cadInstance() {
  instances += 1;
  /** @type {{ module: Cad, memory: WebAssembly.Memory }} */
  const { module: cad, memory } = await instantiate(`${GLUE.href}?instance=${instances}`, WASM);
  return { cad, memory };
}
