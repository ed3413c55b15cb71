// @ts-check
// The formats of results: each makes one text of the reports. Those with an extension are for files,
// and the page offers them.

import { csv } from "./csv.mjs";
import { json } from "./json.mjs";
import { latex } from "./latex.mjs";
import { markdown } from "./markdown.mjs";
import { table } from "./table.mjs";

/**
 * @typedef {object} Format
 * @property {string} title
 * @property {string} what
 * @property {{ readonly type: string, readonly extension: string }} [file]
 * @property {(results: readonly import("./results.mjs").Row[], summaries: readonly import("./measures.mjs").MethodSummary[], wanted?: import("./wanted.mjs").Wanted) => string} write the summaries are the engine's, of the same results
 * @property {boolean} [isTable] whether it heeds what is wanted
 * @property {boolean} [hasBold] whether it can make a figure stand out
 */

/** By the names that `--format` takes. */
export const FORMATS = /** @satisfies {Readonly<Record<string, Format>>} */ ({
  table: { title: "Table", what: "one aligned row per model and method", isTable: true, write: table },
  json: {
    title: "JSON",
    what: "everything, down to each primitive and diagnostic",
    file: { type: "application/json", extension: "json" },
    write: json,
  },
  csv: {
    title: "CSV",
    what: "one row per model and method, for a spreadsheet",
    file: { type: "text/csv", extension: "csv" },
    isTable: true,
    write: csv,
  },
  latex: {
    title: "LaTeX",
    what: "a booktabs table like the paper's",
    file: { type: "application/x-tex", extension: "tex" },
    isTable: true,
    hasBold: true,
    write: latex,
  },
  markdown: {
    title: "Markdown",
    what: "for a README or a discussion",
    file: { type: "text/markdown", extension: "md" },
    isTable: true,
    hasBold: true,
    write: markdown,
  },
});
