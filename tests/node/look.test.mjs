// What the engine hands to the view besides points and labels.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadEngine } from "../../bin/cli/engine.mjs";

const engine = await loadEngine();

/**
 * The part with its truth; released when the test ends.
 * @param {import("node:test").TestContext} t
 * @param {string} name
 */
function part(t, name) {
  const model = engine.Model.generate(name, {});
  t.after(() => model.free());
  return model;
}

test("there is a unit normal for every point", (t) => {
  const model = part(t, "bracket");
  const normals = model.normals();
  assert.equal(normals.length, model.positions().length);
  for (let at = 0; at < normals.length; at += 3) {
    assert.ok(Math.abs(Math.hypot(...normals.subarray(at, at + 3)) - 1) < 1e-5);
  }
});

test("every surface of a part has a patch around its points", (t) => {
  const model = part(t, "bracket");
  const positions = model.positions();
  const { offsets, indices } = model.members();
  model.primitives().forEach((primitive, place) => {
    const patch = model.patch(place);
    assert.ok(patch, `${primitive.type} ${primitive.number}`);
    assert.equal(patch.normals.length, patch.positions.length);
    assert.equal(patch.lines.length, 6 * patch.marks.length);
    assert.ok(patch.triangles.every((corner) => corner < patch.positions.length / 3));
    // As large as the points it covers, in each direction.
    for (const axis of [0, 1, 2]) {
      const members = indices.subarray(offsets[place], offsets[place + 1]);
      /** @param {ArrayLike<number>} values */
      const extent = (values) => [Math.min(...Array.from(values)), Math.max(...Array.from(values))];
      const points = extent(Array.from(members, (index) => positions[3 * index + axis]));
      const mesh = extent(patch.positions.filter((_, at) => at % 3 === axis));
      for (const end of [0, 1]) assert.ok(Math.abs(points[end] - mesh[end]) < 0.35 * (points[1] - points[0]) + 0.05);
    }
    /** @type {Record<string, number[]>} */
    const marked = { Plane: [0], Cylinder: [0, 1, 2], Cone: [0, 1, 2, 3], Sphere: [2, 3], Torus: [1, 2, 3] };
    for (const mark of marked[primitive.type ?? ""]) assert.ok(patch.marks.includes(mark), `${primitive.type} without ${mark}`);
  });
});

test("a primitive that is not there has no patch, a method that is not there is an error", (t) => {
  const model = part(t, "bracket");
  assert.equal(model.patch(1_000_000), undefined);
  assert.throws(() => model.patch(0, "nobody"), /nobody/);
});
