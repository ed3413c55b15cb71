import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { share, shortCount } = await pageModule("ui/format.ts");

test("a small share is not written as none, nor a large one as all", () => {
  assert.deepEqual([0, 1e-6, 0.0004, 0.0006, 0.5, 0.9994, 0.99999, 1].map(share), [
    "0.0 %",
    "< 0.1 %",
    "< 0.1 %",
    "0.1 %",
    "50.0 %",
    "99.9 %",
    "> 99.9 %",
    "100.0 %",
  ]);
  assert.equal(share(null), "n/a");
});

test("counts at ticks have a unit only where they need one", () => {
  assert.deepEqual([0, 500, 1000, 1500, 20_000, 2_500_000].map(shortCount), ["0", "500", "1k", "1.5k", "20k", "2.5M"]);
});
