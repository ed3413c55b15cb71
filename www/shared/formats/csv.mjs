// @ts-check
// CSV (RFC 4180): one row per model and method.

import { ROLES } from "../../generated/declared/roles.js";
import { figure, linesOf } from "./lines.mjs";
import { USUAL } from "./wanted.mjs";

/** @typedef {import("./results.mjs").Row} Result */
/** @typedef {import("./results.mjs").Role} Role */

/** One column per file: whose it is, and what it holds. */
const FILES = /** @type {const} */ ([undefined, "truth", "method"]).flatMap((owner) =>
  ROLES.filter(({ name }) => (name === "cloud") === (owner === undefined)).map(({ name }) => ({ role: name, owner })),
);

/**
 * @param {readonly Result[]} results
 * @param {readonly import("./measures.mjs").MethodSummary[]} [summaries] the engine's, of the same results; for means alone
 * @param {import("./wanted.mjs").Wanted} [wanted] figures are whole unless a number of digits is asked for
 */
export function csv(results, summaries = [], wanted = USUAL) {
  const { measures, digits } = wanted;
  const { models, means } = linesOf(results, summaries, wanted, (value) =>
    value === null ? "" : digits === undefined ? String(value) : figure(value, digits),
  );
  if (wanted.means) {
    const rows = means.map(({ method, models: count, figures, typeErrors }) => {
      const own = results.find((result) => result.method === method);
      const said = [own?.protocol ?? "", String(count), ...figures.map(({ text }) => text), typeErrors ?? "", guarded(own?.engine ?? "")];
      return [guarded(method), ...said];
    });
    return csvText([["method", "protocol", "models", ...measures, "type_errors", "engine"], ...rows]);
  }
  const rows = results.map((result, at) => [
    ...[result.model, result.method, result.protocol].map(guarded),
    ...[result.points, result.truth, result.predicted ?? ""],
    ...(models[at]?.figures ?? []).map(({ text }) => text),
    result.type_errors ?? "",
    guarded(result.engine),
    ...FILES.map(({ role, owner }) => hashOf(result, role, owner === "method")),
  ]);
  const files = FILES.map(({ role, owner }) => [owner, role, "sha256"].filter(Boolean).join("_"));
  return csvText([["model", "method", "protocol", "points", "truth", "predicted", ...measures, "type_errors", "engine", ...files], ...rows]);
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
