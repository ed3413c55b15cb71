import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { MEASURES } from "../../www/shared/formats/measures.mjs";
import { TEST_MODELS, published } from "../../www/shared/published/figures.mjs";
import { matchOf } from "../../www/shared/published/match.mjs";
import { PUBLISHED_METHODS } from "../../www/shared/published/methods.mjs";
import { PUBLIC_FILES, WITHOUT_PUBLIC_FILES, fit4cad } from "./support.mjs";

const PC1 = { name: "PC1", points: 7500, truth: 8 };

test("a model is a test model where name, points and true primitives agree", () => {
  const matched = { kind: "matched", model: "PC1", said: false };
  assert.deepEqual(matchOf(PC1, TEST_MODELS), matched);
  assert.deepEqual(matchOf({ ...PC1, name: "test_set/pc1" }, TEST_MODELS), matched);
  assert.deepEqual(matchOf({ ...PC1, points: 7501, truth: 9 }, TEST_MODELS), {
    kind: "unlike",
    model: "PC1",
    reason: "7501 points for 7500, 9 true primitives for 8",
  });
  assert.deepEqual(matchOf({ ...PC1, name: "flange" }, TEST_MODELS), { kind: "none" });
});

test("the reader's word goes before names and counts", () => {
  assert.deepEqual(matchOf(PC1, TEST_MODELS, null), { kind: "none" });
  assert.deepEqual(matchOf({ ...PC1, name: "scan" }, TEST_MODELS, "PC7"), { kind: "matched", model: "PC7", said: true });
});

test("the means over the 35 models are those known for both methods", () => {
  assert.equal(TEST_MODELS.length, 35);
  /** @param {"PG" | "HT"} method @param {import("../../bin/engine/engine.js").Measure} measure */
  const mean = (method, measure) => TEST_MODELS.reduce((sum, { name }) => sum + (published(name, method, "published", measure) ?? NaN), 0) / TEST_MODELS.length;
  // The published protocol exchanges PPV and TPR.
  const known = { PG: { DSC: 0.6498, TPR: 0.6527, PPV: 0.7782 }, HT: { DSC: 0.9049, TPR: 0.9187, PPV: 0.9282 } };
  for (const method of PUBLISHED_METHODS) {
    for (const measure of /** @type {const} */ (["DSC", "TPR", "PPV"])) {
      const value = known[method][measure];
      assert.ok(Math.abs(mean(method, measure) - value) < 1e-4, `${method} ${measure}: ${mean(method, measure)}`);
    }
  }
  assert.equal(published("PC1", "PG", "definition", "MFE"), null);
});

test("the engine scores the published results as the table says", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const sample = join(PUBLIC_FILES, "test_sample");
  for (const protocol of /** @type {const} */ (["definition", "published"])) {
    /** @type {import("../../bin/engine/engine.js").Report[]} */
    const results = JSON.parse(fit4cad("score", sample, "--format", "json", "--protocol", protocol).out);
    assert.equal(results.length, 20);
    for (const { model, method, points, truth, mean } of results) {
      assert.equal(matchOf({ name: model, points, truth }, TEST_MODELS).kind, "matched");
      for (const measure of MEASURES) {
        const expected = published(model, /** @type {"PG" | "HT"} */ (method), protocol, measure);
        // PG gives no surfaces; its d1 column is what the missing ones come to.
        if (expected === null) continue;
        assert.ok(Math.abs((mean[measure] ?? NaN) - expected) < 6e-7, `${protocol} ${model} ${method} ${measure}: ${mean[measure]} for ${expected}`);
      }
    }
  }
});

test("the table holds what was published", { skip: WITHOUT_PUBLIC_FILES }, () => {
  const source = JSON.parse(readFileSync(join(PUBLIC_FILES, "published_methods.json"), "utf8"));
  assert.deepEqual(TEST_MODELS.map(({ name }) => name), Object.keys(source));
  for (const [model, methods] of Object.entries(source)) {
    for (const method of PUBLISHED_METHODS) {
      for (const by of /** @type {const} */ (["definition", "published", "paper"])) {
        const figures = methods[method][by];
        for (const measure of MEASURES) {
          if (figures[measure] !== undefined) assert.equal(published(model, method, by, measure), figures[measure]);
        }
      }
    }
  }
});
