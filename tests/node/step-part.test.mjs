// The project's own part from CAD.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadCad } from "../../bin/cli/cad.mjs";
import { areasOfPart, partAsStep } from "../../www/shared/step-part.mjs";

test("the part is read whole, its faces of the five families and as large as they must be", async () => {
  const cad = await loadCad();
  const part = cad.Part.read(new TextEncoder().encode(partAsStep()));
  const sampled = part.sample("plate", { points: 3000 });
  const { faces, lost, warnings } = sampled.report();
  assert.equal(lost, 0);
  assert.deepEqual(warnings, []);
  const types = faces.map(({ type }) => type);
  assert.deepEqual(types, ["Plane", "Plane", "Plane", "Plane", "Plane", "Plane", "Cylinder", "Cone", "Sphere", "Torus", "Cylinder", "Plane"]);
  areasOfPart().forEach((area, at) => {
    // Bounds are laid out to within some millionths of the part.
    assert.ok(Math.abs((faces[at]?.area ?? 0) / area - 1) < 1e-4, `${types[at]}: ${faces[at]?.area} for ${area}`);
    assert.equal(faces[at]?.remark, "");
  });
  sampled.free();
  part.free();
});
