// Columns for the eye.

import { printable } from "../cli/terminal.mjs";

/** Rows of cells as lines: the first `textColumns` to the left, figures to the right. */
export function align(rows, textColumns) {
  const clean = rows.map((row) => row.map(printable));
  const widths = clean[0].map((_, column) => clean.reduce((most, row) => Math.max(most, row[column].length), 0));
  const cell = (text, column) =>
    column < textColumns ? text.padEnd(widths[column]) : text.padStart(widths[column]);
  return clean.map((row) => row.map(cell).join("  ").trimEnd()).join("\n");
}
