// Whether an answer stays with the points: moving, turning and scaling a cloud, and listing
// its points in another order, change nothing it shows.

import { strToU8 } from "fflate";
import { mean } from "../../lib/bench.mjs";
import { held } from "../../lib/input.mjs";
import { METHODS } from "./fitted.mjs";
import { evenly } from "./models.mjs";

/** @typedef {import("../../../bin/engine/engine.js").Model} Model */
/** @typedef {import("./fitted.mjs").Method} Method */
/** @typedef {[number, number, number]} Vector */
/** @typedef {[number, number, number, number]} Quaternion */
/** @typedef {{ label: string, turn?: Quaternion, factor?: number, away?: number, shuffled?: boolean }} Similarity */
/** @typedef {{ name: string, share: number }} Change */
/** The points of each primitive. @typedef {readonly Uint32Array[]} Lists */

/** Share of the points of a model whose labels may change. */
const MOST = 0.005;
/**
 * A turn about no special axis by no special angle, as a unit quaternion.
 * @type {Quaternion}
 */
const TURN = quaternion([0.31, -0.62, 0.47, 0.55]);
/**
 * In order of doing: a turn, a factor, a way to go in diagonals of the cloud that results, a shuffle.
 * @type {readonly Similarity[]}
 */
const CASES = [
  { label: "moved by three diagonals", away: 3 },
  { label: "turned", turn: TURN },
  { label: "times 1000", factor: 1000 },
  { label: "turned, times 0.001 and moved", turn: TURN, factor: 0.001, away: 3 },
  { label: "shuffled", shuffled: true },
];
/** @type {Vector} */
const WAY = [0.48, -0.6, 0.64];

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {import("./models.mjs").Known} known
 * @param {{ most: number }} how
 */
export function motion(bench, { real, list }, { most }) {
  const chosen = evenly(list, most);
  const changes = CASES.map((each) => ({ each, ...noChanges() }));
  for (const { name, open } of chosen) {
    const model = open();
    const still = answers(model);
    for (const of of changes) {
      const moved = similar(bench.engine, model, of.each);
      const { points } = moved.info();
      const other = answers(moved, of.each.shuffled ? scattered(points) : undefined);
      moved.free();
      for (const method of METHODS) {
        of[method].push({ name, share: changed(still[method], other[method]) / points });
      }
    }
    model.free();
  }
  const columns = ["mean", "worst", "in", `models over ${100 * MOST} %`];
  bench.table({
    title: `The same clouds moved, turned and scaled: ${chosen.length} ${real ? "training models" : "generated parts"}`,
    note: "Share of the points that are in other primitives than before, primitives being paired by the points they share.",
    head: ["", ...METHODS.flatMap((method) => columns.map((column) => `${method.toUpperCase()} ${column}`))],
    rows: changes.map(({ each, ...of }) => [each.label, ...METHODS.flatMap((method) => figures(of[method], real))]),
  });
}

/** @returns {Record<Method, Change[]>} */
function noChanges() {
  return { ht: [], pg: [] };
}

/**
 * @param {readonly Change[]} changes
 * @param {boolean} real
 */
function figures(changes, real) {
  const worst = changes.reduce((a, b) => (b.share > a.share ? b : a));
  const text = percent(worst.share);
  return [
    percent(mean(changes.map(({ share }) => share))),
    real ? { text, bar: `≤ ${100 * MOST} %`, met: worst.share <= MOST } : text,
    worst.share > 0 ? worst.name : "none",
    String(changes.filter(({ share }) => share > MOST).length),
  ];
}

/**
 * The point lists that each method finds, of a shuffled model by the indices of the points before.
 * @param {Model} model
 * @param {Uint32Array} [order]
 * @returns {Record<Method, Lists>}
 */
function answers(model, order) {
  /** @param {Method} method */
  const of = (method) => {
    const { offsets, indices } = model.members(model.fit(method, {}, 1, () => {}));
    const before = order ? indices.map((index) => order[index] ?? index) : indices;
    return Array.from(offsets.subarray(1), (end, at) => before.slice(offsets[at], end));
  };
  return { ht: of("ht"), pg: of("pg") };
}

/**
 * How many points are in other lists, once lists are paired, those first that share most points.
 * @param {Lists} before
 * @param {Lists} after
 */
