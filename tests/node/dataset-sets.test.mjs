import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { LOOSE, setsOf } = await pageModule("statistics/sets.ts");

const sets = (paths) => Object.fromEntries(setsOf(Object.entries(paths).map(([id, path]) => ({ id, path }))));

test("the two sets of the whole repository are told by their folders", () => {
  const found = sets({
    a: "Fit4CAD-main.zip/Fit4CAD-main/dataset/training_set/PC1.txt",
    b: "Fit4CAD-main.zip/Fit4CAD-main/dataset/training_set/PC2.txt",
    c: "Fit4CAD-main.zip/Fit4CAD-main/dataset/test_set/pointCloud/PC1.txt",
  });
  assert.deepEqual(found, { training_set: ["a", "b"], test_set: ["c"] });
});

test("the folders of one set make no sets", () => {
  const found = sets({ a: "dataset/test_set/pointCloud/PC1.txt", b: "dataset/test_set/pointCloud/PC2.txt" });
  assert.deepEqual(Object.values(found), [["a", "b"]]);
});

test("two zips are two sets, named without their ending", () => {
  const found = sets({ a: "training_set.zip/PC1.txt", b: "test_sample/pointCloud/PC1.txt" });
  assert.deepEqual(found, { training_set: ["a"], test_sample: ["b"] });
});

test("models without a folder are a set of their own", () => {
  assert.deepEqual(sets({ a: "PC1.txt", b: undefined }), { [LOOSE]: ["a", "b"] });
  assert.deepEqual(sets({ a: "mine/PC1.txt", b: undefined }), { mine: ["a"], [LOOSE]: ["b"] });
  assert.deepEqual(sets({}), {});
});

test("many folders are one set", () => {
  const paths = Object.fromEntries(["a", "b", "c", "d", "e"].map((id) => [id, `root/${id}/PC.txt`]));
  assert.deepEqual(sets(paths), { "all models": ["a", "b", "c", "d", "e"] });
});
