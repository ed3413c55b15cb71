import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { zipSync } from "fflate";
import { PUBLIC_FILES, WITHOUT_PUBLIC_FILES, fit4cad, folder, twoPlanes } from "./support.mjs";

/** Two models; of the second one half of the points are in no primitive. */
function twoModels() {
  const half = twoPlanes("PC2");
  half["PC2_primitives.txt"] = "Primitive1:=[1 2 3 4 5 6 7 8 9];\n";
  half["PC2_parametric.txt"] = "Primitive1:=[Plane, [1 0 0 0 1 0 0 0 0]];\n";
  half["PC2_implicit.txt"] = "Primitive1:=[Plane, [0 0 1 0]];\n";
  return { ...twoPlanes("PC1"), ...half };
}

test("models are counted one by one and as a set", (t) => {
  const { code, out, err } = fit4cad("stats", folder(t, twoModels()), "--format", "json");
  assert.deepEqual([code, err], [0, ""]);
  /** @type {import("../../www/shared/formats/statistics.mjs").Statistics} */
  const { set, models } = JSON.parse(out);
  const none = { Cylinder: 0, Cone: 0, Sphere: 0, Torus: 0, Other: 0 };
  assert.deepEqual(
    models.map(({ name, points, primitives, unsegmented }) => [name, points, primitives, unsegmented]),
    [
      ["PC1", 18, 2, 0],
      ["PC2", 18, 1, 0.5],
    ],
  );
  assert.deepEqual(set.types, { Plane: 3, ...none });
  assert.deepEqual([set.models, set.points, set.primitives, set.unsegmented], [2, 36, 3, 0.25]);
  assert.deepEqual(set.primitivesPerModel, { min: 1, median: 1.5, max: 2 });
});

test("the table ends with the bar chart of types", (t) => {
  const { out } = fit4cad("stats", folder(t, twoModels()));
  const [rows, spread, bars] = out.trimEnd().split("\n\n");
  assert.match(rows, /^all 2 +36 +3 +3 +0 +0 +0 +0 +0 +25\.0 %$/m);
  assert.match(spread, /^unsegmented +0\.0 % +25\.0 % +50\.0 %$/m);
  assert.match(bars, /^Plane +3 +100\.0 % +█{50}$/m);
});

test("CSV has one row per model", (t) => {
  const { out } = fit4cad("stats", folder(t, twoModels()), "--format", "csv");
  const version = fit4cad("--version").out.trim().replace("fit4cad ", "");
  assert.deepEqual(out.split("\r\n"), [
    "model,points,primitives,plane,cylinder,cone,sphere,torus,other,unsegmented,shared,engine",
    `PC1,18,2,2,0,0,0,0,0,0,0,${version}`,
    `PC2,18,1,1,0,0,0,0,0,0.5,0,${version}`,
    "",
  ]);
});

test("however many files have no place, each is told and nothing breaks", (t) => {
  /** @param {number} set */
  const orphans = (set) => Array.from({ length: 60_000 }, (_, index) => [`${set}/PC${index}_primitives.txt`, new Uint8Array()]);
  /** @param {number} set */
  const zip = (set) => zipSync(Object.fromEntries(orphans(set)), { level: 0 });
  const root = folder(t, { "1.zip": zip(1), "2.zip": zip(2), "3.zip": zip(3) });
  for (const command of ["stats", "check", "score", "fit"]) {
    const { code, err } = fit4cad(command, root, ...(command === "fit" ? ["--method", "ht"] : []));
    const told = err.match(/: warning: there is no cloud PC\d+ for it\n/g);
    assert.deepEqual([code, told?.length], [1, 180_000], command);
  }
});

test("nothing to count is a failure", (t) => {
  const { code, err } = fit4cad("stats", folder(t, { "readme.md": "nothing" }));
  assert.equal(code, 1);
  assert.match(err, /no model/);
});

test("the training set is as large as it is", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const { code, out } = fit4cad("stats", join(PUBLIC_FILES, "training_set.zip"), "--format", "json");
  assert.equal(code, 0);
  /** @type {import("../../www/shared/formats/statistics.mjs").Statistics} */
  const { set } = JSON.parse(out);
  assert.equal(set.models, 188);
  assert.equal(set.types.Other, 2);
  const sum = Object.values(set.types).reduce((total, count) => total + count, 0);
  assert.equal(sum, set.primitives);
  // Mostly planes, then cylinders, as in the paper's chart.
  assert.ok(set.types.Plane > set.types.Cylinder && set.types.Cylinder > set.types.Cone);
});
