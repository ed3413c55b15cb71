// @ts-check
// LaTeX: a booktabs table with the columns of the paper's two, ready to be put in.

import { MEASURES, byMethod, meanOf } from "./measures.mjs";
import { checksums, oneLine, provenance } from "./results.mjs";

/** @typedef {import("./results.mjs").Result} Result */

/** @type {Partial<Record<import("./measures.mjs").Measure, string>>} */
const HEADINGS = { MFE: "MFE", dHaus: "$d_{\\text{dHaus}}$", d1: "$d_1$" };

/** @param {readonly Result[]} results */
export function latex(results) {
  const columns = ["", "method", "\\# points", "\\# true", "\\# predicted"];
  const head = [...columns, ...MEASURES.map((measure) => HEADINGS[measure] ?? measure)];
  const lines = [
    "% Needs \\usepackage{booktabs} and \\usepackage{amsmath}.",
    ...[...provenance(results), ...checksums(results)].map((line) => `% ${line}`),
    `\\begin{tabular}{ll${"r".repeat(head.length - 2)}}`,
    "  \\toprule",
    row(head),
    "  \\midrule",
    ...results.map((report, index) =>
      row([
        report.model === results[index - 1]?.model ? "" : escaped(spaced(report.model)),
        escaped(report.method),
        ...[report.points, report.truth, report.predicted].map(whole),
        ...MEASURES.map((measure) => figure(report.mean[measure])),
      ]),
    ),
    ...meanRows(results),
    "  \\bottomrule",
    "\\end{tabular}",
  ];
  return `${lines.join("\n")}\n`;
}

/** @param {readonly Result[]} results */
function meanRows(results) {
  const rows = byMethod(results).map(({ method, own }) =>
    row([
      `Mean of ${own.length}`,
      escaped(method),
      ...["", "", ""],
      ...MEASURES.map((measure) => figure(meanOf(own, measure))),
    ]),
  );
  return rows.length > 0 ? ["  \\midrule", ...rows] : [];
}

/** @param {readonly string[]} cells */
function row(cells) {
  return `  ${cells.join(" & ")} \\\\`;
}

/**
 * `PC 14`, as the paper writes it.
 * @param {string} model
 */
function spaced(model) {
  return model.replace(/^PC(?=\d+$)/, "PC ");
}

/** @param {number} value */
function whole(value) {
  return `$${String(value).replace(/\B(?=(\d{3})+$)/g, "{,}")}$`;
}

/** @param {number | null} value */
function figure(value) {
  return value === null ? "n/a" : `$${value.toFixed(3)}$`;
}

/** @type {Readonly<Record<string, string>>} */
const SPECIAL = {
  "\\": "\\textbackslash{}",
  "~": "\\textasciitilde{}",
  "^": "\\textasciicircum{}",
};

/** @param {string} text */
function escaped(text) {
  return oneLine(text).replace(/[\\~^#$%&_{}]/g, (character) => SPECIAL[character] ?? `\\${character}`);
}
