// @ts-check
// LaTeX: a booktabs table with the columns of the paper's two, ready to be put in.

import { oneLine } from "../text.mjs";
import { MEASURES as DECLARED } from "../../generated/declared/measures.js";
import { MEASURES, meanOf, ofSeveral } from "./measures.mjs";
import { checksums, provenance } from "./results.mjs";

/** @typedef {import("./measures.mjs").MethodSummary} MethodSummary */
/** @typedef {import("./results.mjs").Result} Result */

/** @typedef {import("../../generated/engine/engine.js").Term} Term */

/**
 * The symbol of a measure, in text: a name of several letters needs no formula.
 * @param {Term} symbol
 */
function heading(symbol) {
  return symbol.kind === "word" ? escapedLatex(symbol.text) : `$${formula(symbol)}$`;
}

/**
 * A term in mathematical mode.
 * @param {Term} term
 * @returns {string}
 */
function formula(term) {
  switch (term.kind) {
    case "word":
      return `\\text{${escapedLatex(term.text)}}`;
    case "variable":
    case "number":
    case "operator":
      return term.text;
    case "row":
      return term.terms.map(formula).join(" ");
    case "fraction":
      return `\\frac{${formula(term.over)}}{${formula(term.under)}}`;
    case "sub":
      return `${formula(term.base)}_${grouped(formula(term.index))}`;
    case "under":
      return `${formula(term.operator)}_${grouped(formula(term.range))}`;
  }
}

/** @param {string} text */
function grouped(text) {
  return text.length === 1 ? text : `{${text}}`;
}

/**
 * @param {readonly Result[]} results
 * @param {readonly MethodSummary[]} summaries the engine's, of the same reports
 */
export function latex(results, summaries) {
  const columns = ["", "method", "\\# points", "\\# true", "\\# predicted"];
  const head = [...columns, ...DECLARED.map(({ symbol }) => heading(symbol))];
  const lines = [
    "% Needs \\usepackage{booktabs} and \\usepackage{amsmath}.",
    ...[...provenance(results), ...checksums(results)].map((line) => `% ${line}`),
    `\\begin{tabular}{ll${"r".repeat(head.length - 2)}}`,
    "  \\toprule",
    row(head),
    "  \\midrule",
    ...results.map((report, index) =>
      row([
        report.model === results[index - 1]?.model ? "" : escapedLatex(spaced(report.model)),
        escapedLatex(report.method),
        ...[report.points, report.truth, report.predicted].map(whole),
        ...MEASURES.map((measure) => figure(report.mean[measure])),
      ]),
    ),
    ...meanRows(summaries),
    "  \\bottomrule",
    "\\end{tabular}",
  ];
  return `${lines.join("\n")}\n`;
}

/** @param {readonly MethodSummary[]} summaries */
function meanRows(summaries) {
  const rows = ofSeveral(summaries).map((summary) =>
    row([
      `Mean of ${summary.models}`,
      escapedLatex(summary.method),
      ...["", "", ""],
      ...MEASURES.map((measure) => figure(meanOf(summary, measure))),
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
export function escapedLatex(text) {
  return oneLine(text).replace(/[\\~^#$%&_{}]/g, (character) => SPECIAL[character] ?? `\\${character}`);
}
