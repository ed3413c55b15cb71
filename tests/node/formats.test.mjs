import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { csv } from "../../www/shared/formats/csv.mjs";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { latex } from "../../www/shared/formats/latex.mjs";
import { markdown } from "../../www/shared/formats/markdown.mjs";
import { scoresOf } from "../../www/shared/formats/measures.mjs";
import { table } from "../../www/shared/formats/table.mjs";
import { fit4cad, folder, submitted } from "./support.mjs";

const MEAN = { DSC: 0.25, PPV: 0.5, TPR: 0.75, TNR: 1, NPV: 1, ACC: 0.125, MFE: 0.001, dHaus: 0.002, d1: null };

/**
 * What the formats look at of a result.
 * @param {object} change
 * @returns {any}
 */
function result(change = {}) {
  const files = [
    { path: "PC1.txt", role: "cloud", sha256: "aa" },
    { path: "PC1_primitives.txt", role: "primitives", sha256: "bb" },
    { path: "MINE/PC1_primitives.txt", role: "primitives", method: "MINE", sha256: "cc" },
  ];
  const report = { model: "PC1", method: "MINE", protocol: "definition", points: 7500, truth: 8, predicted: 9 };
  return { ...report, mean: MEAN, type_errors: 2, engine: "0.1.0", files, ...change };
}

const engine = await loadEngine();

/**
 * A text of a format, with the engine's means.
 * @param {(results: any[], summaries: readonly import("../../bin/engine/engine.js").MethodSummary[]) => string} format
 * @param {any[]} results
 */
const written = (format, results) => format(results, engine.summarise(scoresOf(results)));

test("every export carries the engine's version, the protocol and the hash of each file", (t) => {
  const files = submitted("PC1", "MINE");
  const root = folder(t, files);
  const version = fit4cad("--version").out.trim().split(" ")[1];
  const hashes = Object.values(files).map((text) => createHash("sha256").update(text).digest("hex"));
  for (const format of Object.keys(FORMATS).filter((name) => name !== "table")) {
    const { code, out } = fit4cad("score", root, "--format", format, "--protocol", "published");
    assert.equal(code, 0);
    for (const needed of [version, "published", ...hashes]) {
      assert.ok(out.includes(needed), `${format} lacks ${needed}`);
    }
  }
});

test("CSV has one column per file and keeps what looks like a formula a text", () => {
  for (const start of ["=", "+", "-", "@", "\t", "\r"]) {
    const [head, row] = csv([result({ method: `${start}1,2` })]).split("\r\n");
    assert.ok(row.includes(`"'${start}1,2"`), JSON.stringify(row));
    const columns = head.split(",");
    assert.equal(columns[columns.indexOf("engine") + 1], "cloud_sha256");
    assert.ok(row.endsWith(",0.1.0,aa,bb,,,cc,,"));
  }
});

test("Markdown is a table with aligned figures, the mean of each method and what was read", () => {
  const lines = written(markdown, [result(), result({ model: "PC2", mean: { ...MEAN, DSC: 0.75 } })]).split("\n");
  assert.equal(lines[0].split("|").length, lines[1].split("|").length);
  assert.match(lines[1], /^\| --- \| --- \| ---: \|/);
  assert.match(lines[2], /^\| PC1 \| MINE \| 7500 \| 8 \| 9 \| 0\.2500 \|.*\| n\/a \| 2 \|$/);
  assert.match(lines[4], /^\| \*\*Mean of 2\*\* \| \*\*MINE\*\* \|  \|  \|  \| \*\*0\.5000\*\*/);
  assert.deepEqual(lines.slice(6, 8), ["Fit4CAD engine 0.1.0, protocol definition.", ""]);
  assert.ok(lines.includes("cc  MINE/PC1_primitives.txt"));
});

test("a line end in a name does not split a row of a table", () => {
  const rows = written(table, [result({ model: "PC\n1", method: "MI\r\tNE" })]).trimEnd().split("\n");
  assert.equal(rows.length, 2);
  assert.match(rows[1], /^PC\ufffd1 +MI\ufffd\ufffdNE +7500 /);
});

test("no name can leave its cell, its comment or its line", () => {
  const method = "a|b\n\n```\n<img src=x onerror=alert(1)> [x](javascript:y) \\end{tabular}\u2028";
  const hostile = result({ method, files: [{ path: `x\n\\input{secret}\n\`\`\``, role: "cloud", sha256: null }] });
  const cells = written(markdown, [hostile]).split("\n")[2].split(/(?<!\\)\|/);
  assert.equal(cells.length, written(markdown, [result()]).split("\n")[2].split("|").length);
  assert.match(cells[2], /\\<img src=x onerror=alert\\\(1\\\)\\>/);
  assert.ok(written(markdown, [hostile]).endsWith("\n(not hashed)  x\ufffd\\input{secret}\ufffd```\n```\n"));
  const comments = written(latex, [hostile]).split("\n");
  assert.ok(comments.includes("% (not hashed)  x\ufffd\\input{secret}\ufffd```"));
  assert.ok(!comments.some((line) => line.startsWith("\\input")));
});

test("means leave out the models that lack a measure, and are n/a where all do", () => {
  const results = [result(), result({ model: "PC2", mean: { ...MEAN, DSC: null } }), result({ method: "THEIRS" })];
  const [mine, theirs] = engine.summarise(scoresOf(results));
  assert.deepEqual([mine.method, mine.models, mine.typeErrors], ["MINE", 2, 4]);
  assert.deepEqual([mine.over.DSC?.mean, mine.over.DSC?.count, mine.over.PPV?.count], [0.25, 1, 2]);
  assert.equal(mine.over.d1, undefined);
  assert.equal(theirs.models, 1);
  const last = (written(table, results).trimEnd().split("\n").at(-1) ?? "").split(/ {2,}/);
  assert.deepEqual(last.slice(0, 3), ["mean of 2", "MINE", "0.2500"]);
  assert.deepEqual(last.slice(-2), ["n/a", "4"]);
});
