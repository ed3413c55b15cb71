// The formats of `fit4cad stats --format`: each makes one text of `{ set, models }`.

import { align } from "./align.mjs";
import { csvText, guarded } from "./csv.mjs";

const TYPES = ["Plane", "Cylinder", "Cone", "Sphere", "Torus", "Other"];
/** Length of a bar that stands for all primitives. */
const BAR = 50;

function json(statistics) {
  return `${JSON.stringify(statistics, null, 2)}\n`;
}

function csv({ models }) {
  const head = ["model", "points", "primitives", ...TYPES.map((type) => type.toLowerCase())];
  const rows = models.map(({ name, points, primitives, types, unsegmented, shared }) => [
    ...[guarded(name), points, primitives],
    ...TYPES.map((type) => types[type]),
    ...[unsegmented ?? "", shared],
  ]);
  return csvText([[...head, "unsegmented", "shared"], ...rows]);
}

function table({ set, models }) {
  if (models.length === 0) {
    return "";
  }
  const head = ["model", "points", "primitives", ...TYPES, "unsegmented"];
  const rows = models.map((model) => row(model.name, model));
  const blocks = [align([head, ...rows, row(`all ${set.models}`, set)], 1)];
  if (models.length > 1) {
    blocks.push(align(spreads(set), 1));
  }
  if (set.primitives > 0) {
    blocks.push(align(bars(set), 1));
  }
  return `${blocks.join("\n\n")}\n`;
}

function row(name, { points, primitives, types, unsegmented }) {
  return [
    name,
    ...[points, primitives, ...TYPES.map((type) => types[type])].map(String),
    share(unsegmented),
  ];
}

function spreads({ pointsPerModel, primitivesPerModel, unsegmentedPerModel }) {
  const spread = (name, values, show) =>
    values === null
      ? [name, "n/a", "n/a", "n/a"]
      : [name, ...[values.min, values.median, values.max].map(show)];
  return [
    ["per model", "least", "median", "most"],
    spread("points", pointsPerModel, String),
    spread("primitives", primitivesPerModel, String),
    spread("unsegmented", unsegmentedPerModel, share),
  ];
}

/** The paper's bar chart of surface types. */
function bars({ types, primitives }) {
  return TYPES.filter((type) => type !== "Other" || types[type] > 0).map((type) => {
    const part = types[type] / primitives;
    return [type, String(types[type]), share(part), "█".repeat(Math.round(part * BAR)).padEnd(BAR)];
  });
}

function share(value) {
  return value === undefined || value === null ? "n/a" : `${(value * 100).toFixed(1)} %`;
}

export const STATISTICS = { table, json, csv };
