// Small inputs that have gone wrong in programs of the field, where they are at hand: what both methods find in them.

import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT } from "../../scripts/lib/paths.mjs";
import { fit4cad, folder } from "./support.mjs";

const CASES = join(process.env.FIT4CAD_SHARED ?? join(ROOT, "../shared"), "cases");
const skip = !existsSync(CASES) && "there are no cases in ../shared/cases";

/**
 * How each begins, what surfaces it has at least, at most how many are found, and the least DSC.
 * @type {readonly [begins: string, types: Readonly<Record<string, number>>, most: number, dsc: number][]}
 */
const RIGHT = [
  ["01", { Plane: 3 }, 6, 1],
  ["02a", { Plane: 1 }, 1, 0.99],
  ["02b", { Cylinder: 1 }, 1, 0.99],
  ["02c", { Plane: 2, Cylinder: 1, Sphere: 1 }, 4, 0.97],
  ["03", { Plane: 2, Cylinder: 1, Sphere: 1 }, 4, 0.97],
  // Their rims are on four more planes, of which nothing else is seen.
  ["04a", { Plane: 2 }, 6, 1],
  ["05a", { Plane: 2, Cylinder: 1 }, 3, 0.96],
  ["06", { Plane: 2, Cylinder: 1 }, 3, 0.915],
  ["07a", { Cylinder: 1 }, 1, 1],
  // The pipe parts the ground in two.
  ["08", { Plane: 1, Cylinder: 1, Sphere: 1 }, 4, 0.95],
];

for (const [begins, types, most, dsc] of RIGHT) {
  test(`case ${begins} is what it is, by both methods`, { skip }, (t) => {
    const path = join(CASES, readdirSync(CASES).find((name) => name.startsWith(begins)) ?? "");
    for (const method of ["ht", "pg"]) {
      const out = folder(t, {});
      const [fitted] = JSON.parse(fit4cad("fit", "--method", method, "--json", "--out", out, path).out);
      for (const [type, count] of Object.entries(types)) assert.ok(fitted.types[type] >= count, `${method}: ${JSON.stringify(fitted.types)}`);
      assert.ok(fitted.primitives.length <= most, `${method}: ${fitted.primitives.length}`);
      const [report] = JSON.parse(fit4cad("score", path, out, "--json").out);
      assert.ok(report.mean.DSC >= dsc, `${method}: ${report.mean.DSC}`);
    }
  });
}
