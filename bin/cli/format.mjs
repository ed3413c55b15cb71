// In what form a command prints its results.

import { UsageError, choice } from "./usage.mjs";

/** The options of a command that prints results. */
export const FORMAT_OPTIONS = /** @type {const} */ ({
  format: { type: "string" },
  json: { type: "boolean", default: false },
});

/**
 * The format asked for among those allowed: the table where none was, and `--json` is short for
 * `--format json`.
 * @template {string} Format
 * @param {{ format?: string | undefined, json?: boolean | undefined }} values
 * @param {readonly Format[]} allowed
 */
export function formatOf({ format, json }, allowed) {
  if (json && format !== undefined && format !== "json") {
    throw new UsageError(`--json and --format ${format}: expected one format`);
  }
  return choice("format", json ? "json" : (format ?? "table"), allowed);
}

/**
 * Whether JSON is asked for by arguments that need not make sense otherwise.
 * @param {readonly string[]} args
 */
export function asksForJson(args) {
  const own = args.includes("--") ? args.slice(0, args.indexOf("--")) : args;
  return own.some((arg, at) => ["--json", "--format=json"].includes(arg) || (arg === "json" && own[at - 1] === "--format"));
}
