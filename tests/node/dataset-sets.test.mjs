import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { LOOSE, setsOf } = await pageModule("statistics/sets.ts");

/** @param {Record<string, string | undefined>} paths */
const sets = (paths) => Object.fromEntries(setsOf(Object.entries(paths).map(([id, path]) => ({ id, path }))));

test("the two sets of the whole repository are told by their folders", () => {
  const found = sets({
    a: "Fit4CAD-main.zip/Fit4CAD-main/dataset/training_set/PC1.txt",
    b: "Fit4CAD-main.zip/Fit4CAD-main/dataset/training_set/PC2.txt",
    c: "Fit4CAD-main.zip/Fit4CAD-main/dataset/test_set/pointCloud/PC1.txt",
  });
  assert.deepEqual(found, { a: "training_set", b: "training_set", c: "test_set" });
});

test("a set is called the same whatever else is there", () => {
  const mine = { a: "downloads/test_sample.zip/pointCloud/PC1.txt" };
  assert.deepEqual(sets(mine), { a: "test_sample" });
  assert.deepEqual(sets({ ...mine, b: "training_set.zip/PC1.txt", c: "x/y/z/PC1.txt", d: "PC9.txt" }), {
    a: "test_sample",
    b: "training_set",
    c: "z",
    d: LOOSE,
  });
});

test("the folders of roles make no sets", () => {
  const roles = { a: "s/pointCloud/PC1.txt", b: "s/pointCloud_primitives/PC2_primitives.txt", c: "s/pointCloud_parametric_HT/PC3.txt" };
  assert.deepEqual(sets(roles), { a: "s", b: "s", c: "s" });
});

test("two folders of one name are told apart by those around them", () => {
  assert.deepEqual(sets({ a: "2023/test_set/PC1.txt", b: "2024/test_set/PC1.txt", c: "train/PC1.txt" }), {
    a: "2023/test_set",
    b: "2024/test_set",
    c: "train",
  });
  assert.deepEqual(sets({ a: "test_set/PC1.txt", b: "2024/test_set/PC1.txt" }), { a: "test_set", b: "2024/test_set" });
});

test("models without a folder are a set of their own", () => {
  assert.deepEqual(sets({ a: "PC1.txt", b: undefined, c: "pointCloud/PC1.txt" }), { a: LOOSE, b: LOOSE, c: LOOSE });
  assert.deepEqual(sets({}), {});
});
