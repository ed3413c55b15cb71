// The formats a table can be saved in: those of the command line, one and the same.

import { csv } from "../../../bin/formats/csv.mjs";
import { json } from "../../../bin/formats/json.mjs";
import { latex } from "../../../bin/formats/latex.mjs";
import { markdown } from "../../../bin/formats/markdown.mjs";
import type { Result } from "../../../bin/formats/results.mjs";

export interface TableFormat {
  readonly id: string;
  readonly title: string;
  readonly what: string;
  readonly type: string;
  readonly extension: string;
  readonly write: (results: readonly Result[]) => string;
}

export const TABLE_FORMATS: readonly TableFormat[] = [
  { id: "csv", title: "CSV", what: "one row per model and method, for a spreadsheet", type: "text/csv", extension: "csv", write: csv },
  { id: "json", title: "JSON", what: "everything, down to each primitive and diagnostic", type: "application/json", extension: "json", write: json },
  { id: "latex", title: "LaTeX", what: "a booktabs table like the paper's", type: "application/x-tex", extension: "tex", write: latex },
  { id: "markdown", title: "Markdown", what: "for a README or a discussion", type: "text/markdown", extension: "md", write: markdown },
];
