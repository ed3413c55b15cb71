// Inputs and surroundings that are against the command line: nothing is lost, and all is said.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { closeSync, mkdirSync, openSync, readFileSync, readdirSync, truncateSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { strToU8, zipSync } from "fflate";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { eachModel } from "../../bin/cli/models.mjs";
import { memory } from "../../www/shared/zip/source.mjs";
import { pageModule } from "./page.mjs";
import { COMMAND, fit4cad, folder, submitted, twoPlanes } from "./support.mjs";

/** @typedef {import("../../bin/cli/fitting.mjs").Fitted} Fitted */
/** @typedef {import("../../www/shared/formats/results.mjs").Result} Result */

const { unzipped } = await pageModule("../worker/unzipped.ts");

/** The files as a zip whose first byte of the first content is another than its checksum says. */
function damaged() {
  const files = Object.entries(submitted("PC1", "HT", "PG"));
  const zip = zipSync(Object.fromEntries(files.map(([path, text]) => [path, strToU8(text)])), { level: 0 });
  const entry = Buffer.from(zip).indexOf("pointCloud_primitives_HT");
  zip[Buffer.from(zip).indexOf("Primitive1", entry) + 1] ^= 1;
  return zip;
}

test("a damaged entry of a zip is told, and the other results are scored", (t) => {
  const root = folder(t, { "results.zip": damaged() });
  const { code, out, err } = fit4cad("score", root, "--json");
  assert.equal(code, 1);
  /** @type {Result[]} */
  const reports = JSON.parse(out);
  assert.deepEqual(reports.map(({ method }) => method), ["PG"]);
  assert.match(err, /results\.zip\/pointCloud_primitives_HT\/PC1_primitives\.txt: error: .*its checksum is not that/);
});

test("the page says the same of that entry, and takes the others", () => {
  const { files, refused } = unzipped("results.zip", memory(damaged()));
  assert.equal(files.length, Object.keys(submitted("PC1", "HT", "PG")).length - 1);
  assert.deepEqual(refused, [
    {
      path: "results.zip/pointCloud_primitives_HT/PC1_primitives.txt",
      reason: "It is damaged: its checksum is not that of the zip's directory.",
    },
  ]);
  const none = unzipped("none.zip", memory(strToU8("none")));
  assert.match(none.refused[0].reason, /^The zip could not be opened: it is no zip/);
});

test("names that no file can have become names that one can, each its own", (t) => {
  const { "PC1.txt": cloud } = twoPlanes("PC1");
  const long = "A".repeat(300);
  const names = ["a\0b.txt", "a\u0001b.txt", `${long}.txt`, `${long}B.txt`, "z.txt"];
  const zip = zipSync(Object.fromEntries(names.map((name) => [name, strToU8(cloud)])));
  const root = folder(t, { "names.zip": zip });
  const { code, out } = fit4cad("fit", "--method", "ht", "--json", "--out", join(root, "out"), root);
  assert.equal(code, 0);
  /** @type {Fitted[]} */
  const models = JSON.parse(out);
  assert.deepEqual(models.filter(({ error }) => error !== undefined), []);
  assert.deepEqual(models.map(({ model }) => `${model}.txt`).sort(), [...names].sort());
  const written = readdirSync(join(root, "out/pointCloud_primitives_HT")).sort();
  assert.equal(written.length, names.length);
  assert.deepEqual(written.map((name) => name.replace(/-[0-9a-f]{8}_/, "-…_").replace(/A{9,}/, "A…")), [
    "A…-…_primitives.txt",
    "A…-…_primitives.txt",
    "a_b-…_primitives.txt",
    "a_b-…_primitives.txt",
    "z_primitives.txt",
  ]);
});

test("with --json a failure is JSON too", (t) => {
  const root = folder(t, { ...twoPlanes("PC1"), taken: "a file" });
  const calls = [
    { args: ["fit", "--method", "ht", "--out", join(root, "taken"), root, "--json"], code: 1, expected: /could not be written: a part of its path is a file/ },
    { args: ["check", "--write", join(root, "taken/in"), root, "--format", "json"], code: 1, expected: /could not be written/ },
    { args: ["fit", "--json", root], code: 2, expected: /--method ht or --method pg/ },
    { args: ["score", "--json"], code: 2, expected: /at least one file/ },
    { args: ["score", root, "--format=json", "--protocol", "mine"], code: 2, expected: /expected definition, published/ },
    { args: ["stats", root, "--json", "--colour"], code: 2, expected: /--colour/ },
    { args: ["scroe", root, "--json"], code: 2, expected: /no command "scroe"/ },
  ];
  for (const { args, code, expected } of calls) {
    const ran = fit4cad(...args);
    assert.equal(ran.code, code, args.join(" "));
    assert.match(JSON.parse(ran.out).error, expected);
    assert.match(ran.err, expected);
  }
});

test("a reader that has gone does not keep files from being written", async (t) => {
  const out = join(folder(t, {}), "out");
  const args = [COMMAND, "generate", "flange", "--imperfect", "--spacing", "0.03", "--out", out];
  const child = spawn(process.execPath, args, { stdio: ["ignore", "pipe", "inherit"] });
  child.stdout.destroy();
  const code = await new Promise((done) => child.on("close", done));
  assert.equal(code, 0);
  assert.equal(readdirSync(out).length + readdirSync(join(out, "Imperfect")).length, 4 + 1 + 3);
});

