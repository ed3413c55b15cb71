import assert from "node:assert/strict";
import { test } from "node:test";
import { pageModule } from "./page.mjs";

const { distanceScale, labelling } = await pageModule("stage/colouring.ts");

/**
 * A segmentation of lists of points, with the distance of every listed point.
 * @param {number[][]} lists
 * @param {number[][]} distances
 */
function segmentation(lists, distances = lists) {
  const offsets = [0];
  for (const list of lists) offsets.push((offsets.at(-1) ?? 0) + list.length);
  return {
    primitives: lists.map((_, place) => ({ number: place + 1, type: ["Plane", "Cylinder", "Cone", "Sphere"][place] })),
    offsets: Uint32Array.from(offsets),
    indices: Uint32Array.from(lists.flat()),
    distances: Float32Array.from(distances.flat()),
  };
}

/** Neighbours share the points of their common edge, all three the corner. */
const TRUTH = [[0, 1, 2, 9], [2, 3, 4, 9], [4, 5, 0, 9]];
const POINTS = 10;

/**
 * What a model shows whose submission lists the true primitives of these places, in this order.
 * @param {number[]} order
 * @param {number[][]} extra
 */
function shown(order, extra = []) {
  const predictions = order.map((_, place) => ({ prediction: place + 1 }));
  const primitives = TRUTH.map((_, truth) => ({ truth: truth + 1, match: order.includes(truth) ? order.indexOf(truth) + 1 : null }));
  return {
    scene: {
      cloud: "",
      positions: new Float32Array(3 * POINTS),
      truth: segmentation(TRUTH, TRUTH.map((list, place) => list.map(() => place))),
      prediction: segmentation([...order.map((truth) => TRUTH[truth]), ...extra], [...order.map((truth) => TRUTH[truth].map(() => truth)), ...extra]),
      rival: undefined,
    },
    reports: { prediction: { primitives, predictions: [...predictions, ...extra.map((_, at) => ({ prediction: order.length + at + 1 }))] } },
    selected: undefined,
  };
}

/** @param {{ labels: Uint32Array, colours: unknown[] }} labelling */
const seen = ({ labels, colours }) => Array.from(labels, (label) => colours[label]);

test("a perfect prediction looks like the truth where primitives share points, in whatever order it lists them", () => {
  for (const order of [[0, 1, 2], [2, 1, 0], [1, 2, 0]]) {
    const all = shown(order);
    assert.deepEqual(seen(labelling("segments", "prediction", all)), seen(labelling("segments", "truth", all)), String(order));
    const [truth, prediction] = ["truth", "prediction"].map((side) => labelling("distance", side, all).scalars.values);
    assert.deepEqual(prediction, truth, "distances");
  }
});

test("a prediction without a match does not cover one that has a match", () => {
  const all = shown([1, 0], [[0, 1, 2, 3, 5]]);
  const { labels } = labelling("segments", "prediction", all);
  assert.deepEqual(Array.from(labels), [2, 2, 2, 1, 1, 3, 0, 0, 0, 2]);
});

test("a scale of distances ends where most points lie, on the side where they lie farthest", async () => {
  const { usualDistance } = await pageModule("../worker/usual.ts");
  const far = Float32Array.from({ length: 101 }, (_, at) => (at < 98 ? at / 100 : 50));
  assert.equal(usualDistance(far).toFixed(2), "0.95");
  assert.equal(usualDistance(Float32Array.of(NaN, NaN)), 0);
  assert.equal(usualDistance(Float32Array.of(NaN, 3)), 3);
  const side = (/** @type {number} */ usual, /** @type {number} */ farthest) => ({ usual, farthest });
  assert.deepEqual(distanceScale({ truth: side(0, 0.1), prediction: side(0.4, 50), rival: undefined }), { end: 0.4, more: true });
  assert.deepEqual(distanceScale({ truth: side(0, 0.1), prediction: undefined, rival: undefined }), { end: 0.1, more: false });
  assert.deepEqual(distanceScale({ truth: undefined, prediction: undefined, rival: undefined }), { end: 1, more: false });
});
