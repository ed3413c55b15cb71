// What goes to the terminal: results to stdout, everything else to stderr.

import { once } from "node:events";

/** Ends quietly when the reader of a pipe has gone (`fit4cad … | head`). */
export function endOnClosedPipe() {
  process.stdout.on("error", (error) => {
    process.exit(error.code === "EPIPE" ? 0 : 1);
  });
  process.stderr.on("error", () => {});
}

/** Writes to stdout, waiting for a slow reader. */
export async function print(text) {
  if (!process.stdout.write(text)) {
    await once(process.stdout, "drain");
  }
}

/** A line for the person at the terminal, free of control characters that files may have smuggled in. */
export function warn(text) {
  progress.clear();
  process.stderr.write(`${printable(text)}\n`);
}

export function printable(text) {
  // eslint-disable-next-line no-control-regex -- they are what is removed
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f]/g, "\ufffd");
}

/** One line that is rewritten in place, only where stderr is a terminal. */
export const progress = {
  shown: false,

  show(text) {
    if (process.stderr.isTTY) {
      const width = Math.max(20, (process.stderr.columns ?? 80) - 1);
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
