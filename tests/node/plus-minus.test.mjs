import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { offBy, plusMinus } = await pageModule("primitives/plus-minus.ts");

test("a number has the digits that its standard error leaves sure", () => {
  assert.equal(plusMinus(5.0234, 0.0123), "5.02 ± 0.01");
  assert.equal(plusMinus(123.4, 26), "123 ± 26");
  assert.equal(plusMinus(12.345, 0.0972), "12.3 ± 0.1");
  assert.equal(plusMinus(0.012345, 0.00031), "0.0123 ± 0.0003");
});

test("no more digits are shown than are read, and an error far below has a power of ten", () => {
  assert.equal(plusMinus(5.0234, 2.3e-9), "5.0234 ± 2e−9");
  assert.equal(offBy(0.00321), "± 0.003");
  assert.equal(offBy(3.21e-8), "± 3e−8");
});

test("what is not known is not told", () => {
  for (const error of [undefined, null, 0, NaN, Infinity]) {
    assert.equal(plusMinus(5.0234, error), "5.0234");
    assert.equal(offBy(error), "");
  }
});
