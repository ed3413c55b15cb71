// CSV (RFC 4180): one row per model and method.

import { MEASURES } from "./measures.mjs";

const HEAD = [
  ...["model", "method", "protocol", "points", "truth", "predicted"],
  ...[...MEASURES, "type_errors"],
];

export function csv(reports) {
  const rows = reports.map((report) => [
    ...[report.model, report.method, report.protocol].map(guarded),
    ...[report.points, report.truth, report.predicted],
    ...MEASURES.map((measure) => report.mean[measure] ?? ""),
    report.type_errors,
  ]);
  return [HEAD, ...rows].map((row) => `${row.map(cell).join(",")}\r\n`).join("");
}

/** Spreadsheets run a text that starts like a formula; a leading apostrophe keeps it a text. */
function guarded(text) {
  return /^[=+\-@\t\r\n]/.test(text) ? `'${text}` : text;
}

function cell(value) {
  const text = String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
