// @ts-check
// LaTeX: a booktabs table with the columns of the paper's two, ready to be put in.

import { oneLine } from "../text.mjs";
import { MEASURES as DECLARED } from "../../generated/declared/measures.js";
import { LONG, figure, linesOf } from "./lines.mjs";
import { checksums, provenance } from "./results.mjs";
import { USUAL } from "./wanted.mjs";

/** @typedef {import("./lines.mjs").Line} Line */
/** @typedef {import("../../generated/engine/engine.js").Term} Term */

const DIGITS = 3;

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
 * @param {readonly import("./results.mjs").Row[]} results
 * @param {readonly import("./measures.mjs").MethodSummary[]} summaries the engine's, of the same results
 * @param {import("./wanted.mjs").Wanted} [wanted]
 */
export function latex(results, summaries, wanted = USUAL) {
  const { means: short, measures, digits = DIGITS } = wanted;
  const { models, means } = linesOf(results, summaries, wanted, (value) => figure(value, digits));
  const columns = short ? ["method", "\\# models"] : ["", "method", "\\# points", "\\# true", "\\# predicted"];
  const head = row([...columns, ...DECLARED.filter(({ key }) => measures.includes(key)).map(({ symbol }) => heading(symbol))]);
  const layout = `${short ? "lr" : "llrrr"}${"r".repeat(measures.length)}`;
  const isLong = models.length + means.length > LONG;
  const body = [
    ...models.map((line, at) => row(cells(line, models[at - 1]?.model))),
    ...(models.length > 0 && means.length > 0 ? ["  \\midrule"] : []),
    ...means.map((line) => row(cells(line, short ? undefined : ""))),
  ];
  const packages = ["booktabs", ...(isLong ? ["longtable"] : []), "amsmath"].map((name) => `\\usepackage{${name}}`);
  const lines = [
    `% Needs ${packages.slice(0, -1).join(", ")} and ${packages.at(-1)}.`,
    ...[...provenance(results), ...checksums(results)].map((line) => `% ${line}`),
    ...(isLong ? longTable(layout, head, body) : shortTable(layout, head, body)),
  ];
  return `${lines.join("\n")}\n`;
}

/**
 * @param {string} layout
 * @param {string} head
 * @param {readonly string[]} body
 */
function shortTable(layout, head, body) {
  return [`\\begin{tabular}{${layout}}`, "  \\toprule", head, "  \\midrule", ...body, "  \\bottomrule", "\\end{tabular}"];
}

/**
 * A table that goes on over pages, its head on each.
 * @param {string} layout
 * @param {string} head
 * @param {readonly string[]} body
 */
function longTable(layout, head, body) {
  const everyPage = ["  \\toprule", head, "  \\midrule", "  \\endhead", "  \\bottomrule", "  \\endfoot"];
  return [`\\begin{longtable}{${layout}}`, ...everyPage, ...body, "\\end{longtable}"];
}

/**
 * @param {Line} line
 * @param {string | undefined} above the model of the line before
 */
function cells({ model, models, method, counts, figures }, above) {
  const called = escapedLatex(method);
  const labels = counts
    ? [model === above ? "" : escapedLatex(spaced(model)), called, ...counts.map((count) => (count === null ? "" : whole(count)))]
    : above === undefined
      ? [called, whole(models)]
      : [`Mean of ${models}`, called, "", "", ""];
  return [...labels, ...figures.map(written)];
}

/** @param {readonly string[]} texts */
function row(texts) {
  return `  ${texts.join(" & ")} \\\\`;
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

/** @param {import("./lines.mjs").Cell} cell */
function written({ text, best }) {
  if (text === "n/a") {
    return text;
  }
  const number = text.replace(/e([+-])(\d+)$/, (_, sign, power) => `\\times10^{${sign === "-" ? "-" : ""}${power}}`);
  return best ? `$\\mathbf{${number}}$` : `$${number}$`;
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
