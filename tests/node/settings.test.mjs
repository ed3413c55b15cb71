import assert from "node:assert/strict";
import { test } from "node:test";

/** @type {Map<string, string>} */
const kept = new Map();
// As much of a browser as the settings ask for.
Object.assign(globalThis, {
  localStorage: {
    /** @param {string} key */
    getItem: (key) => kept.get(key) ?? null,
    /** @param {string} key @param {string} value */
    setItem: (key, value) => kept.set(key, value),
  },
  matchMedia: () => ({ matches: false, addEventListener() {} }),
  document: { documentElement: { dataset: {} } },
});

const { pageModule } = await import("./page.mjs");
const { keepSettings, lend, remembered, takeBack } = await pageModule("state/settings.ts");
keepSettings();

let count = 0;
function setting() {
  const key = `test-${(count += 1)}`;
  const value = remembered(key, "definition", ["definition", "published", "other"]);
  return { value, kept: () => kept.get(`fit4cad.${key}`) };
}

test("what the reader chooses is remembered, what a link shows with is not", () => {
  const { value, kept: remembers } = setting();
  value.value = "other";
  assert.equal(remembers(), "other");
  lend(value, "published");
  assert.equal(value.value, "published");
  assert.equal(remembers(), "other");
  takeBack();
  assert.equal(value.value, "other");
  assert.equal(remembers(), "other");
});

test("one link after the other: the reader's own choice comes back", () => {
  const { value } = setting();
  lend(value, "published");
  lend(value, "other");
  takeBack();
  assert.equal(value.value, "definition");
});

test("what the reader chooses while something is lent stays, and is remembered", () => {
  const { value, kept: remembers } = setting();
  lend(value, "published");
  value.value = "other";
  assert.equal(remembers(), "other");
  takeBack();
  assert.equal(value.value, "other");
  // Also a choice of the very thing that had been lent.
  lend(value, "published");
  value.value = "other";
  value.value = "published";
  assert.equal(remembers(), "published");
});

test("lending what is chosen already changes nothing", () => {
  const { value, kept: remembers } = setting();
  lend(value, "definition");
  value.value = "other";
  takeBack();
  assert.equal(value.value, "other");
  assert.equal(remembers(), "other");
});
