// How time and memory grow with models, points and primitives, at the engine's level: reading and
// scoring, in one thread.

import { evaluate, scoredBy } from "../../../bin/cli/evaluate.mjs";
import { loadEngineApart } from "../../../bin/cli/engine.mjs";
import { scoresOf } from "../../../www/shared/formats/measures.mjs";

/** Time that grows with a power of the size up to this is near linear; that of the square is 2. */
const NEAR_LINEAR = 1.25;

/** @typedef {import("../../../bin/cli/engine.mjs").Engine} Engine */
/** @typedef {import("../../../bin/engine/engine.js").Role} Role */
/** @typedef {() => void | Promise<void>} Body */

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {{ quick: boolean }} options
 */
export async function measureEngine(bench, { quick }) {
  /** @param {number[]} sizes */
  const few = (sizes) => (quick ? sizes.slice(0, 2) : sizes);
  await grow(bench, "models", "models, scored against themselves", few([1_000, 5_000, 10_000]), manyModels);
  await grow(bench, "points", "points, listed by 100 planes", few([300_000, 1_000_000, 3_000_000]), manyPoints);
  await grow(bench, "primitives", "primitives, all sharing one point", few([1_000, 10_000, 100_000]), sharedPoint);
}

/**
 * Does the work at each size on an engine of its own, so that memory is that of the work.
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {string} unit
 * @param {string} title
 * @param {number[]} sizes
 * @param {(engine: Engine, size: number) => Body} work
 */
async function grow(bench, unit, title, sizes, work) {
  const found = [];
  for (const size of sizes) {
    const { engine, memory } = await loadEngineApart();
    const body = work(engine, size);
    const before = memory.buffer.byteLength;
    const start = process.cpuUsage();
    await body();
    const { user, system } = process.cpuUsage(start);
    const seconds = (user + system) / 1e6;
    found.push({ size, seconds, megabytes: (memory.buffer.byteLength - before) / 2 ** 20 });
  }
  const [first, last] = [found[0], found.at(-1)];
  const power = first && last ? Math.log(last.seconds / first.seconds) / Math.log(last.size / first.size) : NaN;
  bench.table({
    title,
    head: [unit, "seconds", "memory, MiB", "µs each"],
    rows: found.map(({ size, seconds, megabytes }) => [
      String(size),
      seconds.toFixed(2),
      megabytes.toFixed(0),
      ((1e6 * seconds) / size).toFixed(1),
    ]),
  });
  bench.figure(`time grows with the power of ${unit}`, power, "", { most: NEAR_LINEAR });
}

/**
 * Small models under many names: read, scored and summed up.
 * @param {Engine} engine
 * @param {number} count
 * @returns {Body}
 */
function manyModels(engine, count) {
  const model = engine.Model.generate("flange", { spacing: 0.1 });
  const texts = /** @type {[Role, string][]} */ (Object.entries(model.write()));
  model.free();
  const written = texts.map(([role, text]) => ({ role, bytes: new TextEncoder().encode(text) }));
  const files = Array.from({ length: count }, (_, at) =>
    written.map(({ role, bytes }) => ({
      path: engine.pathOf("beside", `PC${at + 1}`, role),
      size: bytes.length,
      read: () => bytes,
    })),
  ).flat();
  return async () => {
    const { results } = await evaluate(engine, files, { report: scoredBy("definition"), self: true });
    const [summary] = engine.summarise(scoresOf(results));
    if (summary?.models !== count) {
      throw new Error(`${summary?.models} models were scored, not ${count}`);
    }
  };
}

/**
 * Squares of points one above the other, each a plane.
 * @param {Engine} engine
 * @param {number} count
 */
function manyPoints(engine, count) {
  const planes = 100;
  const each = count / planes;
  const side = Math.ceil(Math.sqrt(each));
  /** @type {string[]} */
  const rows = [];
  /** @type {string[]} */
  const lists = [];
  for (let plane = 0; plane < planes; plane += 1) {
    /** @type {number[]} */
    const list = [];
    for (let at = 0; at < each; at += 1) {
      rows.push(`[${at % side}.25, ${Math.floor(at / side)}.5, ${plane}]`);
      list.push(rows.length);
    }
    lists.push(`Primitive${plane + 1}:=[${list.join(" ")}];\n`);
  }
  /** @param {number} plane */
  const surface = (plane) => `Primitive${plane + 1}:=[Plane, [0 0 1 ${-plane}]];\n`;
  return scored(engine, {
    cloud: `Points:=[\n${rows.join(", \n")} \n ];\n`,
    primitives: lists.join(""),
    implicit: lists.map((_, plane) => surface(plane)).join(""),
  });
}

/**
 * Every primitive lists the first point and one of its own.
 * @param {Engine} engine
 * @param {number} count
 */
function sharedPoint(engine, count) {
  const places = Array.from({ length: count }, (_, at) => at);
  return scored(engine, {
    cloud: `Points:=[\n${["[0, 0, 0]", ...places.map((at) => `[${at}.5, 1, 0]`)].join(", \n")} \n ];\n`,
    primitives: places.map((at) => `Primitive${at + 1}:=[1 ${at + 2}];\n`).join(""),
    implicit: places.map((at) => `Primitive${at + 1}:=[Plane, [0 0 1 0]];\n`).join(""),
  });
}

/** @param {Uint8Array} bytes */
function contentOf(bytes) {
  return { size: bytes.length, read: () => bytes };
}

/**
 * Reads a model of these texts and scores it against itself.
 * @param {Engine} engine
 * @param {Partial<Record<Role, string>>} texts
 * @returns {Body}
 */
function scored(engine, texts) {
  const inputs = /** @type {[Role, string][]} */ (Object.entries(texts)).map(([role, text]) => ({
    path: engine.pathOf("beside", "PC1", role),
    role,
    ...contentOf(new TextEncoder().encode(text)),
  }));
  return () => {
    const model = engine.Model.read("PC1", inputs);
    const { mean } = model.score(undefined, "definition");
    model.free();
    if (mean.DSC !== 1) {
      throw new Error(`the truth scored ${mean.DSC} against itself`);
    }
  };
}
