// Whether an answer stays with the points: moving, turning and scaling a cloud change nothing it shows.

import { strToU8 } from "fflate";
import { mean } from "../../lib/bench.mjs";
import { METHODS } from "./fitted.mjs";
import { evenly } from "./models.mjs";

/** Share of the points of a model whose labels may change. */
const MOST = 0.005;
/** A turn about no special axis by no special angle, as a unit quaternion. */
const TURN = quaternion(0.31, -0.62, 0.47, 0.55);
/** In order of doing: a turn, a factor, and a way to go in diagonals of the cloud that results. */
const CASES = [
  { label: "moved by three diagonals", away: 3 },
  { label: "turned", turn: TURN },
  { label: "times 1000", factor: 1000 },
  { label: "turned, times 0.001 and moved", turn: TURN, factor: 0.001, away: 3 },
];
const WAY = [0.48, -0.6, 0.64];

export function motion(bench, { real, list }, { most }) {
  const chosen = evenly(list, most);
  const changes = CASES.map(() => ({ ht: [], pg: [] }));
  for (const { name, open } of chosen) {
    const model = open();
    const still = answers(model);
    CASES.forEach((each, at) => {
      const moved = similar(bench.engine, model, each);
      const other = answers(moved);
      const { points } = moved.info();
      moved.free();
      for (const method of METHODS) {
        changes[at][method].push({ name, share: changed(still[method], other[method]) / points });
      }
    });
    model.free();
  }
  const columns = ["mean", "worst", "in", `models over ${100 * MOST} %`];
  bench.table({
    title: `The same clouds moved, turned and scaled: ${chosen.length} ${real ? "training models" : "generated parts"}`,
    note: "Share of the points that are in other primitives than before, primitives being paired by the points they share.",
    head: ["", ...METHODS.flatMap((method) => columns.map((column) => `${method.toUpperCase()} ${column}`))],
    rows: CASES.map(({ label }, at) => [label, ...METHODS.flatMap((method) => figures(changes[at][method], real))]),
  });
}

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

/** The point lists that each method finds. */
function answers(model) {
  return Object.fromEntries(
    METHODS.map((method) => {
      const { offsets, indices } = model.members(model.fit(method, {}, 1));
      const lists = Array.from(offsets.subarray(1), (end, at) => indices.slice(offsets[at], end));
      return [method, lists];
    }),
  );
}

/** How many points are in other lists, once lists are paired, those first that share most points. */
function changed(before, after) {
  const [old, fresh] = [before, after].map(listsByPoint);
  const shared = new Map();
  for (const [point, lists] of old) {
    for (const a of lists) {
      for (const b of fresh.get(point) ?? []) {
        const key = a * after.length + b;
        shared.set(key, (shared.get(key) ?? 0) + 1);
      }
    }
  }
  const partner = new Map();
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
    return was.length !== is.length || is.some((a) => !was.includes(a));
  }).length;
}

/** The places of the lists that hold each point. */
function listsByPoint(lists) {
  const of = new Map();
  lists.forEach((points, place) => {
    for (const point of points) {
      of.set(point, [...(of.get(point) ?? []), place]);
    }
  });
  return of;
}

/** The model's bare cloud after a similarity, to the last digit of its numbers. */
function similar(engine, model, { turn, factor = 1, away = 0 }) {
  const { name, bounds } = model.info();
  const diagonal = Math.hypot(...bounds.max.map((end, at) => end - bounds.min[at]));
  const place = (point) =>
    (turn ? turned(turn, point) : point).map((x, at) => factor * (x + away * diagonal * WAY[at]));
  const text = model.cloud().replace(/\[([^[\],]+),([^[\],]+),([^[\],]+)\]/g, (_, ...numbers) => {
    return `[${place(numbers.slice(0, 3).map(Number)).join(", ")}]`;
  });
  return engine.Model.read(name, [{ path: `${name}.txt`, role: "cloud", bytes: strToU8(text) }]);
}

function quaternion(...parts) {
  const length = Math.hypot(...parts);
  return parts.map((part) => part / length);
}

/** A point turned by a unit quaternion w + xi + yj + zk: p + 2w(v × p) + 2v × (v × p). */
function turned([w, ...v], point) {
  const across = cross(v, point);
  const twice = cross(v, across);
  return point.map((x, at) => x + 2 * (w * across[at] + twice[at]));
}

function cross([a, b, c], [x, y, z]) {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

function percent(share) {
  return `${(100 * share).toFixed(3)} %`;
}
