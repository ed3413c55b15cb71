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

test("a section has the points near its plane, and curves through them that lie on the plane within the part", (t) => {
  const model = part(t, "bracket");
  const positions = model.positions();
  const [x0, y0, z0] = model.centre();
  const section = model.section(2, 0.02, 0.01);
  assert.ok(section);
  assert.ok(section.points.length > 0 && section.curves.length > 0);
  section.points.forEach((index, at) => {
    const [x, y, z] = positions.subarray(3 * index, 3 * index + 3);
    assert.ok(Math.abs(z + z0 - section.at) <= section.thickness / 2 + 1e-5);
    assert.ok(Math.abs(x - section.positions[2 * at]) < 1e-4 && Math.abs(y - section.positions[2 * at + 1]) < 1e-4);
  });
  assert.ok(Math.abs(section.middle[0] - x0) < 1e-9 && Math.abs(section.middle[1] - y0) < 1e-9);
  const primitives = model.primitives();
  for (const { place, meeting, positions: curve, chains } of section.curves) {
    assert.equal(chains.at(-1), curve.length / 2);
    for (let at = 0; at < curve.length; at += 1) assert.ok(Math.abs(curve[at]) <= section.size[at % 2] / 2 + 1e-3);
    const { type, surface } = primitives[place];
    if (type === "Plane") assert.equal(meeting, "line");
    if (surface?.type === "Cylinder" && Math.abs(surface.axis[2]) > 0.999) assert.equal(meeting, `circle of radius ${Number(surface.radius.toPrecision(5))}`);
  }
  assert.throws(() => model.section(0, 0.5, 0.01, "nobody"), /nobody/);
});

test("the points in the intervals of a histogram are as many as it counts", (t) => {
  const model = part(t, "bracket");
  const method = model.imperfect(1);
  const wanted = [{ places: [0, 1, 2] }, { method, places: model.primitives(method).map((_, place) => place) }];
  const bins = 24;
  const { counts } = model.histogram(wanted, bins, true);
  const found = model.pointsInBins(wanted, bins, true, 16, 19);
  found.forEach((points, at) => {
    const bars = Array.from(counts[at]).filter((_, place) => place % bins >= 16 && place % bins <= 19);
    assert.equal(points.length, bars.reduce((sum, count) => sum + count, 0));
    assert.ok(points.every((index, place) => place === 0 || index > points[place - 1]));
  });
  assert.ok(found[1].length > 0);
  assert.equal(model.pointsInBins(wanted, bins, true, 5, 4)[1].length, 0);
});
