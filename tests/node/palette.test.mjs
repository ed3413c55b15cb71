// The colours that the page uses hold what is said of them.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT } from "../../scripts/lib/paths.mjs";
import { appearances, distance } from "../../scripts/palette.mjs";

const FILES = ["www/shared/palette.mjs", "www/app/view/palette.ts"];
const source = FILES.map((file) => readFileSync(join(ROOT, file), "utf8")).join("\n");

/**
 * The colours of a constant of either file, as they appear to each kind of vision.
 * @param {string} name
 */
function colours(name) {
  const text = new RegExp(`${name}[^=]*= \\[([^\\]]*)\\]`).exec(source)?.[1] ?? "";
  return [...text.matchAll(/#([0-9a-f]{6})/g)].map(([, hex]) => {
    const value = Number.parseInt(hex, 16);
    return appearances([(value >> 16) & 255, (value >> 8) & 255, value & 255]);
  });
}

/**
 * The least distance of any two.
 * @param {readonly import("../../scripts/palette.mjs").Triple[][]} all
 */
function closest(all) {
  return Math.min(...all.flatMap((one, at) => all.slice(at + 1).map((other) => distance(one, other))));
}

test("segment colours can be told apart by normal and colour-blind eyes", () => {
  const all = colours("SEGMENT_COLOURS");
  assert.equal(all.length, 32);
  assert.ok(closest(all.slice(0, 8)) >= 0.11);
  assert.ok(closest(all.slice(0, 16)) >= 0.069);
  assert.ok(closest(all) >= 0.047);
});

test("no segment looks like black or white", () => {
  for (const [[lightness]] of colours("SEGMENT_COLOURS")) {
    assert.ok(lightness > 0.43 && lightness < 0.9, String(lightness));
  }
});

test("the sequential map grows lighter in even steps, whatever the eyes", () => {
  const all = colours("SEQUENTIAL");
  assert.ok(all.length > 8);
  const steps = all.slice(1).map((colour, at) => colour.map(([lightness], vision) => lightness - all[at][vision][0]));
  for (const step of steps) {
    assert.ok(Math.abs(step[0] - (0.93 - 0.26) / (all.length - 1)) < 0.01, String(step[0]));
    assert.ok(step.every((difference) => difference > 0.01), String(step));
  }
});
