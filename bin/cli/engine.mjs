// The engine under Node: the same bytes and the same glue as in the browser.

import { readFileSync } from "node:fs";

const GLUE = new URL("../engine/engine.js", import.meta.url);
const WASM = new URL("../engine/engine_bg.wasm", import.meta.url);

/** The engine has not been built, or something of the checkout is missing. */
export class NotBuilt extends Error {}

/** Loads the engine. Throws `NotBuilt` with what to do where it is not there. */
export async function loadEngine() {
  return (await instantiate(GLUE.href)).engine;
}

let apart = 0;

/** An instance of its own, `{ engine, memory }`: its memory is grown by nobody else. */
export function loadEngineApart() {
  apart += 1;
  return instantiate(`${GLUE.href}?instance=${apart}`);
}

async function instantiate(address) {
  try {
    const engine = await import(address);
    const { memory } = engine.initSync({ module: readFileSync(WASM) });
    return { engine, memory };
  } catch (error) {
    if (error.code === "ERR_MODULE_NOT_FOUND" || error.code === "ENOENT") {
      throw new NotBuilt("The engine is not built yet. Run `npm run build` in the checkout, then try again.");
    }
    throw error;
  }
}
