import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { PUBLIC_FILES, WITHOUT_PUBLIC_FILES, fit4cad, folder, twoPlanes } from "./support.mjs";

/**
 * @param {string} out
 * @returns {import("../../bin/engine/engine.js").Audit[]}
 */
function audits(out) {
  return JSON.parse(out);
}

/**
 * Model, primitive and check of every finding.
 * @param {string} out
 */
function found(out) {
  return audits(out).flatMap(({ model, findings }) =>
    findings.map(({ primitive, check }) => `${model} ${primitive ?? "-"} ${check}`),
  );
}

/** @param {readonly string[]} values */
function unique(values) {
  return [...new Set(values)];
}

test("a right ground truth has no finding", (t) => {
  const { code, out, err } = fit4cad("check", folder(t, twoPlanes("PC1")));
  assert.deepEqual([code, err], [0, ""]);
  assert.equal(out, "1 model, 2 primitives: 0 errors, 0 warnings, 0 notes\n");
});

test("every generated part is right", (t) => {
  const root = folder(t, {});
  for (const part of ["flange", "elbow", "nozzle", "ball-joint"]) {
    fit4cad("generate", part, "--spacing", "0.02", "--out", root);
  }
  const { code, out } = fit4cad("check", root, "--format", "json");
  assert.equal(code, 0);
  assert.deepEqual(found(out), []);
  for (const { primitives } of audits(out)) {
    const worst = primitives.flatMap(({ parametric, implicit }) => [parametric?.max ?? NaN, implicit?.max ?? NaN]);
    assert.ok(worst.every((distance) => distance < 1e-6));
  }
});

test("a wrong implicit form is found, said where and how far, and corrected", (t) => {
  const files = twoPlanes("PC1");
  files["PC1_implicit.txt"] = "Primitive1:=[Plane, [0 0 1 0]];\nPrimitive2:=[Plane, [0 0 1 -1.1]];\n";
  const root = folder(t, files);
  const { code, out } = fit4cad("check", root, "--format", "json");
  assert.equal(code, 1);
  const [{ findings, primitives }] = JSON.parse(out);
  assert.equal(findings.length, 1);
  const [{ primitive, check, severity, value, limit, hint }] = findings;
  assert.deepEqual([primitive, check, severity, limit], [2, "implicit distance", "error", 0.001]);
  // The points lie 0.1 off over a diagonal of √2.
  assert.ok(Math.abs(value - 0.1 / Math.SQRT2) < 1e-12);
  assert.match(hint, /parametric form fits/);
  assert.equal(primitives[1].parametric.max, 0);

  const corrected = join(folder(t, {}), "made/corrected");
  const { err } = fit4cad("check", root, "--write", corrected);
  assert.match(err, /wrote .*PC1_implicit\.txt: replaced the vectors of primitives 2/);
  assert.deepEqual(readdirSync(corrected), ["PC1_implicit.txt"]);
  const text = readFileSync(join(corrected, "PC1_implicit.txt"), "utf8");
  assert.equal(text.split("\n")[0], "Primitive1:=[Plane, [0 0 1 0]];");
  const again = fit4cad("check", folder(t, { ...files, "PC1_implicit.txt": text }));
  assert.deepEqual([again.code, again.err], [0, ""]);
});

test("the table has a row for each finding and ends with their number", (t) => {
  const files = twoPlanes("PC1");
  files["PC1_primitives.txt"] =
    "Primitive1:=[1 2 3 4 5 6 7 8 9 99];\nPrimitive2:=[10 10 11 12 13 14 15 16 17 18];\n";
  files["PC1_implicit.txt"] = "Primitive1:=[Plane, [Plane, [0 0 1 0]];\nPrimitive2:=[Plane, [0 0 1]];\n";
  const { code, out, err } = fit4cad("check", folder(t, files));
  assert.deepEqual([code, err], [1, ""]);
  const lines = out.trimEnd().split("\n");
  const columns = lines.slice(1, -1).map((line) => line.split(/ {2,}/).slice(0, 4).join(" "));
  assert.deepEqual(columns, [
    "PC1 1 note syntax",
    "PC1 1 error index",
    "PC1 2 warning duplicate",
    "PC1 2 error vector",
  ]);
  assert.match(lines[1], /PC1_implicit\.txt:1:\d+/);
  assert.equal(lines.at(-1), "1 model, 2 primitives: 2 errors, 1 warning, 1 note");
});

test("a cloud without truth is said to have none", (t) => {
  const files = twoPlanes("PC1");
  const { code, err } = fit4cad("check", folder(t, { "PC1.txt": files["PC1.txt"] }));
  assert.equal(code, 1);
  assert.match(err, /PC1: error: there is no ground truth to check/);
});

test("check and stats called wrongly exit with 2", () => {
  /** @type {[string[], RegExp][]} */
  const calls = [
    [["check"], /at least one file/],
    [["check", ".", "--format", "csv"], /expected table, json/],
    [["stats"], /at least one file/],
    [["stats", ".", "--format", "latex"], /expected table, json, csv/],
  ];
  for (const [args, expected] of calls) {
    const { code, out, err } = fit4cad(...args);
    assert.deepEqual([code, out], [2, ""], args.join(" "));
    assert.match(err, expected);
  }
});

/**
 * `model` with each of the primitives, in order.
 * @param {string} model
 * @param {readonly number[]} primitives
 * @param {string} check
 */
const each = (model, primitives, check) => primitives.map((number) => `${model} ${number} ${check}`);

test("the training set has these errors and no others", { skip: WITHOUT_PUBLIC_FILES }, (t) => {
  const corrected = folder(t, {});
  const zip = join(PUBLIC_FILES, "training_set.zip");
  const { code, out } = fit4cad("check", zip, "--format", "json", "--write", corrected);
  assert.equal(code, 1);
  assert.deepEqual(unique(found(out)), [
    "PC1 1 syntax",
    "PC14 5 family",
    ...each("PC16", [1, 4, 5, 6, 9, 11, 13], "implicit distance"),
    ...each("PC18", [10, 13, 15, 16, 17, 20], "implicit distance"),
    "PC32 14 first-order distance",
    "PC44 16 implicit distance",
    ...each("PC66", [1, 17], "parametric distance"),
    ...each("PC75", [7, 9], "first-order distance"),
    "PC83 - numbering",
    ...each("PC83", [16, 18], "implicit distance"),
    "PC117 4 type",
    "PC117 4 vector",
    "PC144 4 type",
    "PC144 4 vector",
  ]);
  assert.deepEqual(
    readdirSync(corrected).sort(),
    [
      ...["PC14", "PC16", "PC18", "PC32", "PC44"].map((model) => `${model}_implicit.txt`),
      "PC66_parametric.txt",
      ...["PC75", "PC83"].map((model) => `${model}_implicit.txt`),
    ],
  );
});

test("the test sample has an empty file and stray points", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const { code, out } = fit4cad("check", join(PUBLIC_FILES, "test_sample"), "--format", "json");
  assert.equal(code, 1);
  const strays = each("PC31", [5, ...Array.from({ length: 15 }, (_, index) => index + 7)], "stray point");
  assert.deepEqual(found(out), ["PC31 - file", ...strays]);
});
