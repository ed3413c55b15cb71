// In what form a command prints its results.

import { UsageError, choice } from "./usage.mjs";

/** The options of a command that prints results. */
export const FORMAT_OPTIONS = {
  format: { type: "string" },
  json: { type: "boolean", default: false },
};

/** The format asked for among those allowed: the table where none was, and `--json` is short for `--format json`. */
export function formatOf({ format, json }, allowed) {
  if (json && format !== undefined && format !== "json") {
    throw new UsageError(`--json and --format ${format}: expected one format`);
  }
  return choice("format", json ? "json" : (format ?? "table"), allowed);
}
