import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { isSameSample, nameOfSample } = await pageModule("samples/identity.ts");
const { sourceOf, truthOnly, without } = await pageModule("state/content.ts");

/** @param {string} part */
const sample = (part, options = {}) => ({ kind: "sample", part, options });

test("another sample of a part has another name, in whatever order its options are said", () => {
  assert.equal(nameOfSample(sample("bracket")), "bracket");
  assert.equal(nameOfSample(sample("bracket", { seed: 9, noise: 0.001 })), "bracket-noise0.001-seed9");
  assert.equal(nameOfSample(sample("bracket", { noise: 0.001, seed: 9 })), "bracket-noise0.001-seed9");
});

test("a sample is the same where its options say what holds anyway", () => {
  assert.ok(isSameSample(sample("bracket", { seed: 1, noise: 0, missing: undefined }), sample("bracket")));
  assert.ok(!isSameSample(sample("bracket", { seed: 2 }), sample("bracket")));
  assert.ok(!isSameSample(sample("flange"), sample("bracket")));
  assert.ok(!isSameSample({ kind: "files" }, sample("bracket")));
});

/**
 * @param {string} path
 * @param {string} [method]
 */
const file = (path, method) => ({ path, role: "primitives", data: new Blob([path]), ...(method && { method }) });

test("a model's truth is the same whatever becomes of its submissions, and another with other files", () => {
  const cloud = { ...file("a.txt"), role: "cloud" };
  const bare = sourceOf("a", [cloud, file("a_primitives.txt")]);
  const fitted = sourceOf("a", [...bare.files, file("ht/a_primitives.txt", "HT")]);
  assert.notEqual(fitted.key, bare.key);
  assert.equal(truthOnly(fitted).key, bare.key);
  assert.equal(without(fitted, "HT").key, bare.key);
  assert.notEqual(sourceOf("a", [cloud, file("a_primitives.txt")]).key, bare.key, "another blob");
});
