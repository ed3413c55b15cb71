// `fit4cad score` by the protocols and figures that the rest of the field reports.

import { FIGURES } from "../../www/generated/declared/figures.js";
import { FIGURE_SCALE } from "../../www/generated/declared/figure-scale.js";
import { NORMALISATIONS } from "../../www/generated/declared/normalisations.js";
import { PROTOCOLS } from "../../www/generated/declared/protocols.js";
import { RECOGNITION } from "../../www/generated/declared/recognition.js";
import { BY, infoOf } from "../../www/shared/formats/field-sums.mjs";
import { fieldJson, fieldSheets } from "../../www/shared/formats/field.mjs";
import { SHEET_FORMATS } from "../../www/shared/formats/sheet.mjs";
import { declaredConditions } from "./declared-conditions.mjs";
import { tell } from "./diagnostics.mjs";
import { evaluateBy } from "./evaluate.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, choice, number } from "./usage.mjs";

/** @typedef {import("./field-report.mjs").FieldReport} FieldReport */
/** @typedef {NonNullable<ReturnType<typeof fieldOf>>} Field */

export const FIELD_OPTIONS = /** @type {const} */ ({
  measures: { type: "string" },
  normalisation: { type: "string" },
  epsilon: { type: "string" },
  by: { type: "string" },
});

/** The protocols that score a segmentation alone. */
export const SEGMENTATION = FIGURES.filter(({ group }) => group === "segmentation").map(({ key }) => key);

/** @type {readonly string[]} */
const PAPER = PROTOCOLS.map(({ name }) => name);

/**
 * What is asked for beyond the benchmark's measures; undefined where nothing is.
 * @param {{ protocol: string, measures?: string | undefined, normalisation?: string | undefined, epsilon?: string | undefined, by?: string | undefined }} values
 */
export function fieldOf({ protocol, measures, normalisation, epsilon, by }) {
  if (PAPER.includes(protocol) && measures === undefined && by === undefined) {
    if (normalisation !== undefined || epsilon !== undefined) {
      throw new UsageError("--normalisation and --epsilon are for --measures: name some, or all");
    }
    return undefined;
  }
  const scale = {
    normalisation: choice(
      "normalisation",
      normalisation ?? FIGURE_SCALE.normalisation,
      NORMALISATIONS.map(({ name }) => name),
    ),
    epsilon: number("epsilon", epsilon, { least: 0 }) ?? FIGURE_SCALE.epsilon,
  };
  const protocols = protocolsOf(protocol, measures);
  const wanted = [...protocols, ...figuresOf(measures)];
  // In the order of the list, each once.
  const figures = FIGURES.filter(({ key }) => wanted.includes(key));
  const strata = by === undefined ? [] : named("by", by, BY);
  return { figures, scale, by: BY.filter((each) => strata.includes(each)), segments: protocols.includes(RECOGNITION.key) };
}

/**
 * @param {string} protocol
 * @param {string | undefined} measures where these are asked for alone, no protocol is
 * @returns {string[]}
 */
function protocolsOf(protocol, measures) {
  if (protocol === "definition" && measures !== undefined) {
    return [];
  }
  const all = protocol === "all" ? SEGMENTATION : named("protocol", protocol, [...PAPER, ...SEGMENTATION, RECOGNITION.key]);
  // Both of the benchmark's protocols have one DSC.
  return all.map((name) => (PAPER.includes(name) ? "fit4cad" : name));
}

/** @param {string | undefined} measures */
function figuresOf(measures) {
  const keys = FIGURES.map(({ key }) => key);
  const fit = FIGURES.filter(({ group }) => group === "fit").map(({ key }) => key);
  return measures === undefined ? [] : measures === "all" ? fit : named("measures", measures, keys);
}

/**
 * The names of a list with commas, each allowed.
 * @template {string} Name
 * @param {string} option
 * @param {string} list
 * @param {readonly Name[]} allowed
 */
function named(option, list, allowed) {
  return list.split(",").map((name) => choice(option, name.trim(), allowed));
}

/**
 * Scores and prints; gives the exit code.
 * @param {import("./engine.mjs").Engine} engine
 * @param {{ files: readonly import("./inputs.mjs").File[], diagnostics: readonly import("./inputs.mjs").Diagnostic[] }} inputs
 * @param {{ overrides: Record<string, import("../engine/engine.js").Override>, self: boolean, jobs: number, paths: readonly string[], progress: (text: string) => void, field: Field, format: keyof typeof SHEET_FORMATS | "json" }} how
 */
export async function scoreField(engine, inputs, { field, format, ...how }) {
  const conditions = field.by.some((each) => infoOf(each).isCondition);
  const { scale, segments } = field;
  const evaluated = await /** @type {typeof evaluateBy<FieldReport>} */ (evaluateBy)(engine, inputs, { ...how, by: { scale, conditions, segments } });
  const { diagnostics, engine: able } = evaluated;
  const results = conditions ? withDeclared(able, inputs.files, evaluated.results) : evaluated.results;
  progress.clear();
  const problems = [...inputs.diagnostics, ...diagnostics];
  tell(able, problems);
  if (results.length === 0) {
    warn("fit4cad score: nothing could be scored. A score needs a cloud, its truth and a submission; see fit4cad score --help.");
  }
  await print(
    format === "json" ? fieldJson(able, results, field) : SHEET_FORMATS[format](fieldSheets(able, results, field)),
  );
  const failed = results.length === 0 || problems.some(({ severity }) => severity === "error");
  return failed ? 1 : 0;
}

/**
 * The results with what a set's manifest declares of its models in place of what was measured.
 * @template {FieldReport} R
 * @param {import("./engine.mjs").Engine} engine
 * @param {readonly import("./inputs.mjs").File[]} files
 * @param {readonly R[]} results
 */
function withDeclared(engine, files, results) {
  const declared = declaredConditions(engine, files);
  return results.map((result) => {
    const known = declared.get(result.model) ?? [];
    return { ...result, conditions: (result.conditions ?? []).map((each) => known.find(({ by }) => by === each.by) ?? each) };
  });
}
