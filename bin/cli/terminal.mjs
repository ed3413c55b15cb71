// What goes to the terminal: results to stdout, everything else to stderr.

import { once } from "node:events";
import { printable } from "../../www/shared/text.mjs";
import { whyUnwritten } from "./reasons.mjs";

/** Ends when nothing can be printed any more: quietly where the reader of a pipe has gone (`fit4cad … | head`). */
export function endOnClosedPipe() {
  process.stdout.on("error", (error) => {
    if ("code" in error && error.code === "EPIPE") process.exit(0);
    warn(`fit4cad: the result could not be printed: ${whyUnwritten(error)}`);
    process.exit(1);
  });
  process.stderr.on("error", () => {});
}

/**
 * Writes to stdout, waiting for a slow reader.
 * @param {string} text
 */
export async function print(text) {
  if (!process.stdout.write(text)) {
    await once(process.stdout, "drain");
  }
}

/**
 * A line for the person at the terminal, free of control characters that files may have smuggled in.
 * @param {string} text
 */
export function warn(text) {
  progress.clear();
  process.stderr.write(`${printable(text)}\n`);
}

/** One line that is rewritten in place, only where stderr is a terminal. */
export const progress = {
  shown: false,

  /** @param {string} text */
  show(text) {
    if (process.stderr.isTTY) {
      const width = Math.max(20, (process.stderr.columns) - 1);
      process.stderr.write(`\r\u001b[K${printable(text).slice(0, width)}`);
      this.shown = true;
    }
  },

  clear() {
    if (this.shown) {
      process.stderr.write("\r\u001b[K");
      this.shown = false;
    }
  },
};
