// The engine under Node: the same bytes and the same glue as in the browser.

import { readFileSync } from "node:fs";

/** @typedef {typeof import("../engine/engine.js")} Engine */
/** @typedef {{ engine: Engine, memory: WebAssembly.Memory }} Instance */

const GLUE = new URL("../engine/engine.js", import.meta.url);
const WASM = new URL("../engine/engine_bg.wasm", import.meta.url);

/** The engine has not been built, or something of the checkout is missing. */
export class NotBuilt extends Error {}

/** Loads the engine. Throws `NotBuilt` with what to do where it is not there. */
export async function loadEngine() {
  return (await loadInstance(GLUE.href)).engine;
}

let apart = 0;

/** An instance of its own: its memory is grown by nobody else. */
export function loadEngineApart() {
  apart += 1;
  return loadInstance(`${GLUE.href}?instance=${apart}`);
}

/**
 * Whether the engine has stopped in the middle of something: out of memory, say. Its memory may be
 * in any state then, and what comes after needs a fresh one.
 * @param {unknown} error
 */
export function isStop(error) {
  return error instanceof WebAssembly.RuntimeError;
}

/**
 * @param {string} address
 * @returns {Promise<Instance>}
 */
async function loadInstance(address) {
  /** @type {{ module: Engine, memory: WebAssembly.Memory }} */
  const { module: engine, memory } = await instantiate(address, WASM);
  return { engine, memory };
}

/**
 * Loads a module that wasm-bindgen made: its glue, by an address of its own for each instance, and its
 * bytes. Throws `NotBuilt` with what to do where they are not there.
 * @param {string} address
 * @param {URL} wasm
 */
export async function instantiate(address, wasm) {
  try {
    const module = await import(address);
    const { memory } = module.initSync({ module: readFileSync(wasm) });
    return { module, memory };
  } catch (error) {
    if (codeOf(error) === "ERR_MODULE_NOT_FOUND" || codeOf(error) === "ENOENT") {
      throw new NotBuilt("The engine is not built yet. Run `npm run build` in the checkout, then try again.");
    }
    throw error;
  }
}

/**
 * The code that Node gives its errors.
 * @param {unknown} error
 */
export function codeOf(error) {
  return error instanceof Error && "code" in error ? error.code : undefined;
}
