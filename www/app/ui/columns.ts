// The usual columns of tables: words and whole numbers.

import * as format from "./format";
import type { Column } from "./table";

interface Words {
  /** The head in words; in small letters the head itself unless given. */
  readonly label?: string;
  /** Shown where there is nothing, which sorts last. */
  readonly missing?: string;
}

export function words<Row>(
  id: string,
  head: string,
  of: (row: Row) => string | null | undefined,
  { label = head.toLowerCase(), missing }: Words = {},
): Column<Row> {
  return { id, head, label, cell: (row) => of(row) ?? missing, sortBy: of };
}

export function count<Row>(
  id: string,
  head: string,
  of: (row: Row) => number | null | undefined,
  { label = head.toLowerCase(), missing }: Words = {},
): Column<Row> {
  const cell = (row: Row) => {
    const value = of(row);
    return value === null || value === undefined ? missing : format.integer(value);
  };
  return { id, head, label, numeric: true, cell, sortBy: of };
}
