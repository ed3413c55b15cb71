// @ts-check
// Columns for the eye.

import { oneLine } from "../text.mjs";

/**
 * Rows of cells as lines: the first `textColumns` to the left, figures to the right.
 * @param {readonly (readonly string[])[]} rows all of one length
 * @param {number} textColumns
 */
export function align(rows, textColumns) {
  const clean = rows.map((row) => row.map(oneLine));
  /** @type {number[]} */
  const widths = [];
  for (const row of clean) {
    for (const [column, { length }] of row.entries()) {
      widths[column] = Math.max(widths[column] ?? 0, length);
    }
  }
  /** @param {string} text @param {number} column */
  const cell = (text, column) => {
    const width = widths[column] ?? 0;
    return column < textColumns ? text.padEnd(width) : text.padStart(width);
  };
  return clean.map((row) => row.map(cell).join("  ").trimEnd()).join("\n");
}
