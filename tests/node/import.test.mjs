// `fit4cad import`: STEP files become models.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { ROOT } from "../../scripts/lib/paths.mjs";
import { stepPlate as plate } from "../../scripts/lib/samples.mjs";
import { fit4cad, folder } from "./support.mjs";

/** @typedef {import("../../bin/cli/import.mjs").Imported} Imported */

/** Real files of several systems, where they are at hand. */
const REAL = join(process.env.FIT4CAD_SHARED ?? join(ROOT, "../shared"), "step");
const WITHOUT_REAL = !existsSync(REAL) && "the STEP files are not in ../shared/step";

/** @param {string | Uint8Array} content */
const sha256 = (content) => createHash("sha256").update(content).digest("hex");

/** @param {string} out */
function imported(out) {
  return /** @type {(Imported & { engine: string })[]} */ (JSON.parse(out));
}

test("a part becomes a model whose truth is right, and the same each time", (t) => {
  const root = folder(t, { "plate.step": plate() });
  const out = join(root, "out");
  const { code, out: said, err } = fit4cad("import", join(root, "plate.step"), "--points", "3000", "--out", out, "--json");
  assert.equal(code, 0, err);
  const [model] = imported(said);
  assert.ok(model);
  assert.deepEqual([model.model, model.points, model.primitives, model.types.Plane], ["plate", 3000, 6, 6]);
  assert.ok(Math.abs(model.report.diagonal - Math.hypot(10, 20, 2)) < 1e-9);
  assert.ok(Math.abs(model.report.area - 2 * (200 + 20 + 40)) < 1e-9);
  for (const face of model.report.faces) {
    // Points are in proportion to the area.
    assert.ok(Math.abs(face.points / 3000 - face.area / 520) < 0.01, JSON.stringify(face));
  }
  assert.deepEqual(readdirSync(out).sort(), ["plate.txt", "plate_implicit.txt", "plate_parametric.txt", "plate_primitives.txt"]);
  for (const [path, hash] of Object.entries(model.files)) assert.equal(sha256(readFileSync(join(out, path))), hash);
  assert.equal(fit4cad("check", out).code, 0);
  const [score] = JSON.parse(fit4cad("score", out, "--self", "--json").out);
  assert.equal(score.mean.DSC, 1);
  const again = join(root, "again");
  assert.deepEqual(imported(fit4cad("import", join(root, "plate.step"), "--points", "3000", "--out", again, "--json").out)[0]?.files, model.files);
  const other = imported(fit4cad("import", join(root, "plate.step"), "--points", "3000", "--seed", "2", "--out", again, "--json").out);
  assert.notDeepEqual(other[0]?.files, model.files);
});

test("a scan has points where its viewpoints see, and the same each time", (t) => {
  const root = folder(t, { "plate.step": plate() });
  const scan = (/** @type {string[]} */ ...args) => {
    const { code, out, err } = fit4cad("import", join(root, "plate.step"), "--points", "1000", "--spread", "scan", ...args, "--out", root, "--json");
    assert.equal(code, 0, err);
    const [made] = imported(out);
    assert.ok(made);
    return made;
  };
  // One viewpoint sees three sides of a plate at most.
  const one = scan("--views", "1");
  assert.equal(one.points, 1000);
  assert.ok(one.primitives <= 3, JSON.stringify(one.types));
  assert.equal(scan().primitives, 6);
  assert.deepEqual(scan("--views", "1").files, one.files);
  assert.notDeepEqual(scan("--views", "1", "--seed", "2").files, one.files);
  assert.match(fit4cad("import", join(root, "plate.step"), "--spread", "scan", "--views", "99", "--out", root).err, /--views .*1 to 64/);
});

test("primitives go back to CAD and come again as the same surfaces", (t) => {
  const root = folder(t, { "plate.step": plate() });
  const [made, out, back] = ["made", "out", "back"].map((name) => join(root, name));
  assert.ok(made && out && back);
  fit4cad("import", join(root, "plate.step"), "--points", "3000", "--out", made);
  fit4cad("generate", "flange", "--spacing", "0.02", "--out", made);
  const { code, err } = fit4cad("export", made, "--to", "step,csv", "--out", out);
  assert.equal(code, 0, err);
  assert.deepEqual(readdirSync(out).sort(), ["flange_truth_primitives.csv", "flange_truth_surfaces.step", "plate_truth_primitives.csv", "plate_truth_surfaces.step"]);
  const models = imported(fit4cad("import", out, "--points", "3000", "--separate", "--out", back, "--json").out);
  const types = (/** @type {Imported | undefined} */ model) => model?.types;
  const known = imported(fit4cad("import", join(root, "plate.step"), "--points", "3000", "--out", made, "--json").out);
  assert.deepEqual(types(models.find(({ model }) => model === "plate_truth_surfaces")), types(known[0]));
  const flange = models.find(({ model }) => model === "flange_truth_surfaces");
  // A row a primitive below the head.
  const rows = readFileSync(join(out, "flange_truth_primitives.csv"), "utf8").trim().split("\n").length - 1;
  assert.ok(rows > 5);
  assert.equal(flange?.report.faces.filter(({ remark }) => !remark.startsWith("left out")).length, rows);
});

