// Models keep their names on the page, whatever comes after them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { pageModule } from "./page.mjs";

/** @typedef {import("../../bin/engine/engine.js").Grouping["models"]} Models */

/** @type {{ named: (models: Models, known: ReadonlyMap<string, string>, taken: Iterable<string>) => Models, namesOf: (models: Models) => Map<string, string> }} */
const { named, namesOf } = await pageModule("state/identity.ts");
const engine = await loadEngine();

const REPOSITORY = [1, 2, 3].flatMap((number) => [
  `Fit4CAD.zip/dataset/test_set/pointCloud/PC${number}.txt`,
  `Fit4CAD.zip/dataset/test_set/pointCloud_primitives/PC${number}_primitives.txt`,
]);

/** @param {Models} models */
const told = (models) => models.map(({ name, files }) => [name, files.length]);

test("a set keeps its names when files of one of them come, and these get a number", () => {
  const first = named(engine.group(REPOSITORY, {}).models, new Map(), []);
  assert.deepEqual(told(first), [["PC1", 2], ["PC2", 2], ["PC3", 2]]);
  const heap = [...REPOSITORY, "PC1.txt", "PC1_primitives.txt"];
  // The engine alone would rename all of the set.
  assert.ok(engine.group(heap, {}).models.some(({ name }) => name === "test_set/PC3"));
  const second = named(engine.group(heap, {}).models, namesOf(first), []);
  assert.deepEqual(told(second), [["PC1-2", 2], ["PC1", 2], ["PC2", 2], ["PC3", 2]]);
  const loose = second.find(({ files }) => files.some(({ path }) => path === "PC1.txt"));
  assert.equal(loose?.name, "PC1-2");
  // Sorted again they stay as they are, also once the first has gone.
  assert.deepEqual(named(engine.group(heap, {}).models, namesOf(second), []), second);
  assert.equal(named(engine.group(["PC1.txt"], {}).models, namesOf(second), [])[0]?.name, "PC1-2");
});

test("what is brought takes no name of what was made here, and no two models have one", () => {
  const { models } = engine.group(["flange.txt", "a/PC1.txt", "b/PC1.txt"], {});
  assert.deepEqual(named(models, new Map(), ["flange"]).map(({ name }) => name).sort(), ["a/PC1", "b/PC1", "flange-2"]);
  // Both were one model once; who has kept the cloud keeps the name.
  const split = [
    { name: "x", files: [{ path: "new.txt", role: "cloud" }, { path: "old_primitives.txt", role: "primitives" }] },
    { name: "y", files: [{ path: "old.txt", role: "cloud" }] },
  ];
  const known = new Map([["old.txt", "old"], ["old_primitives.txt", "old"]]);
  assert.deepEqual(named(/** @type {any} */ (split), known, []).map(({ name }) => name), ["x", "old"]);
});
