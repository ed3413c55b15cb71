import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { rounded } = await pageModule("studio/rounding.ts");
const { afterKey, cornersOf, MIDDLE, wordsFor } = await pageModule("studio/rectangle.ts");
const { thinness } = await pageModule("studio/thin.ts");

test("places are rounded by the size of the cloud, however far it is from the origin", () => {
  const place = [5_000_000.123456, -0.1234567, 1 / 3];
  assert.deepEqual(rounded(place, 100), [5_000_000.12346, -0.12346, 0.33333]);
  assert.deepEqual(rounded(place, 1e-3), [5_000_000.123456, -0.1234567, 0.3333333333]);
  assert.deepEqual(rounded(place, 1e9), [5_000_000, -0, 0]);
  assert.deepEqual(rounded([1, 2, 3], 0), [1, 2, 3]);
});

test("keys move and size the rectangle, which stays in the view", () => {
  let at = MIDDLE;
  for (let press = 0; press < 100; press += 1) at = afterKey(at, "ArrowLeft", false);
  assert.equal(at.x, 0);
  for (let press = 0; press < 100; press += 1) at = afterKey(at, "ArrowUp", true);
  assert.equal(at.height, 0.02);
  assert.equal(wordsFor(at), "Rectangle 30 % wide and 2 % high, its middle 0 % from the left and 50 % from the top");
  assert.deepEqual(afterKey(at, "Home", false), MIDDLE);
  assert.equal(afterKey(at, "Tab", false), undefined);
  assert.deepEqual(cornersOf({ x: 0.5, y: 0.25, width: 0.5, height: 0.1 }, { width: 400, height: 200 }), [
    [100, 40],
    [300, 40],
    [300, 60],
    [100, 60],
  ]);
});

test("primitives with too few points are told by number or count", () => {
  /**
   * @param {number[]} primitives
   * @param {number} distance
   */
  const thin = (primitives, distance) => thinness({ primitives, fewest: 10, distance }, 3);
  assert.match(thin([2, 4], 12.3456), /^2 of 3 primitives have fewer than 10 points.*Points lie 12 apart/);
  assert.match(thin([4], 1), /^Primitive 4 has fewer/);
  assert.equal(thin([], 1), undefined);
});