test("a folder that takes nothing, a file in the way and a full disk are told at once", (t) => {
  const root = folder(t, { "PC1.txt": twoPlanes("PC1")["PC1.txt"] });
  const write = (/** @type {string} */ out) => fit4cad("generate", "flange", "--spacing", "0.1", "--out", out);
  const inTheWay = write(join(root, "PC1.txt/out"));
  assert.equal(inTheWay.code, 1);
  assert.match(inTheWay.err, /PC1\.txt.*could not be written: a part of its path is a file/);
  if (process.platform !== "linux") {
    t.diagnostic("/proc and /dev/full, which take nothing, are Linux's");
    return;
  }
  // Node's own way of making folders never comes back from there.
  const { code, err } = write("/proc/nowhere");
  assert.equal(code, 1);
  assert.match(err, /\/proc\/nowhere\/flange\.txt could not be written: /);
  const full = openSync("/dev/full", "w");
  const printed = spawnSync(process.execPath, [COMMAND, "check", root], { stdio: ["ignore", full, "pipe"], encoding: "utf8" });
  closeSync(full);
  assert.equal(printed.status, 1);
  assert.match(printed.stderr, /the result could not be printed: the disk is full/);
});

test("a file is written whole or not at all", (t) => {
  const root = folder(t, { "PC1.txt": twoPlanes("PC1")["PC1.txt"] });
  const at = join(root, "out/pointCloud_parametric_HT/PC1_parametric.txt");
  // What is there cannot be replaced.
  mkdirSync(join(at, "in the way"), { recursive: true });
  const { code, out } = fit4cad("fit", "--method", "ht", "--json", "--out", join(root, "out"), join(root, "PC1.txt"));
  assert.equal(code, 1);
  assert.match(JSON.parse(out)[0].error, /PC1_parametric\.txt could not be written: it is a folder|not empty/);
  assert.deepEqual(readdirSync(join(root, "out/pointCloud_parametric_HT")), ["PC1_parametric.txt"]);
  assert.match(readFileSync(join(root, "out/pointCloud_primitives_HT/PC1_primitives.txt"), "utf8"), /^Primitive1/);
});

test("files too large for a model are refused by their sizes, and the other models are scored", (t) => {
  const files = submitted("PC2", "HT");
  const root = folder(t, { ...submitted("PC1", "HT"), ...files });
  for (const path of ["pointCloud/PC1.txt", "pointCloud_primitives/PC1_primitives.txt"]) {
    // Holes: on the disk they take nothing, in memory they would.
    truncateSync(join(root, path), 1000 * 2 ** 20);
  }
  const { code, out, err } = fit4cad("score", root, "--json");
  assert.equal(code, 1);
  /** @type {Result[]} */
  const reports = JSON.parse(out);
  assert.deepEqual(reports.map(({ model, mean }) => [model, mean.DSC]), [["PC2", 1]]);
  assert.match(err, /pointCloud\/PC1\.txt: error: The file is too large and was not read \(found 1000 MiB, expected at most 512 MiB\)/);
});

test("a model that stops the engine leaves the others theirs, in a fresh one", async () => {
  const real = await loadEngine();
  const stopping = {
    ...real,
    Model: { read: () => { throw new WebAssembly.RuntimeError("unreachable"); } },
  };
  const files = ["PC1", "PC2", "PC3"].flatMap((name) =>
    Object.entries(twoPlanes(name)).map(([path, text]) => ({ path, size: text.length, read: () => strToU8(text) })),
  );
  /** @type {string[]} */
  const seen = [];
  const { diagnostics } = await eachModel(/** @type {any} */ (stopping), files, {}, (model) => {
    seen.push(model.info().name);
  });
  assert.deepEqual(seen, ["PC2", "PC3"]);
  assert.deepEqual(diagnostics.map(({ file, message }) => [file, message]), [
    ["PC1", "the engine ran out of memory, or failed, on this model"],
  ]);
});

/** A cloud's text with a row before the first that cannot be read. @param {string} text @param {string} row */
const withRow = (text, row) => text.replace("[", `[\n${row},`);

for (const method of ["ht", "pg"]) {
  test(`points keep the numbers of their file through a fit by ${method}, whatever rows cannot be read`, (t) => {
    const root = folder(t, {});
    fit4cad("generate", "bracket", "--spacing", "0.03", "--out", root);
    const cloud = readFileSync(join(root, "bracket.txt"), "utf8");
    const truth = readFileSync(join(root, "bracket_primitives.txt"), "utf8");
    const scored = () => {
      const out = join(root, `found-${method}`);
      fit4cad("fit", "--method", method, "--out", out, join(root, "bracket.txt"));
      /** @type {Result[]} */
      const [report] = JSON.parse(fit4cad("score", root, "--json").out);
      return report.mean.DSC;
    };
    const whole = scored();
    assert.ok(whole !== null && whole > 0.5);
    writeFileSync(join(root, "bracket.txt"), withRow(withRow(cloud, "[NaN, NaN, NaN]"), "[1, 2]"));
    const shifted = truth.replace(/(?<=[[ ])\d+/g, (number) => String(Number(number) + 2));
    writeFileSync(join(root, "bracket_primitives.txt"), shifted);
    assert.equal(scored(), whole);
  });
}
