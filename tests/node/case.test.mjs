import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";
import { loadEngine } from "../../bin/cli/engine.mjs";

const { lassoOf, depthOf } = await pageModule("studio/lasso.ts");
const { isCase, readCase, writeCase } = await pageModule("studio/link/link.ts");
const { blockOf, moved, reshaped } = await pageModule("studio/blocks.ts");

const { Model, shapes } = await loadEngine();

const COARSE = { spacing: 0.03 };
const cuboid = { operation: "add", shape: "cuboid", sizes: [60, 40, 20], position: [0, 0, 0], rotation: [0, 0, 0] };
const hole = { operation: "cut", shape: "cylinder", sizes: [8, 60], position: [0, 0, 0], rotation: [0, 90, 0] };

const typesOf = (model) => model.primitives().map(({ type }) => type).sort();

test("a part is composed of blocks", () => {
  const model = Model.compose("mine", [cuboid, hole], COARSE);
  assert.equal(model.info().name, "mine");
  assert.deepEqual(typesOf(model), ["Cylinder", "Plane", "Plane", "Plane", "Plane", "Plane", "Plane"]);
});

test("every shape the engine offers can be built with its default sizes", () => {
  for (const shape of shapes()) {
    const model = Model.compose(shape.name, [blockOf(shape)], COARSE);
    assert.ok(model.primitives().length > 0, shape.name);
  }
});

test("a block that makes no solid is named with what is wrong", () => {
  const compose = (blocks) => () => Model.compose("mine", blocks, COARSE);
  assert.throws(compose([cuboid, { ...hole, sizes: [0, 60] }]), /block 2 \(Cylinder\): its radius must be positive/);
  assert.throws(compose([{ ...cuboid, shape: "pyramid" }]), /no shape `pyramid`; choose one of cuboid/);
  assert.throws(compose([{ ...cuboid, position: [0, 0] }]), /position is made of 3 numbers/);
  assert.throws(compose([hole]), /nothing is left/);
  assert.throws(compose([]), /nothing is left/);
});

test("a cut takes points away and the truth follows", () => {
  const model = Model.compose("mine", [cuboid, hole], COARSE);
  const rest = model.withoutBall(Float64Array.of(0, 0, 0), 12);
  assert.ok(rest.info().points < model.info().points);
  assert.deepEqual(typesOf(rest), typesOf(model));
  assert.ok(Array.from(rest.distances()).every((distance) => distance < 1e-6));
  // All of the bore, and of the box only what lies around its mouths.
  const bare = model.withoutLasso(
    Float64Array.of(0, 0, 0, 0, Math.SQRT1_2, 0, Math.SQRT1_2, Infinity, Infinity),
    Float64Array.of(-9, -9, 9, -9, 9, 9, -9, 9),
  );
  assert.deepEqual(typesOf(bare), Array(6).fill("Plane"));
  assert.throws(() => model.withoutBall(Float64Array.of(1), 1), /centre is made of 3 numbers/);
  const above = Float64Array.of(0, 0, 0, 0, 0, 0, 1, Infinity, Infinity);
  assert.throws(() => model.withoutLasso(above, Float64Array.of(0, 0, 1, 0, 1, 1, 0)), /every corner is made of 2 numbers/);
});

test("a curve on the screen cuts what lies behind it", () => {
  const model = Model.compose("mine", [cuboid], COARSE);
  // From above, a perspective camera 100 units high at the target.
  const camera = { target: [0, 0, 10], rotation: [0, 0, 0, 1], height: 100, projection: "perspective" };
  const screen = { width: 400, height: 200, camera, centre: [0, 0, 0] };
  // At 2 pixels a unit: a quarter of the top, from its middle to beyond its corner.
  const lasso = lassoOf([[200, 100], [300, 100], [300, 40], [250, 40], [200, 40]], screen);
  assert.equal(lasso.corners.length, 4, "a corner on a straight line is left out");
  const cut = (of) => {
    const { target, rotation, eye, depth, corners } = of;
    return model.withoutLasso(Float64Array.from([...target, ...rotation, eye, depth]), Float64Array.from(corners.flat()));
  };
  const shares = (rest) => {
    const { offsets } = rest.members();
    return rest.primitives().map((_, place) => offsets[place + 1] - offsets[place]);
  };
  const through = shares(cut(lasso));
  const above = shares(cut({ ...lasso, depth: 1 }));
  const whole = shares(model);
  const lost = whole.map((count, place) => (count - above[place]) / count);
  assert.equal(lost.filter((share) => share > 0.2 && share < 0.3).length, 1, "a quarter of the top");
  assert.ok(through.filter((count, place) => count < whole[place]).length > above.filter((count, place) => count < whole[place]).length - 1);
  assert.ok(Math.abs(depthOf(lasso, [3, 4, -5]) - 15) < 1e-9);
});

