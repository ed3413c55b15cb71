// Where things are in the checkout.

import { existsSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const WASM_TARGET = "wasm32-unknown-unknown";

const executable = process.platform === "win32" ? ".exe" : "";

/** Tools built for this checkout alone; nothing is installed outside it. */
export const TOOLS = join(ROOT, ".tools");

/** @param {string} name */
export function tool(name) {
  return join(TOOLS, "bin", name + executable);
}

/**
 * A command that npm put into the checkout, as the script to hand to Node.
 * @param {string} script
 */
export function npmCommand(script) {
  return join(ROOT, "node_modules", script);
}

/** The benchmark's own files, or undefined where they are not at hand. */
export function benchmarkFiles() {
  const shared = process.env.FIT4CAD_SHARED ?? join(ROOT, "../shared");
  const folder = resolve(shared, "fit4cad");
  return existsSync(folder) ? folder : undefined;
}