test("a folder becomes a set with a manifest, split by seed, whatever is broken in it", (t) => {
  const names = Array.from({ length: 12 }, (_, i) => `part${i}`);
  const root = folder(t, {
    ...Object.fromEntries(names.map((name) => [`parts/${name}.stp`, plate()])),
    "parts/deep/part0.step.gz": gzipSync(plate()),
    "parts/broken.step": plate().slice(0, 900),
    "parts/none.step": "nothing of the kind",
    "parts/readme.txt": "not a part",
  });
  const out = join(root, "set");
  const args = ["import", join(root, "parts"), "--points", "400", "--noise", "0.001", "--test", "0.4", "--out", out];
  const { code, err } = fit4cad(...args);
  assert.equal(code, 1);
  assert.match(err, /broken\.step: error: /);
  assert.match(err, /none\.step: error: this is no STEP file/);
  assert.doesNotMatch(err, /readme/);
  const manifest = JSON.parse(readFileSync(join(out, "manifest.json"), "utf8"));
  /** @type {Imported[]} */
  const models = manifest.models;
  assert.deepEqual(models.map(({ model }) => model).sort(), [...names, "part0-2"].sort());
  assert.deepEqual(manifest.degradation, { noise: 0.001 });
  assert.deepEqual(manifest.failed.map((/** @type {{ source: string }} */ { source }) => basename(source)), ["broken.step", "none.step"]);
  assert.equal(manifest.statistics.types.Plane, 13 * 6);
  for (const { source, sha256: of, files } of models) {
    assert.equal(sha256(readFileSync(source)), of);
    for (const [path, hash] of Object.entries(files)) assert.equal(sha256(readFileSync(join(out, path))), hash);
  }
  const [training, held] = ["training_set", "test_set"].map((set) => readdirSync(join(out, set)).length / 4);
  assert.ok(held && training && held + training === 13, `${training} and ${held}`);
  // One more part moves no other.
  writeFileSync(join(root, "parts/more.step"), plate());
  fit4cad(...args);
  const after = JSON.parse(readFileSync(join(out, "manifest.json"), "utf8"));
  for (const model of models) {
    assert.deepEqual(after.models.find((/** @type {Imported} */ { model: name }) => name === model.model), model);
  }
});

test("what cannot be asked for is said, also in JSON", (t) => {
  const root = folder(t, { "plate.step": plate() });
  const file = join(root, "plate.step");
  for (const [args, words] of /** @type {const} */ ([
    [["--points", "3"], /--points 3: expected a whole number from 10/],
    [["--points", "100", "--spacing", "1"], /--points or --spacing, not both/],
    [["--spread", "odd"], /--spread odd: expected even, random/],
    [["--bodies", "1,x"], /--bodies x: expected a whole number from 1/],
  ])) {
    const { code, out } = fit4cad("import", file, ...args, "--json");
    assert.equal(code, 2);
    assert.match(JSON.parse(out).error, words);
  }
  const { code, err } = fit4cad("import", file, "--spacing", "0.0001", "--out", root);
  assert.equal(code, 1);
  assert.match(err, /spacing must be about [\d.]+ to [\d.]+ mm for this part, not 0\.0001 mm/);
  const none = fit4cad("import", file, "--bodies", "1,2", "--out", root);
  assert.equal(none.code, 1);
  assert.match(none.err, /bodies must be of 1 \(plate, 6 faces\), not 2/);
  const help = fit4cad("import", "--help");
  for (const word of ["--points N", "--spread even", "--separate", "--noise N", "manifest.json"]) assert.ok(help.out.includes(word), word);
});

test("real files of several systems become models with as many faces as there are", { skip: WITHOUT_REAL }, (t) => {
  const root = folder(t, {});
  const { out, err } = fit4cad("import", REAL, "--points", "5000", "--out", root, "--json");
  const models = imported(out);
  const several = join(REAL, "on01_goproled.step");
  const [one] = imported(fit4cad("import", several, "--bodies", "2", "--points", "500", "--out", root, "--json").out);
  const all = models.find(({ source }) => source === several);
  assert.ok(one);
  assert.ok(all);
  assert.deepEqual([one.report.bodies, all.report.bodies], [1, 3]);
  assert.ok(one.report.faces.length < all.report.faces.length && one.report.area < all.report.area);
  const oracle = /** @type {Record<string, { faces: { type: string }[] }>} */ (JSON.parse(readFileSync(join(REAL, "oracle.json"), "utf8")));
  assert.equal(models.length, readdirSync(REAL).filter((name) => /\.ste?p$/.test(name)).length, err);
  for (const { report, source } of models) {
    // Triangles for display are there as faces of another kind.
    assert.equal(report.faces.length, oracle[basename(source)]?.faces.filter(({ type }) => type !== "other").length, source);
  }
});
