// Diagnostics at the terminal.

import { warn } from "./terminal.mjs";

/** @typedef {import("./inputs.mjs").Diagnostic} Diagnostic */

/**
 * Each diagnostic in the one line that the engine makes of it.
 * @param {import("./engine.mjs").Engine} engine
 * @param {readonly Diagnostic[]} diagnostics
 */
export function inOneLine(engine, diagnostics) {
  return engine.oneLines([...diagnostics]);
}

/**
 * Tells each diagnostic in its line.
 * @param {import("./engine.mjs").Engine} engine
 * @param {readonly Diagnostic[]} diagnostics
 */
export function tell(engine, diagnostics) {
  for (const line of inOneLine(engine, diagnostics)) {
    warn(line);
  }
}
