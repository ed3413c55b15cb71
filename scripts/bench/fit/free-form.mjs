// Points that belong to no simple surface should stay unsegmented: the share that is claimed all the same.

import { METHODS } from "./fitted.mjs";
import { evenly, generated } from "./models.mjs";

/** @typedef {import("./fitted.mjs").Method} Method */
/** @typedef {{ name: string, free: number, claimed: Record<Method, number> }} Claims points */

/** With fewer unsegmented points than this share, a model says nothing about free-form regions. */
const LEAST_SHARE = 0.01;

/**
 * @param {import("../../lib/bench.mjs").Bench} bench
 * @param {import("./models.mjs").Known} known
 * @param {{ most: number }} how
 */
export function freeForm(bench, { real, list }, { most }) {
  const groups = [
    { label: "generated parts", models: evenly(generated(bench.engine), most) },
    ...(real ? [{ label: "training models", models: evenly(list, most) }] : []),
  ];
  const rows = groups.flatMap(({ label, models }) => {
    const found = models.flatMap(({ name, open }) => claimsOf(name, open));
    return [
      ...(found.length > 0 ? [row(`all ${found.length} ${label}`, found)] : []),
      ...found.filter(({ claimed }) => METHODS.some((method) => claimed[method] > 0)).map((each) => row(each.name, [each])),
    ];
  });
  bench.table({
    title: "Free-form regions",
    note: `Points of no true primitive that a method lists, in models with at least ${100 * LEAST_SHARE} % of such points.`,
    head: ["", "unsegmented points", "claimed by HT", "claimed by PG"],
    rows,
  });
}

/**
 * @param {string} label
 * @param {readonly Claims[]} found
 */
function row(label, found) {
  const free = sum(found.map((each) => each.free));
  /** @param {Method} method */
  const share = (method) => `${((100 * sum(found.map(({ claimed }) => claimed[method]))) / free).toFixed(2)} %`;
  return [label, String(free), ...METHODS.map(share)];
}

/**
 * @param {string} name
 * @param {import("./models.mjs").Entry["open"]} open
 * @returns {Claims[]}
 */
function claimsOf(name, open) {
  const model = open();
  try {
    const { points } = model.info();
    const truth = listed(model, undefined, points);
    const free = points - sum(truth);
    if (free < LEAST_SHARE * points) {
      return [];
    }
    /** @param {Method} method */
    const claimed = (method) => {
      const taken = listed(model, model.fit(method, {}, 1, () => {}), points);
      return sum(taken.map((one, at) => one & (1 - (truth[at] ?? 0))));
    };
    return [{ name, free, claimed: { ht: claimed("ht"), pg: claimed("pg") } }];
  } finally {
    model.free();
  }
}

/**
 * 1 for each point that some primitive lists.
 * @param {import("../../../bin/engine/engine.js").Model} model
 * @param {string | undefined} method
 * @param {number} points
 */
function listed(model, method, points) {
  const marks = new Uint8Array(points);
  for (const index of model.members(method).indices) {
    marks[index] = 1;
  }
  return marks;
}

/** @param {ArrayLike<number>} values */
function sum(values) {
  return Array.from(values).reduce((total, value) => total + value, 0);
}
