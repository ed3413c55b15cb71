// @ts-check
// Tables of figures with heads of their own, in the text formats.

import { oneLine } from "../text.mjs";
import { align } from "./align.mjs";
import { csvText, guarded } from "./csv.mjs";
import { escapedMarkdown } from "./markdown.mjs";
import { escapedLatex } from "./latex.mjs";

/**
 * @typedef {{ title: string, decimals: number, scientific?: boolean }} Column
 * @typedef {{ labels: readonly string[], values: readonly (number | null)[] }} Row
 * @typedef {{ caption: string, heads: readonly string[], columns: readonly Column[], rows: readonly Row[] }} Sheet
 * @typedef {{ sheets: readonly Sheet[], notes: readonly string[] }} Sheets what is to be said with them: where the figures come from
 */

/** By the names that `--format` takes; JSON is no table. */
export const SHEET_FORMATS = /** @type {const} */ ({ table, csv, latex, markdown });

/**
 * @param {number | null | undefined} value
 * @param {Column} column
 */
function figure(value, { decimals, scientific }) {
  if (value === null || value === undefined) {
    return "n/a";
  }
  return scientific === true ? value.toExponential(decimals) : value.toFixed(decimals);
}

/**
 * @param {Sheet} sheet
 * @param {(row: Row) => string[]} cells
 */
function rowsOf({ rows }, cells) {
  return rows.map(cells);
}

/** @param {Sheets} sheets */
function table({ sheets }) {
  const texts = sheets.map((sheet) => {
    const head = [...sheet.heads, ...sheet.columns.map(({ title }) => title)];
    const rows = rowsOf(sheet, ({ labels, values }) => [
      ...labels,
      ...sheet.columns.map((column, at) => figure(values[at], column)),
    ]);
    return `${sheets.length > 1 ? `${sheet.caption}\n` : ""}${align([head, ...rows], sheet.heads.length)}\n`;
  });
  return texts.join("\n");
}

/**
 * One table after another, told apart by their first column; figures unrounded.
 * @param {Sheets} sheets
 */
function csv({ sheets, notes }) {
  const texts = sheets.map((sheet) =>
    csvText([
      ["table", ...sheet.heads, ...sheet.columns.map(({ title }) => title), "provenance"],
      ...sheet.rows.map(({ labels, values }) => [
        ...[sheet.caption, ...labels].map(guarded),
        ...sheet.columns.map((_, at) => values[at] ?? ""),
        guarded(notes[0] ?? ""),
      ]),
    ]),
  );
  return texts.join("\r\n");
}

/** @param {Sheets} sheets */
function markdown({ sheets, notes }) {
  /** @param {readonly string[]} cells */
  const row = (cells) => `| ${cells.join(" | ")} |`;
  const tables = sheets.flatMap((sheet) => [
    ...(sheets.length > 1 ? [`**${escapedMarkdown(sheet.caption)}**`, ""] : []),
    row([...sheet.heads, ...sheet.columns.map(({ title }) => escapedMarkdown(title))]),
    row([...sheet.heads.map(() => "---"), ...sheet.columns.map(() => "---:")]),
    ...rowsOf(sheet, ({ labels, values }) => [
      ...labels.map(escapedMarkdown),
      ...sheet.columns.map((column, at) => figure(values[at], column)),
    ]).map(row),
    "",
  ]);
  return `${[...tables, "```text", ...notes.map(oneLine), "```"].join("\n")}\n`;
}

/** @param {Sheets} sheets */
function latex({ sheets, notes }) {
  /** @param {readonly string[]} cells */
  const row = (cells) => `  ${cells.join(" & ")} \\\\`;
  const tables = sheets.flatMap((sheet) => [
    `% ${oneLine(sheet.caption)}`,
    `\\begin{tabular}{${"l".repeat(sheet.heads.length)}${"r".repeat(sheet.columns.length)}}`,
    "  \\toprule",
    row([...sheet.heads, ...sheet.columns.map(({ title }) => title)].map(escapedLatex)),
    "  \\midrule",
    ...rowsOf(sheet, ({ labels, values }) => [
      ...labels.map(escapedLatex),
      ...sheet.columns.map((column, at) => (typeof values[at] === "number" ? `$${figure(values[at], column)}$` : "n/a")),
    ]).map(row),
    "  \\bottomrule",
    "\\end{tabular}",
  ]);
  const head = ["% Needs \\usepackage{booktabs}.", ...notes.map((note) => `% ${oneLine(note)}`)];
  return `${[...head, ...tables].join("\n")}\n`;
}
