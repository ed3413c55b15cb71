// The formats a table can be saved in: those of the command line that are for files.

import { FORMATS, type Format } from "../../shared/formats/index.mjs";

export type TableFormat = Format & { readonly file: NonNullable<Format["file"]> };

export const TABLE_FORMATS: readonly TableFormat[] = Object.values<Format>(FORMATS).filter(
  (format): format is TableFormat => format.file !== undefined,
);
