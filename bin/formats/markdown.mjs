// @ts-check
// Markdown: a table for a README or a discussion, then how to repeat it.

import { MEASURES, byMethod, meanOf } from "./measures.mjs";
import { checksums, oneLine, provenance } from "./results.mjs";

const TEXT = ["Model", "Method"];
const COUNTS = ["Points", "True", "Predicted"];
const HEAD = [...TEXT, ...COUNTS, ...MEASURES, "Type errors"];

/** @param {readonly import("./results.mjs").Result[]} results */
export function markdown(results) {
  const rows = results.map((result) => [
    ...[result.model, result.method].map(escaped),
    ...[result.points, result.truth, result.predicted].map(String),
    ...MEASURES.map((measure) => figure(result.mean[measure])),
    String(result.type_errors),
  ]);
  const lines = [
    row(HEAD),
    row(HEAD.map((_, column) => (column < TEXT.length ? "---" : "---:"))),
    ...[...rows, ...meanRows(results)].map(row),
    "",
    ...provenance(results).map((way) => `${escaped(way)}.`),
    "",
    "```text",
    ...checksums(results),
    "```",
  ];
  return `${lines.join("\n")}\n`;
}

/** @param {readonly import("./results.mjs").Result[]} results */
function meanRows(results) {
  return byMethod(results).map(({ method, own }) =>
    [
      `Mean of ${own.length}`,
      escaped(method),
      ...COUNTS.map(() => ""),
      ...MEASURES.map((measure) => figure(meanOf(own, measure))),
      String(own.reduce((sum, { type_errors }) => sum + type_errors, 0)),
    ].map((text) => text && `**${text}**`),
  );
}

/** @param {readonly string[]} cells */
function row(cells) {
  return `| ${cells.join(" | ")} |`;
}

/** @param {number | null} value */
function figure(value) {
  return value === null ? "n/a" : value.toFixed(4);
}

/**
 * Any character that Markdown or HTML gives a meaning, as itself.
 * @param {string} text
 */
function escaped(text) {
  return oneLine(text).replace(/[\\`*_{}[\]()<>#+!|~&$@:]/g, "\\$&");
}
