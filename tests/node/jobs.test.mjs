// `--jobs`: the same answers from any number of threads.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative } from "node:path";
import { after, before, test } from "node:test";
import { fit4cad } from "./support.mjs";

const ROOT = mkdtempSync(join(tmpdir(), "fit4cad-jobs-"));
const SET = join(ROOT, "set");
const PARTS = ["flange", "bracket", "shaft", "ball-joint", "plate", "knob"];

before(() => {
  for (const [at, part] of PARTS.entries()) {
    const { code, err } = fit4cad("generate", part, "--spacing", "0.02", "--imperfect", "--name", `PC${at + 1}`, "--out", SET);
    assert.equal(code, 0, err);
  }
  // One that is broken in the middle, and one that is no model at all.
  const lists = join(SET, "PC3_primitives.txt");
  writeFileSync(lists, readFileSync(lists, "utf8").replace("Primitive2:=[", "Primitive2:=[99999999,"));
  writeFileSync(join(SET, "PC77_parametric.txt"), "Primitive1:=[Plane, [1 2]];\n");
});

after(() => rmSync(ROOT, { recursive: true, force: true }));

/** @param {string} folder */
function contents(folder) {
  return readdirSync(folder, { recursive: true, encoding: "utf8" })
    .map((path) => join(folder, path))
    .filter((path) => statSync(path).isFile())
    .sort()
    .map((path) => [relative(folder, path), readFileSync(path, "utf8")]);
}

for (const asked of [["--json"], ["--self"], ["--protocol", "all", "--measures", "all", "--format", "csv"]]) {
  test(`score ${asked.join(" ")} says the same by one thread and by three, of what is wrong too`, () => {
    const alone = fit4cad("score", SET, ...asked);
    assert.match(alone.err + alone.out, /99999999/);
    assert.deepEqual(fit4cad("score", SET, ...asked, "--jobs", "3"), alone);
    assert.deepEqual(fit4cad("score", SET, ...asked, "--jobs", "0"), alone);
  });
}

test("fit finds and writes the same, in the order of the models", () => {
  const run = (/** @type {string[]} */ ...jobs) => {
    const out = join(ROOT, `found${jobs.join("")}`);
    const { code, out: text, err } = fit4cad("fit", "--method", "pg", SET, "--out", out, "--json", ...jobs);
    const models = JSON.parse(text).map((/** @type {{ seconds: number }} */ { seconds: _, ...model }) => model);
    return { code, err, models, files: contents(out) };
  };
  const alone = run();
  assert.equal(alone.files.length, 3 * PARTS.length);
  assert.deepEqual(alone.models.map((/** @type {{ model: string }} */ { model }) => model), PARTS.map((_, at) => `PC${at + 1}`));
  assert.deepEqual(run("--jobs", "4"), alone);
});

test("what is fitted into the folder that is read is not read as well", () => {
  const { code, err } = fit4cad("fit", "--method", "ht", join(SET, "PC1.txt"), join(SET, "PC2.txt"), "--out", SET, "--jobs", "2");
  assert.equal(code, 0, err);
});

test("a number that is none is refused", () => {
  for (const wrong of ["-1", "1.5", "many", "1000"]) {
    const { code, err } = fit4cad("score", SET, "--jobs", wrong);
    assert.equal(code, 2);
    assert.match(err, /--jobs .*expected a whole number from 0 to 256/);
  }
  assert.equal(fit4cad("fit", "--single", SET, "--jobs", "2").code, 2);
});
