import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { csv } from "../../www/shared/formats/csv.mjs";
import { FORMATS } from "../../www/shared/formats/index.mjs";
import { latex } from "../../www/shared/formats/latex.mjs";
import { markdown } from "../../www/shared/formats/markdown.mjs";
import { MEASURES, scoresOf } from "../../www/shared/formats/measures.mjs";
import { withPublished } from "../../www/shared/formats/published-rows.mjs";
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

/**
 * The same, of what is wanted alone.
 * @param {(results: any[], summaries: readonly import("../../bin/engine/engine.js").MethodSummary[], wanted: import("../../www/shared/formats/wanted.mjs").Wanted) => string} format
 * @param {any[]} results
 * @param {Partial<import("../../www/shared/formats/wanted.mjs").Wanted>} change
 */
const asked = (format, results, change) => format(results, engine.summarise(scoresOf(results)), { means: false, measures: MEASURES, bold: false, ...change });

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
    assert.ok(row.endsWith(",0.1.0,aa,bb,,,,cc,,,"));
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

test("the best of a model, and the best mean, is bold by what the measure declares; what reads alike is alike", () => {
  const theirs = { method: "THEIRS", mean: { ...MEAN, DSC: 0.5, MFE: 0.0011, TNR: 0.99999 } };
  const results = [result(), result(theirs), result({ model: "PC2" }), result({ ...theirs, model: "PC2" })];
  const lines = asked(latex, results, { bold: true, measures: ["DSC", "TNR", "MFE", "d1"] }).split("\n");
  assert.ok(lines.includes("  PC 1 & MINE & $7{,}500$ & $8$ & $9$ & $0.250$ & $\\mathbf{1.000}$ & $\\mathbf{0.001}$ & n/a \\\\"));
  assert.ok(lines.includes("   & THEIRS & $7{,}500$ & $8$ & $9$ & $\\mathbf{0.500}$ & $\\mathbf{1.000}$ & $\\mathbf{0.001}$ & n/a \\\\"));
  assert.ok(lines.includes("  Mean of 2 & THEIRS &  &  &  & $\\mathbf{0.500}$ & $\\mathbf{1.000}$ & $\\mathbf{0.001}$ & n/a \\\\"));
  const more = asked(markdown, results, { bold: true, measures: ["DSC", "MFE"] }).split("\n");
  assert.equal(more[2], "| PC1 | MINE | 7500 | 8 | 9 | 0.2500 | **0.0010** | 2 |");
  assert.equal(more[3], "| PC1 | THEIRS | 7500 | 8 | 9 | **0.5000** | 0.0011 | 2 |");
  assert.equal(more[6], "| Mean of 2 | MINE |  |  |  | 0.2500 | **0.0010** | 4 |");
  // One method alone is no best.
  assert.ok(!asked(latex, [result()], { bold: true }).includes("mathbf"));
});

test("means alone are of every method, also of a single model", () => {
  const results = [result(), result({ model: "PC2" }), result({ method: "THEIRS" })];
  const chosen = { means: true, measures: /** @type {const} */ (["DSC", "MFE"]), digits: 2 };
  assert.deepEqual(asked(csv, results, { ...chosen, digits: undefined }).split("\r\n").slice(0, 3), [
    "method,protocol,models,DSC,MFE,type_errors,engine",
    "MINE,definition,2,0.25,0.001,4,0.1.0",
    "THEIRS,definition,1,0.25,0.001,2,0.1.0",
  ]);
  assert.deepEqual(asked(markdown, results, chosen).split("\n").slice(0, 3), [
    "| Method | Models | DSC | MFE | Type errors |",
    "| --- | ---: | ---: | ---: | ---: |",
    "| MINE | 2 | 0.25 | 1.0e-3 | 4 |",
  ]);
  assert.equal(asked(table, results, chosen), "method  models   DSC   MFE  type errors\nMINE         2  0.25  0.00            4\nTHEIRS       1  0.25  0.00            2\n");
  const lines = asked(latex, results, chosen).split("\n");
  assert.ok(lines.includes("\\begin{tabular}{lrrr}"));
  assert.ok(lines.includes("  MINE & $2$ & $0.25$ & $1.0\\times10^{-3}$ \\\\"));
});

