// What the engine says of one submission on one model, by every protocol: what a row of scores.json holds.

import { createHash } from "node:crypto";
import { FIGURE_SCALE } from "../../../www/generated/declared/figure-scale.js";
import { BY } from "../../../www/shared/results/scores.mjs";
import { summaryOf } from "../../../www/shared/results/summary.mjs";
import { scoredBy } from "../evaluate.mjs";

/**
 * @typedef {import("../engine.mjs").Engine} Engine
 * @typedef {import("../../engine/engine.js").Model} Model
 * @typedef {import("../../engine/engine.js").FieldReport} FieldReport
 * @typedef {import("../../../www/shared/results/scores.mjs").Entry} Entry
 * @typedef {import("../../../www/shared/results/scores.mjs").SetScores} SetScores
 */

/**
 * Scores a method's submission. The field's report is given, too: what is summed up by type and size is of it.
 * @param {Model} model
 * @param {string} method
 * @param {{ name: string, inputs: Entry["inputs"], answers: Entry["answers"], seconds?: number | undefined, scale?: import("../../../www/shared/results/scores.mjs").FigureScale }} of
 * @returns {{ entry: Entry, field: FieldReport }}
 */
export function scored(model, method, { name, inputs, answers, seconds, scale = FIGURE_SCALE }) {
  const reports = BY.map((protocol) => ({ protocol, report: scoredBy(protocol)(model, method) }));
  const first = reports[0]?.report;
  if (!first) throw new Error("the engine declares no protocol");
  const field = model.field(method, scale);
  /** @type {Entry} */
  const entry = {
    model: name,
    points: first.points,
    truth: first.truth,
    predicted: first.predicted,
    typeErrors: first.type_errors,
    ...(first.surfacesFitted ? { surfacesFitted: true } : {}),
    ...(seconds === undefined ? {} : { seconds }),
    inputs,
    answers,
    .../** @type {import("../../../www/shared/results/scores.mjs").Figures<number | null>} */ (
      Object.fromEntries([...reports.map(({ protocol, report }) => [protocol, report.mean]), ["figures", field.figures]])
    ),
  };
  return { entry, field };
}

/**
 * A set as scores.json has it.
 * @param {Engine} engine
 * @param {string} set
 * @param {readonly { entry: Entry, field: FieldReport }[]} rows
 * @param {import("../../../www/shared/results/scores.mjs").FigureScale} scale
 * @returns {SetScores}
 */
export function setScores(engine, set, rows, scale = FIGURE_SCALE) {
  const entries = rows.map(({ entry }) => entry);
  return { set, engine: engine.version(), scale, summary: summaryOf(engine, entries, rows.map(({ field }) => field)), models: entries };
}

/** @param {string | Uint8Array} content */
export function sha256(content) {
  return createHash("sha256").update(content).digest("hex");
}

/**
 * The last part of a model's name: what it is called whatever the folders around it.
 * @param {string} name
 */
export function bareName(name) {
  return name.split("/").at(-1) ?? name;
}
