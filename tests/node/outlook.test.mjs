import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { estimate, pointsFitted, proposal, range, roughly, together } = await pageModule("fit/estimate.ts");

/** @param {object} [change] */
const done = (change) => ({ method: "ht", model: "PC1", points: 100_000, seconds: 1, ...change });
const asked = { method: "ht", model: "PC9", points: 100_000 };

test("without a fit done here the range holds clean clouds and those with noise", () => {
  const { from, to, fits } = estimate(asked, []);
  // What `npm run bench -- fit` has of 100,000 points: 0.5 s of a clean cloud, 4 s of one with noise.
  assert.ok(from <= 0.55 && to >= 4 && fits === 0, `${from} to ${to}`);
});

test("fits done here tell how fast the machine is, and draw the range in", () => {
  const none = estimate(asked, []);
  const one = estimate(asked, [done()]);
  const many = estimate(asked, [done({ seconds: 0.9 }), done({ seconds: 1.1 }), done()]);
  assert.ok(Math.abs(one.seconds - 1) < 1e-9 && Math.abs(many.seconds - 1) < 0.05);
  /** @param {{ from: number, to: number }} estimate */
  const width = ({ from, to }) => to / from;
  assert.ok(width(many) < width(one) && width(one) < width(none));
  // Half as many points take half as long, or little more.
  assert.ok(Math.abs(estimate({ ...asked, points: 50_000 }, [done()]).seconds - 0.52) < 0.02);
  // Those of another method tell nothing, and the very model tells most.
  assert.deepEqual(estimate(asked, [done({ method: "pg" })]), none);
  assert.equal(estimate({ ...asked, model: "PC1" }, [done(), done({ model: "PC2", seconds: 9 })]).seconds.toFixed(6), "1.000000");
});

test("of many models so many are fitted at once", () => {
  const four = Array.from({ length: 4 }, () => estimate(asked, [done()]));
  assert.ok(Math.abs(together(four, 2).seconds - 2) < 1e-9);
  assert.ok(Math.abs(together(four, 8).seconds - 1) < 1e-9);
});

test("spans of time are as rough as they are known", () => {
  assert.deepEqual([0.2, 1.4, 23, 200, 9000].map(roughly), ["under 1 s", "1 s", "25 s", "3 min", "3 h"]);
  assert.deepEqual(
    [[0.1, 0.5], [0.4, 6], [2, 9], [40, 200], [61, 70]].map(([from, to]) => range({ from, to })),
    ["under 1 s", "up to 6 s", "2 to 9 s", "40 s to 3 min", "60 to 70 s"],
  );
});

test("where a fit may take minutes, one of so many points that it takes seconds is proposed", () => {
  assert.equal(proposal(asked, []), undefined);
  const large = { ...asked, points: 3_000_000 };
  const small = proposal(large, []);
  assert.equal(small.points, 100_000);
  assert.ok(estimate(large, []).to > 60 && small.estimate.to < 30, `${small.estimate.to}`);
  // Where fits are known to be quick here, nobody has to do with less.
  assert.equal(proposal(large, [1, 1.1, 1].map((seconds) => done({ seconds: seconds / 2 }))), undefined);
  // Where they are slow, even fewer points; and never so few that it would be no other fit.
  assert.equal(proposal(large, [done({ seconds: 20 })]).points, 50_000);
});

test("a subsample is no more than the cloud has", () => {
  assert.deepEqual([{}, { subsample: 0 }, { subsample: 50 }, { subsample: 500 }].map((parameters) => pointsFitted(100, { parameters })), [100, 100, 50, 100]);
});