test("a curve that encloses nothing is no lasso", () => {
  const camera = { target: [0, 0, 0], rotation: [0, 0, 0, 1], height: 1, projection: "orthographic" };
  const screen = { width: 100, height: 100, camera, centre: [0, 0, 0] };
  assert.equal(lassoOf([], screen), undefined);
  assert.equal(lassoOf([[1, 1], [50, 50], [90, 90]], screen), undefined);
  assert.equal(lassoOf([[1, 1], [50, 1], [50, 50]], screen).eye, Infinity);
});

const CASE = {
  base: {
    kind: "blocks",
    blocks: [
      { operation: "add", shape: "rounded", sizes: [80, 50, 12, 10], position: [0, 0, 6], rotation: [0, 0, 0] },
      { operation: "add", shape: "cone", sizes: [18, 13, 26], position: [0, 0, 25], rotation: [0, 0, 0] },
      { operation: "cut", shape: "cylinder", sizes: [7, 60], position: [0, 0, 20], rotation: [0, 0, 0] },
    ],
  },
  name: "Gehäuse 1",
  sampling: { spacing: 0.0077, noise: 0.001, outliers: 0.05, seed: 12 },
  cuts: [
    { kind: "ball", centre: [1, 2.5, -3], radius: 0.1 },
    {
      kind: "lasso",
      target: [0, 0, 1 / 3],
      rotation: [0.5, 0.5, 0.5, 0.5],
      eye: Infinity,
      depth: 12.25,
      corners: [[0, 0], [Math.fround(0.1), 0], [0, -1.5]],
    },
  ],
};

test("a case comes out of a link as it went in", () => {
  const fragment = writeCase(CASE);
  assert.match(fragment, /^#case=1\.[\w-]+$/);
  assert.ok(isCase(fragment));
  assert.deepEqual(readCase(fragment), CASE);
  const sample = { ...CASE, base: { kind: "sample", part: "flange" }, cuts: [] };
  assert.deepEqual(readCase(writeCase(sample)), sample);
});

/** As the first page with a studio wrote it. */
const VERSION_1 = "#case=1.DeaSmJ8D43JPzTi8pLQ4VcGQgZmBvSi_NC8lNYWFAQxCHCC0J5TWgNIqUBodSOAQBwKW5Py8VGYI2wiqTAtKW-HQZonTOEaO5MqcTKBLi5ggAjJQpX44tJjgNOoSwz0mzq56-z8rP17yTQqwnzUTBFbaw3wMtYDhA1SEBWoSxwGIyp32jOhGhoLBVaiGB7hpiM4GDQdowDAwnD1zxhZh0IH9AA";

test("a link of version 1 stays readable", () => {
  assert.deepEqual(readCase(VERSION_1), CASE);
});

test("a damaged link says so, whatever is wrong with it", () => {
  const fragment = writeCase(CASE);
  assert.throws(() => readCase("#case="), /does not say which version/);
  assert.throws(() => readCase("#share=1.abc"), /does not say which version/);
  assert.throws(() => readCase(fragment.replace("=1.", "=2.")), /newer version/);
  for (let at = 8; at < fragment.length - 1; at += 7) {
    const other = fragment[at] === "A" ? "B" : "A";
    assert.throws(() => readCase(fragment.slice(0, at) + other + fragment.slice(at + 1)), /damaged/);
    assert.throws(() => readCase(fragment.slice(0, at)), /damaged/);
  }
});

test("a case made of files fits into no link, nor do too many cuts", () => {
  const files = { ...CASE, base: { kind: "files", source: { key: "", name: "", files: [] } } };
  assert.throws(() => writeCase(files), /generated/);
  const [ball] = CASE.cuts;
  const balls = Array.from({ length: 6000 }, (_, i) => ({ ...ball, radius: Math.sin(i) }));
  assert.throws(() => writeCase({ ...CASE, cuts: balls }), RangeError);
});

test("blocks change shape and place without losing what they share", () => {
  const [box, , , bar] = shapes();
  const other = reshaped({ ...blockOf(bar), sizes: [3, 70] }, bar, box);
  assert.deepEqual(other.sizes, [box.defaults[0], box.defaults[1], 70]);
  assert.deepEqual(moved(["a", "b", "c"], 1, -1), ["b", "a", "c"]);
  assert.deepEqual(moved(["a", "b", "c"], 2, 1), ["a", "b", "c"]);
});