function changed(before, after) {
  const [old, fresh] = [listsByPoint(before), listsByPoint(after)];
  /** @type {Map<number, number>} */
  const shared = new Map();
  for (const [point, lists] of old) {
    for (const a of lists) {
      for (const b of fresh.get(point) ?? []) {
        const key = a * after.length + b;
        shared.set(key, (shared.get(key) ?? 0) + 1);
      }
    }
  }
  /** @type {Map<number, number>} */
  const partner = new Map();
  /** @type {Set<number>} */
  const taken = new Set();
  for (const [key] of [...shared].sort(([a, m], [b, n]) => n - m || a - b)) {
    const [a, b] = [Math.floor(key / after.length), key % after.length];
    if (!taken.has(a) && !partner.has(b)) {
      taken.add(a);
      partner.set(b, a);
    }
  }
  const points = new Set([...old.keys(), ...fresh.keys()]);
  return [...points].filter((point) => {
    const was = old.get(point) ?? [];
    const is = (fresh.get(point) ?? []).map((b) => partner.get(b));
    return was.length !== is.length || is.some((a) => a === undefined || !was.includes(a));
  }).length;
}

/**
 * The places of the lists that hold each point.
 * @param {Lists} lists
 */
function listsByPoint(lists) {
  /** @type {Map<number, number[]>} */
  const of = new Map();
  lists.forEach((points, place) => {
    for (const point of points) {
      of.set(point, [...(of.get(point) ?? []), place]);
    }
  });
  return of;
}

/**
 * The model's bare cloud after a similarity, to the last digit of its numbers.
 * @param {import("../../../bin/cli/engine.mjs").Engine} engine
 * @param {Model} model
 * @param {Similarity} similarity
 */
function similar(engine, model, { turn, factor = 1, away = 0, shuffled = false }) {
  const { name, bounds } = model.info();
  const diagonal = bounds ? Math.hypot(...bounds.max.map((end, at) => end - (bounds.min[at] ?? NaN))) : NaN;
  /** @param {Vector} point */
  const place = (point) => (turn ? turned(turn, point) : point).map((x, at) => factor * (x + away * diagonal * (WAY[at] ?? NaN)));
  const rows = Array.from(
    model.cloud().matchAll(/\[([^[\],]+),([^[\],]+),([^[\],]+)\]/g),
    ([, x, y, z]) => `[${place([Number(x), Number(y), Number(z)]).join(", ")}]`,
  );
  const order = shuffled ? scattered(rows.length) : rows.keys();
  const text = `[${Array.from(order, (index) => rows[index]).join(", ")}]`;
  return engine.Model.read(name, [held({ path: `${name}.txt`, role: "cloud" }, strToU8(text))]);
}

/**
 * All indices, each a golden share of their number from the one before.
 * @param {number} count
 */
function scattered(count) {
  let step = Math.round(count * 0.618034) || 1;
  while (commonDivisor(step, count) > 1) {
    step += 1;
  }
  return Uint32Array.from({ length: count }, (_, at) => (at * step) % count);
}

/**
 * @param {number} a
 * @param {number} b
 * @returns {number}
 */
function commonDivisor(a, b) {
  return b === 0 ? a : commonDivisor(b, a % b);
}

/**
 * @param {Quaternion} parts
 * @returns {Quaternion}
 */
function quaternion([w, x, y, z]) {
  const length = Math.hypot(w, x, y, z);
  return [w / length, x / length, y / length, z / length];
}

/**
 * A point turned by a unit quaternion w + xi + yj + zk: p + 2w(v × p) + 2v × (v × p).
 * @param {Quaternion} turn
 * @param {Vector} point
 * @returns {Vector}
 */
function turned([w, ...v], [x, y, z]) {
  const across = cross(v, [x, y, z]);
  const twice = cross(v, across);
  return [x + 2 * (w * across[0] + twice[0]), y + 2 * (w * across[1] + twice[1]), z + 2 * (w * across[2] + twice[2])];
}

/**
 * @param {Vector} one
 * @param {Vector} other
 * @returns {Vector}
 */
function cross([a, b, c], [x, y, z]) {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

/** @param {number} share */
function percent(share) {
  return `${(100 * share).toFixed(3)} %`;
}
