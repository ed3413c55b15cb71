// The formats of `--format`: each makes one text of the reports.

import { csv } from "./csv.mjs";
import { json } from "./json.mjs";
import { latex } from "./latex.mjs";
import { markdown } from "./markdown.mjs";
import { table } from "./table.mjs";

export const FORMATS = { table, json, csv, latex, markdown };