test("what so many digits would show as nought is a power of ten, and nought stays nought", () => {
  const small = result({ mean: { ...MEAN, MFE: 0.0000321, dHaus: 0, d1: -0.0004 } });
  assert.match(written(latex, [small]), /\$3\.2\\times10\^\{-5\}\$ & \$0\.000\$ & \$-4\.0\\times10\^\{-4\}\$/);
  assert.match(asked(markdown, [small], { digits: 5 }), /\| 0\.00003 \| 0\.00000 \| -0\.00040 \|/);
  assert.match(asked(csv, [small], { digits: 4 }), /,3\.2e-5,0\.0000,-0\.0004,/);
});

test("a LaTeX table of more rows than a page has goes on over pages, its head on each", () => {
  const results = Array.from({ length: 41 }, (_, at) => result({ model: `PC${at}` }));
  const lines = written(latex, results.slice(0, 39)).split("\n");
  assert.ok(lines.includes("\\end{tabular}") && !lines[0]?.includes("longtable"));
  const long = written(latex, results).split("\n");
  assert.match(long[0] ?? "", /\\usepackage\{longtable\}/);
  const start = long.indexOf("\\begin{longtable}{llrrrrrrrrrrrr}");
  assert.equal(long[start + 1], "  \\toprule");
  assert.deepEqual(long.slice(start + 3, start + 7), ["  \\midrule", "  \\endhead", "  \\bottomrule", "  \\endfoot"]);
  assert.deepEqual(long.slice(-4, -2), ["  \\midrule", long.at(-3)]);
  assert.equal(long.at(-2), "\\end{longtable}");
});

test("the published methods stand beside what was found on a test model, and on no other", () => {
  const rows = withPublished([result(), result({ method: "HT (published)" }), result({ model: "PC2" })]);
  assert.deepEqual(rows.map(({ model, method }) => [model, method]), [
    ["PC1", "MINE"],
    ["PC1", "HT (published)"],
    // No name is given twice.
    ["PC1", "HT (published)*"],
    ["PC1", "PG (published)"],
    // Named like a test model, but of other points.
    ["PC2", "MINE"],
  ]);
  const published = withPublished([result()]);
  const text = written(markdown, published);
  assert.match(text, /\| PC1 \| HT \\\(published\\\) \| 7500 \| 8 \|  \| 0\.9866 \|.*\|  \|\n/);
  assert.match(text, /\| PC1 \| PG \\\(published\\\) .* n\/a \| n\/a \| n\/a \|  \|\n/);
  assert.match(text, /HT \\\(published\\\)\\: the published result files, scored by protocol definition\.\n/);
  assert.match(asked(csv, published, { means: true, measures: ["DSC"] }), /\r\nHT \(published\),definition,1,0\.986624,,\r\n/);
});

test("the command line heeds what is wanted of a table, and says where it cannot", (t) => {
  const root = folder(t, submitted("PC1", "MINE"));
  const { code, out } = fit4cad("score", root, "--means", "--measures", "DSC,MFE", "--digits", "2", "--format", "markdown");
  assert.equal(code, 0);
  assert.match(out, /^\| Method \| Models \| DSC \| MFE \| Type errors \|\n.*\n\| MINE \| 1 \| \d\.\d\d \|/);
  for (const [args, said] of /** @type {[string[], RegExp][]} */ ([
    [["--bold"], /--bold: for --format latex or markdown; table has no bold figures/],
    [["--means", "--digits", "2", "--json"], /--means, --digits: for tables; --format json has everything/],
    [["--digits", "13"], /--digits 13: expected a whole number from 0 to 12/],
    [["--measures", "DSC,residual"], /--measures residual: expected DSC, /],
    [["--protocol", "spfn", "--means"], /--means: for the benchmark's own measures/],
  ])) {
    const failed = fit4cad("score", root, ...args);
    assert.equal(failed.code, 2);
    assert.match(`${failed.err}${failed.out}`, said);
  }
  assert.match(fit4cad("score", root, "--published").err, /--published adds nothing: no model is one of the 35 test models/);
});
