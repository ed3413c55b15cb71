// Points that belong to no simple surface should stay unsegmented: the share that is claimed all the same.

import { METHODS } from "./fitted.mjs";
import { evenly, generated } from "./models.mjs";

/** With fewer unsegmented points than this share, a model says nothing about free-form regions. */
const LEAST_SHARE = 0.01;

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

function row(label, found) {
  const free = sum(found.map((each) => each.free));
  const share = (method) => `${((100 * sum(found.map(({ claimed }) => claimed[method]))) / free).toFixed(2)} %`;
  return [label, String(free), ...METHODS.map(share)];
}

function claimsOf(name, open) {
  const model = open();
  try {
    const { points } = model.info();
    const truth = listed(model, undefined, points);
    const free = points - sum(truth);
    if (free < LEAST_SHARE * points) {
      return [];
    }
    const claimed = {};
    for (const method of METHODS) {
      const taken = listed(model, model.fit(method, {}, 1), points);
      claimed[method] = sum(taken.map((one, at) => one & (1 - truth[at])));
    }
    return [{ name, free, claimed }];
  } finally {
    model.free();
  }
}

/** 1 for each point that some primitive lists. */
function listed(model, method, points) {
  const marks = new Uint8Array(points);
  for (const index of model.members(method).indices) {
    marks[index] = 1;
  }
  return marks;
}

function sum(values) {
  return values.reduce((total, value) => total + value, 0);
}
