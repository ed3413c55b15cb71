import assert from "node:assert/strict";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { evenly } from "../../scripts/bench/fit/models.mjs";
import { summary } from "../../scripts/bench/fit/fitted.mjs";

const engine = await loadEngine();

test("a degraded model keeps its truth, loses its submissions and leaves the first model alone", () => {
  const model = engine.Model.generate("bracket", { spacing: 0.03 });
  model.imperfect(1);
  const worse = model.degraded({ missing: 0.25, outliers: 0.1, seed: 2 });
  const [before, after] = [model.info(), worse.info()];
  const left = before.points - Math.round(0.25 * before.points);
  assert.equal(after.points, left + Math.round(0.1 * left));
  assert.deepEqual([after.hasTruth, after.methods, before.methods], [true, [], ["Imperfect"]]);
  for (const { mfe } of worse.primitives()) {
    assert.ok(mfe !== undefined && mfe < 1e-6, String(mfe));
  }
  worse.free();
  const shaken = model.degraded({ noise: 0.002 });
  assert.ok(shaken.primitives().every(({ mfe }) => mfe !== undefined && mfe > 1e-4));
  shaken.free();
  assert.throws(() => model.degraded({ noise: 2 }), /noise must be between/);
  const thinned = model.degraded({ density: 10, seed: 2 });
  const share = thinned.info().points / before.points;
  assert.ok(share > 0.2 && share < 0.6, String(share));
  assert.ok(thinned.primitives().every(({ mfe }) => mfe !== undefined && mfe < 1e-6));
  thinned.free();
  assert.throws(() => model.degraded({ density: 0.5 }), /density must be between/);
  model.free();
});

test("an even selection is spread over the list and always the same", () => {
  const list = Array.from({ length: 188 }, (_, at) => at);
  const chosen = evenly(list, 40);
  assert.deepEqual(chosen, evenly(list, 40));
  assert.equal(new Set(chosen).size, 40);
  const steps = chosen.slice(1).map((at, index) => at - chosen[index]);
  assert.ok(Math.min(...steps) >= 4 && Math.max(...steps) <= 5);
  assert.deepEqual(evenly([1, 2], 40), [1, 2]);
});

test("types are right where a matched prediction has the type of its true primitive", () => {
  const report = {
    mean: { DSC: 0.5, MFE: 0.1, dHaus: 0.2, d1: null },
    hidden: { prediction_dsc: 0.4 },
    primitives: [
      { type: "Plane", match: 1 },
      { type: "Cone", match: 2 },
      { type: "Torus", match: null },
      { type: null, match: 2 },
    ],
    predictions: [
      { prediction: 1, type: "Plane" },
      { prediction: 2, type: "Cylinder" },
    ],
  };
  const figures = summary([{ report: /** @type {any} */ (report), seconds: 2 }]);
  assert.equal(figures.typeRight, 0.5);
  assert.deepEqual([figures.dsc, figures.worst, figures.predictionDsc, figures.seconds], [0.5, 0.5, 0.4, 2]);
});
