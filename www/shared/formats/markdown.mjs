// @ts-check
// Markdown: a table for a README or a discussion, then how to repeat it.

import { oneLine } from "../text.mjs";
import { figure, linesOf } from "./lines.mjs";
import { checksums, provenance } from "./results.mjs";
import { USUAL } from "./wanted.mjs";

/** @typedef {import("./lines.mjs").Line} Line */

const DIGITS = 4;

/**
 * @param {readonly import("./results.mjs").Row[]} results
 * @param {readonly import("./measures.mjs").MethodSummary[]} summaries the engine's, of the same results
 * @param {import("./wanted.mjs").Wanted} [wanted]
 */
export function markdown(results, summaries, wanted = USUAL) {
  const { models, means } = linesOf(results, summaries, wanted, (value) => figure(value, wanted.digits ?? DIGITS));
  const text = wanted.means ? ["Method"] : ["Model", "Method"];
  const counts = wanted.means ? ["Models"] : ["Points", "True", "Predicted"];
  const head = [...text, ...counts, ...wanted.measures, "Type errors"];
  const lines = [
    row(head),
    row(head.map((_, column) => (column < text.length ? "---" : "---:"))),
    ...[...models, ...means].map((line) => row(cells(line, wanted))),
    "",
    ...provenance(results).map((way) => `${escapedMarkdown(way)}.`),
    "",
    "```text",
    ...checksums(results),
    "```",
  ];
  return `${lines.join("\n")}\n`;
}

/**
 * A line; below those of models that of a mean is bold as a whole, unless bold says which is best.
 * @param {Line} line
 * @param {import("./wanted.mjs").Wanted} wanted
 */
function cells({ model, models, method, counts, figures, typeErrors }, { means, bold }) {
  const isFoot = counts === undefined && !means;
  /** @param {string} text @param {boolean} [best] */
  const strong = (text, best = isFoot && !bold) => (best && text ? `**${text}**` : text);
  const labels = counts
    ? [escapedMarkdown(model), escapedMarkdown(method), ...counts.map((count) => (count === null ? "" : String(count)))]
    : means
      ? [escapedMarkdown(method), String(models)]
      : [strong(`Mean of ${models}`), strong(escapedMarkdown(method)), "", "", ""];
  return [
    ...labels,
    ...figures.map(({ text, best }) => strong(text, bold ? best : undefined)),
    strong(typeErrors === null ? "" : String(typeErrors)),
  ];
}

/** @param {readonly string[]} cells */
function row(cells) {
  return `| ${cells.join(" | ")} |`;
}

/**
 * Any character that Markdown or HTML gives a meaning, as itself.
 * @param {string} text
 */
export function escapedMarkdown(text) {
  return oneLine(text).replace(/[\\`*_{}[\]()<>#+!|~&$@:]/g, "\\$&");
}
