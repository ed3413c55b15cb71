// The kinds of files that are declared, in what is written by hand.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT } from "../../scripts/lib/paths.mjs";
import { FILE_KINDS } from "../../www/generated/declared/file-kinds.js";

const readme = readFileSync(join(ROOT, "README.md"), "utf8");
const ofPython = readFileSync(join(ROOT, "crate/python/README.md"), "utf8").toLowerCase();

test("both READMEs name every kind of file that is read", () => {
  for (const { endings, title } of FILE_KINDS) {
    assert.ok(readme.includes(`\`.${endings[0]}\``), `README.md does not name .${endings[0]}`);
    // Labelled rows are rows and labels.
    const words = title === "Labelled rows" ? ["rows", "labels"] : [title.toLowerCase()];
    for (const word of words) assert.ok(ofPython.includes(word), `crate/python/README.md does not name ${title}`);
  }
});
