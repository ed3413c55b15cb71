import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { isRebuildable, secondsOf, unaskedOf, workOf, UNASKED_SECONDS } = await pageModule("sharing/plan.ts");

/** @typedef {import("../../www/app/sharing/shared").SharedModel} SharedModel */

/** @param {import("../../www/app/engine/contract").SampleOptions} options @param {string} part */
const sample = (options = {}, part = "bracket") => ({ name: part, points: 18_000, truth: 22, origin: { kind: "sample", part, options } });
/** @param {number} number */
const publicModel = (number) => ({ name: `PC${number}`, points: 20_000, truth: 9, origin: { kind: "public", model: { set: "test", number } } });
const FILES = { name: "PC1", points: 18_000, truth: 22, origin: { kind: "files" } };
/** @param {number} model @param {string} method @param {number} seed */
const fit = (model, method, seed = 1) => ({ model, method, fitted: { method: "pg", seed, parameters: {} } });
/** @param {readonly object[]} models @param {readonly object[]} claims @param {object} [view] */
const link = (models, claims, view) => ({ engine: "0.1.0", protocol: "definition", models, claims, view });

test("of two hundred fits only those in view start unasked", () => {
  const claims = Array.from({ length: 200 }, (_, seed) => fit(0, `PG ${seed}`, seed));
  assert.deepEqual(unaskedOf(link([sample()], claims, { model: 0, method: "PG 7", left: "PG 9" })).fits, [claims[7], claims[9]]);
  assert.deepEqual(unaskedOf(link([sample()], claims, { model: 0, method: "Imperfect" })).fits, []);
  // All of one name: still no more than the two views show.
  const alike = claims.map((claim) => ({ ...claim, method: "PG" }));
  assert.equal(unaskedOf(link([sample()], alike, { model: 0, method: "PG" })).fits.length, 2);
});

test("what is asked for says how many and roughly how long", () => {
  const claims = Array.from({ length: 200 }, (_, seed) => fit(0, `PG ${seed}`, seed));
  const results = link([sample()], claims);
  assert.equal(workOf(results, { models: [0], fits: claims }), "Make 1 sample, repeat 200 fits (about 38 s)");
  assert.equal(workOf(results, { models: [], fits: claims.slice(0, 1) }), "Repeat 1 fit (about 1 s)");
  assert.equal(workOf(link([publicModel(1)], []), { models: [0], fits: [] }), "Download 1 public model");
  assert.equal(workOf(results, { models: [], fits: [] }), undefined);
});

test("a link is taken at what it asks for, not at the number of points it claims", () => {
  /** @param {object} model */
  const seconds = (model) => secondsOf(link([model], [fit(0, "PG")]), { models: [0], fits: [fit(0, "PG")] });
  assert.equal(seconds({ ...sample(), points: 1 }), seconds(sample()));
  assert.ok(seconds(sample({ spacing: 0.001 })) > 10);
  // The engine makes no more than two million points, whatever is asked for.
  assert.equal(seconds(sample({ spacing: 1e-300 })), seconds(sample({ spacing: 1e-4 })));
  assert.ok(seconds({ ...publicModel(1), points: 2 ** 32 }) < 1);
});

test("a sample that takes long waits to be asked for, and so do its fits", () => {
  const results = link([sample({ spacing: 0.001 })], [fit(0, "PG")], { model: 0, method: "PG" });
  assert.deepEqual(unaskedOf(results), { models: [], fits: [] });
});

test("other samples come as long as all of it is quickly made, each once", () => {
  const many = Array.from({ length: 500 }, (_, seed) => sample({ seed }));
  const { models, shown } = unaskedOf(link(many, [], { model: 3 }));
  assert.equal(shown, 3);
  assert.ok(models.length > 5 && models.length <= 13 && models[0] === 3);
  const results = link(many, []);
  assert.ok(secondsOf(results, unaskedOf(results)) <= UNASKED_SECONDS);
  assert.deepEqual(unaskedOf(link([sample(), sample({ seed: 1 }), sample({ noise: 0 })], [])).models, [0]);
});

test("public models come unasked only where one is looked at; files never", () => {
  const models = [publicModel(1), publicModel(2), FILES];
  assert.deepEqual(unaskedOf(link(models, [])), { models: [], fits: [] });
  assert.deepEqual(unaskedOf(link(models, [], { model: 1 })).models, [1]);
  assert.deepEqual(unaskedOf(link(models, [fit(2, "PG")], { model: 2, method: "PG" })), { models: [], fits: [] });
  // Links of version 1 do not say which public model it was.
  assert.deepEqual([...models, { ...FILES, origin: { kind: "public" } }].map(isRebuildable), [true, true, false, false]);
});
