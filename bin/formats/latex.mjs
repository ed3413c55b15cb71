// LaTeX: a booktabs table with the columns of the paper's two, ready to be put in.

import { MEASURES, meanOf, methodsOf } from "./measures.mjs";

const HEADINGS = { MFE: "MFE", dHaus: "$d_{\\text{dHaus}}$", d1: "$d_1$" };

export function latex(reports) {
  const columns = ["", "method", "\\# points", "\\# true", "\\# predicted"];
  const head = [...columns, ...MEASURES.map((measure) => HEADINGS[measure] ?? measure)];
  const lines = [
    "% Needs \\usepackage{booktabs} and \\usepackage{amsmath}.",
    `\\begin{tabular}{ll${"r".repeat(head.length - 2)}}`,
    "  \\toprule",
    row(head),
    "  \\midrule",
    ...reports.map((report, index) =>
      row([
        report.model === reports[index - 1]?.model ? "" : escaped(spaced(report.model)),
        escaped(report.method),
        ...[report.points, report.truth, report.predicted].map(whole),
        ...MEASURES.map((measure) => figure(report.mean[measure])),
      ]),
    ),
    ...meanRows(reports),
    "  \\bottomrule",
    "\\end{tabular}",
  ];
  return `${lines.join("\n")}\n`;
}

function meanRows(reports) {
  const rows = methodsOf(reports)
    .map((method) => ({ method, own: reports.filter((report) => report.method === method) }))
    .filter(({ own }) => own.length > 1)
    .map(({ method, own }) =>
      row([
        `Mean of ${own.length}`,
        escaped(method),
        ...["", "", ""],
        ...MEASURES.map((measure) => figure(meanOf(own, measure))),
      ]),
    );
  return rows.length > 0 ? ["  \\midrule", ...rows] : [];
}

function row(cells) {
  return `  ${cells.join(" & ")} \\\\`;
}

/** `PC 14`, as the paper writes it. */
function spaced(model) {
  return model.replace(/^PC(?=\d+$)/, "PC ");
}

function whole(value) {
  return `$${String(value).replace(/\B(?=(\d{3})+$)/g, "{,}")}$`;
}

function figure(value) {
  return value === null ? "n/a" : `$${value.toFixed(3)}$`;
}

const SPECIAL = {
  "\\": "\\textbackslash{}",
  "~": "\\textasciitilde{}",
  "^": "\\textasciicircum{}",
};

function escaped(text) {
  return text.replace(/[\\~^#$%&_{}]/g, (character) => SPECIAL[character] ?? `\\${character}`);
}
