// Time and memory as clouds grow: one part, sampled ever finer.

import { strToU8 } from "fflate";
import { loadEngineApart } from "../../../bin/cli/engine.mjs";
import { timed } from "../../lib/bench.mjs";
import { held } from "../../lib/input.mjs";
import { METHODS } from "./fitted.mjs";

/** @typedef {import("../../../bin/cli/engine.mjs").Engine} Engine */

const PART = "housing";
/** Bytes of memory a point may take at the peak. */
const MOST_BYTES = 250;

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {{ sizes: readonly number[] }} how
 */
export async function growth(bench, { sizes }) {
  /** @type {import("../../lib/bench.mjs").Cell[][]} */
  const rows = [];
  /** @type {Partial<Record<import("./fitted.mjs").Method, number>>} */
  const first = {};
  for (const size of sizes) {
    const cloud = cloudOf(bench.engine, size);
    for (const method of METHODS) {
      const { points, seconds, bytes, primitives } = await fitApart(cloud, method);
      const unit = seconds / (points * Math.log(points));
      const smallest = (first[method] ??= unit);
      const text = (bytes / points).toFixed(0);
      rows.push([
        method.toUpperCase(),
        ...[points, primitives].map(String),
        seconds.toFixed(2),
        (unit / smallest).toFixed(2),
        { text, bar: `≤ ${MOST_BYTES}`, met: bytes / points <= MOST_BYTES },
      ]);
    }
  }
  bench.table({
    title: `Growth: the part “${PART}”, sampled ever finer`,
    note: "n log n: seconds over n log n, against the smallest cloud. Memory: the peak of reading and fitting.",
    head: ["", "points", "primitives", "seconds", "n log n", "bytes a point"],
    rows,
  });
}

/**
 * The text of the part's cloud with about so many points.
 * @param {Engine} engine
 * @param {number} size
 */
function cloudOf(engine, size) {
  /**
   * @param {number} points
   * @param {number} old
   */
  const spacing = (points, old) => old * Math.sqrt(points / size);
  const coarse = 0.0077;
  const probe = engine.Model.generate(PART, { spacing: coarse });
  const { points } = probe.info();
  probe.free();
  const model = engine.Model.generate(PART, { spacing: Math.max(0.0005, spacing(points, coarse)) });
  const bytes = strToU8(model.cloud());
  model.free();
  return bytes;
}

/**
 * Lets the machine code of both methods be made before anything is timed.
 * @param {Engine} engine
 */
export function warmUp(engine) {
  const model = engine.Model.generate(PART, { spacing: 0.02 });
  for (const method of METHODS) {
    model.fit(method, {}, 1, () => {});
  }
  model.free();
}

/**
 * Fits in an instance whose memory nothing else has grown.
 * @param {Uint8Array} bytes
 * @param {import("./fitted.mjs").Method} method
 */
async function fitApart(bytes, method) {
  const { engine, memory } = await loadEngineApart();
  const empty = memory.buffer.byteLength;
  warmUp(engine);
  const model = engine.Model.read(PART, [held({ path: `${PART}.txt`, role: "cloud" }, bytes)]);
  const { value: name, seconds } = timed(() => model.fit(method, {}, 1, () => {}));
  const primitives = model.primitives(name).length;
  const { points } = model.info();
  model.free();
  return { points, seconds, primitives, bytes: memory.buffer.byteLength - empty };
}
