// @ts-check
// Markdown: a table for a README or a discussion, then how to repeat it.

import { oneLine } from "../text.mjs";
import { MEASURES, meanOf, ofSeveral } from "./measures.mjs";
import { checksums, provenance } from "./results.mjs";

/** @typedef {import("./measures.mjs").MethodSummary} MethodSummary */

const TEXT = ["Model", "Method"];
const COUNTS = ["Points", "True", "Predicted"];
const HEAD = [...TEXT, ...COUNTS, ...MEASURES, "Type errors"];

/**
 * @param {readonly import("./results.mjs").Result[]} results
 * @param {readonly MethodSummary[]} summaries the engine's, of the same reports
 */
export function markdown(results, summaries) {
  const rows = results.map((result) => [
    ...[result.model, result.method].map(escapedMarkdown),
    ...[result.points, result.truth, result.predicted].map(String),
    ...MEASURES.map((measure) => figure(result.mean[measure])),
    String(result.type_errors),
  ]);
  const lines = [
    row(HEAD),
    row(HEAD.map((_, column) => (column < TEXT.length ? "---" : "---:"))),
    ...[...rows, ...meanRows(summaries)].map(row),
    "",
    ...provenance(results).map((way) => `${escapedMarkdown(way)}.`),
    "",
    "```text",
    ...checksums(results),
    "```",
  ];
  return `${lines.join("\n")}\n`;
}

/** @param {readonly MethodSummary[]} summaries */
function meanRows(summaries) {
  return ofSeveral(summaries).map((summary) =>
    [
      `Mean of ${summary.models}`,
      escapedMarkdown(summary.method),
      ...COUNTS.map(() => ""),
      ...MEASURES.map((measure) => figure(meanOf(summary, measure))),
      String(summary.typeErrors),
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
export function escapedMarkdown(text) {
  return oneLine(text).replace(/[\\`*_{}[\]()<>#+!|~&$@:]/g, "\\$&");
}
