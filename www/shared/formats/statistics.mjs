// @ts-check
// The formats of `fit4cad stats --format`: each makes one text of `{ engine, set, models }`, of which the first is the
// engine's version.

import { OTHER_TYPE } from "../../generated/declared/other-type.js";
import { SURFACE_TYPES } from "../../generated/declared/surface-types.js";
import { align } from "./align.mjs";
import { csvText, guarded } from "./csv.mjs";

/** @typedef {import("../../generated/engine/engine.js").DatasetStatistics} DatasetStatistics */
/** @typedef {import("../../generated/engine/engine.js").ModelStatistics} ModelStatistics */
/** @typedef {import("../../generated/engine/engine.js").Spread} Spread */
/** @typedef {{ engine: string, set: DatasetStatistics, models: readonly ModelStatistics[] }} Statistics */

const TYPES = [...SURFACE_TYPES.map(({ name }) => name), OTHER_TYPE];
/** Length of a bar that stands for all primitives. */
const BAR = 50;

/** @param {Statistics} statistics */
function json(statistics) {
  return `${JSON.stringify(statistics, null, 2)}\n`;
}

/** @param {Statistics} statistics */
function csv({ engine, models }) {
  const head = ["model", "points", "primitives", ...TYPES.map((type) => type.toLowerCase())];
  const rows = models.map(({ name, points, primitives, types, unsegmented, shared }) => [
    ...[guarded(name), points, primitives],
    ...TYPES.map((type) => types[type]),
    ...[unsegmented ?? "", shared, guarded(engine)],
  ]);
  return csvText([[...head, "unsegmented", "shared", "engine"], ...rows]);
}

/** @param {Statistics} statistics */
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

/**
 * @param {string} name
 * @param {Pick<ModelStatistics | DatasetStatistics, "points" | "primitives" | "types" | "unsegmented">} counted
 */
function row(name, { points, primitives, types, unsegmented }) {
  return [
    name,
    ...[points, primitives, ...TYPES.map((type) => types[type])].map(String),
    share(unsegmented),
  ];
}

/** @param {DatasetStatistics} set */
function spreads({ pointsPerModel, primitivesPerModel, unsegmentedPerModel }) {
  /** @param {string} name @param {Spread | null} values @param {(value: number) => string} show */
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

/**
 * The paper's bar chart of surface types.
 * @param {DatasetStatistics} set
 */
function bars({ types, typeShares }) {
  return TYPES.filter((type) => type !== OTHER_TYPE || types[type] > 0).map((type) => {
    const part = typeShares?.[type] ?? 0;
    return [type, String(types[type]), share(part), "█".repeat(Math.round(part * BAR)).padEnd(BAR)];
  });
}

/** @param {number | null | undefined} value */
function share(value) {
  return value === undefined || value === null ? "n/a" : `${(value * 100).toFixed(1)} %`;
}

export const STATISTICS = { table, json, csv };
