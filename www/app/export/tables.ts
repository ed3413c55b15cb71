// The formats a table can be saved in: those of the command line that are for files.

import { FORMATS, type Format } from "../../shared/formats/index.mjs";

export type TableFormat = Format & { readonly file: NonNullable<Format["file"]> };

export const TABLE_FORMATS: readonly TableFormat[] = Object.values<Format>(FORMATS).filter(
  (format): format is TableFormat => format.file !== undefined,
);

/** Those that heed what is wanted of a table, the paper's own first. */
export const PREVIEWED: readonly TableFormat[] = TABLE_FORMATS.filter(({ isTable }) => isTable).sort(
  (one, other) => Number(other.hasBold ?? false) - Number(one.hasBold ?? false),
);
