// @ts-check
// CSV (RFC 4180): one row per model and method.

import { ROLES } from "../../generated/declared/roles.js";
import { MEASURES } from "./measures.mjs";

/** @typedef {import("./results.mjs").Result} Result */
/** @typedef {import("./results.mjs").Role} Role */

/** One column per file: whose it is, and what it holds. */
const FILES = /** @type {const} */ ([undefined, "truth", "method"]).flatMap((owner) =>
  ROLES.filter(({ name }) => (name === "cloud") === (owner === undefined)).map(({ name }) => ({ role: name, owner })),
);

const HEAD = [
  ...["model", "method", "protocol", "points", "truth", "predicted"],
  ...[...MEASURES, "type_errors", "engine"],
  ...FILES.map(({ role, owner }) => [owner, role, "sha256"].filter(Boolean).join("_")),
];

/** @param {readonly Result[]} results */
export function csv(results) {
  const rows = results.map((result) => [
    ...[result.model, result.method, result.protocol].map(guarded),
    ...[result.points, result.truth, result.predicted],
    ...MEASURES.map((measure) => result.mean[measure] ?? ""),
    result.type_errors,
    guarded(result.engine),
    ...FILES.map(({ role, owner }) => hashOf(result, role, owner === "method")),
  ]);
  return csvText([HEAD, ...rows]);
}

/**
 * Rows of cells as text.
 * @param {readonly (readonly (string | number)[])[]} rows
 */
export function csvText(rows) {
  return rows.map((row) => `${row.map(cell).join(",")}\r\n`).join("");
}

/**
 * @param {Result} result
 * @param {Role} role
 * @param {boolean} submitted
 */
function hashOf({ files }, role, submitted) {
  const found = files.filter((file) => file.role === role && (file.method !== undefined) === submitted);
  return found.map(({ sha256 }) => sha256 ?? "").join(" ");
}

/**
 * Spreadsheets run a text that starts like a formula; a leading apostrophe keeps it a text.
 * @param {string} text
 */
export function guarded(text) {
  return /^[=+\-@\t\r\n]/.test(text) ? `'${text}` : text;
}

/** @param {string | number} value */
function cell(value) {
  const text = String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
