import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";
import { SHAPES } from "../../www/generated/declared/shapes.js";
import { loadEngine } from "../../bin/cli/engine.mjs";

const { isCase, readCase, writeCase } = await pageModule("studio/link/link.ts");
const { blockOf, moved, reshaped } = await pageModule("studio/blocks.ts");

const { Model } = await loadEngine();

const COARSE = { spacing: 0.03 };
/**
 * @typedef {import("../../bin/engine/engine.js").Block} Block
 * @type {Block}
 */
const cuboid = { operation: "add", shape: "cuboid", sizes: [60, 40, 20], position: [0, 0, 0], rotation: [0, 0, 0] };
/** @type {Block} */
const hole = { operation: "cut", shape: "cylinder", sizes: [8, 60], position: [0, 0, 0], rotation: [0, 90, 0] };

/** @param {import("../../bin/engine/engine.js").Model} model */
const typesOf = (model) => model.primitives().map(({ type }) => String(type)).sort();

test("a part is composed of blocks", () => {
  const model = Model.compose("mine", [cuboid, hole], COARSE);
  assert.equal(model.info().name, "mine");
  assert.deepEqual(typesOf(model), ["Cylinder", "Plane", "Plane", "Plane", "Plane", "Plane", "Plane"]);
});

test("every shape the engine offers can be built with its default sizes", () => {
  for (const shape of SHAPES) {
    const model = Model.compose(shape.name, [blockOf(shape)], COARSE);
    assert.ok(model.primitives().length > 0, shape.name);
  }
});

test("a block that makes no solid is named with what is wrong", () => {
  /** @param {Block[]} blocks */
  const compose = (blocks) => () => Model.compose("mine", blocks, COARSE);
  assert.throws(compose([cuboid, { ...hole, sizes: [0, 60] }]), /block 2 \(Cylinder\): its radius must be positive/);
  assert.throws(compose([{ ...cuboid, shape: "pyramid" }]), /no shape `pyramid`; choose one of cuboid/);
  assert.throws(compose([{ ...cuboid, position: /** @type {any} */ ([0, 0]) }]), /position is made of 3 numbers/);
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
  const linked = { of: CASE, engine: "0.1.0" };
  const fragment = writeCase(linked);
  assert.match(fragment, /^#case=2\.[\w-]+$/);
  assert.ok(isCase(fragment));
  assert.deepEqual(readCase(fragment), linked);
  const sample = { of: { ...CASE, base: { kind: "sample", part: "flange" }, cuts: [] } };
  assert.deepEqual(readCase(writeCase(sample)), sample);
});

/** As the first page with a studio wrote it. */
const VERSION_1 = "#case=1.DeaSmJ8D43JPzTi8pLQ4VcGQgZmBvSi_NC8lNYWFAQxCHCC0J5TWgNIqUBodSOAQBwKW5Py8VGYI2wiqTAtKW-HQZonTOEaO5MqcTKBLi5ggAjJQpX44tJjgNOoSwz0mzq56-z8rP17yTQqwnzUTBFbaw3wMtYDhA1SEBWoSxwGIyp32jOhGhoLBVaiGB7hpiM4GDQdowDAwnD1zxhZh0IH9AA";

test("a link of version 1 stays readable", () => {
  assert.deepEqual(readCase(VERSION_1), { of: CASE });
});

/** As the first page whose cases say the engine's version wrote it. */
const VERSION_2 = "#case=2.5WOI8KUDYzXQM9Qz4HJPzTi8pLQ4VcGQgZmBvSi_NC8lNYWFAQxCHCC0J5TWgNIqUBodSOAQBwKW5Py8VGYI2wiqTAtKW-HQZonTOEaO5MqcTKBLi5ggAjJQpX44tJjgNOoSwz0mzq56-z8rP17yTQqwnzUTBFbaw3wMtYDhA1SEBWoSxwGIyp32jOhGhoLBVaiGB7hpiM4GDQdowDAwnD1zxhZh0IH9AA";

test("a link of version 2 stays readable, and says which engine it was made with", () => {
  assert.deepEqual(readCase(VERSION_2), { of: CASE, engine: "0.1.0" });
});

test("a damaged link says so, whatever is wrong with it", () => {
  const fragment = writeCase({ of: CASE });
  assert.throws(() => readCase("#case="), /does not say which version/);
  assert.throws(() => readCase("#share=1.abc"), /does not say which version/);
  assert.throws(() => readCase(fragment.replace("=2.", "=3.")), /newer version/);
  for (let at = 8; at < fragment.length - 1; at += 7) {
    const other = fragment[at] === "A" ? "B" : "A";
    assert.throws(() => readCase(fragment.slice(0, at) + other + fragment.slice(at + 1)), /damaged/);
    assert.throws(() => readCase(fragment.slice(0, at)), /damaged/);
  }
});

test("a case made of files fits into no link, nor do too many cuts", () => {
  const files = { ...CASE, base: { kind: "files", source: { key: "", name: "", files: [] } } };
  assert.throws(() => writeCase({ of: files }), /generated/);
  const [ball] = CASE.cuts;
  const balls = Array.from({ length: 6000 }, (_, i) => ({ ...ball, radius: Math.sin(i) }));
  assert.throws(() => writeCase({ of: { ...CASE, cuts: balls } }), RangeError);
});

test("blocks change shape and place without losing what they share", () => {
  const [box, , , bar] = SHAPES;
  const other = reshaped({ ...blockOf(bar), sizes: [3, 70] }, bar, box);
  assert.deepEqual(other.sizes, [box.defaults[0], box.defaults[1], 70]);
  assert.deepEqual(moved(["a", "b", "c"], 1, -1), ["b", "a", "c"]);
  assert.deepEqual(moved(["a", "b", "c"], 2, 1), ["a", "b", "c"]);
});
