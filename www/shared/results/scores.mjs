// @ts-check
// `scores.json`: what a method scored, model by model and summed up. Written by `fit4cad submit` alone;
// checked here as something that a stranger may have sent.

import { FIGURES } from "../../generated/declared/figures.js";
import { NORMALISATIONS } from "../../generated/declared/normalisations.js";
import { PROTOCOLS } from "../../generated/declared/protocols.js";
import { ROLES } from "../../generated/declared/roles.js";
import { MEASURES } from "../formats/measures.mjs";
import { oneLine } from "../text.mjs";
import { Checking, hasFields, shown } from "./checking.mjs";
import { ID, SHA256 } from "./method.mjs";

/**
 * @typedef {import("./checking.mjs").Finding} Finding
 * @typedef {import("../../generated/engine/engine.js").Protocol} Protocol
 * @typedef {import("../../generated/engine/engine.js").Measure} Measure
 * @typedef {import("../../generated/engine/engine.js").Figure} Figure
 * @typedef {import("../../generated/engine/engine.js").Role} Role
 * @typedef {import("../../generated/engine/engine.js").FigureSpread} FigureSpread
 * @typedef {import("../../generated/engine/engine.js").FigureScale} FigureScale
 */

/**
 * Figures by their names: measures under each of the paper's protocols, and what the field reports. One
 * that an engine before did not know is absent.
 * @template V
 * @typedef {{ readonly [protocol in Protocol]: Readonly<Partial<Record<Measure, V>>> } & { readonly figures: Readonly<Partial<Record<Figure, V>>> }} Figures
 */

/**
 * SHA-256 by what the file is; several where each file holds the points of one primitive.
 * @typedef {Readonly<Partial<Record<Role, string | readonly string[]>>>} Hashes
 */

/**
 * One model.
 * @typedef {Figures<number | null> & {
 *   readonly model: string, readonly points: number, readonly truth: number, readonly predicted: number,
 *   readonly typeErrors: number, readonly surfacesFitted?: true, readonly seconds?: number,
 *   readonly inputs: Hashes, readonly answers: Hashes }} Entry
 */

/**
 * True primitives of one type, or of one size.
 * @typedef {{ readonly stratum: string, readonly primitives: number, readonly iou: FigureSpread | null, readonly found: number | null }} Stratum
 */

/**
 * Over all models of a set.
 * @typedef {Figures<FigureSpread | null> & {
 *   readonly models: number, readonly typeErrors: number, readonly surfacesFitted: number, readonly seconds: FigureSpread | null,
 *   readonly types: readonly Stratum[], readonly sizes: readonly Stratum[] }} Summary
 */

/** @typedef {{ readonly set: string, readonly engine: string, readonly scale: FigureScale, readonly summary: Summary, readonly models: readonly Entry[] }} SetScores */

/** @typedef {{ readonly format: typeof FORMAT, readonly method: string, readonly sets: readonly SetScores[] }} Scores */

export const FORMAT = 1;

/** Ten times what 500 models take. */
export const MOST_JSON = 8 * 2 ** 20;

/** What measures are scored by, in the order of the file. */
export const BY = PROTOCOLS.map(({ name }) => name);

const FIGURE_KEYS = FIGURES.map(({ key }) => key);
const ROLE_NAMES = ROLES.map(({ name }) => name);
const MOST_SETS = 50;
const MOST_MODELS = 5000;
/** More of the same kind say nothing new. */
const MOST_FINDINGS = 50;

/**
 * Reads the text of a `scores.json`. Without findings it is whole: every figure is a number or null, every
 * hash a hash, and every set has each of its models once.
 * @param {string} text
 * @param {readonly import("./sets.mjs").ModelSet[]} sets those there are
 * @returns {{ scores: Scores, findings: readonly Finding[] }}
 */
export function readScores(text, sets) {
  /** @type {Scores} */
  const none = { format: FORMAT, method: "", sets: [] };
  const fault = (/** @type {string} */ message) => ({ scores: none, findings: [{ where: "file", message }] });
  if (text.length > MOST_JSON) return fault(`it has more than ${MOST_JSON} characters`);
  /** @type {unknown} */
  let value;
  try {
    value = JSON.parse(text);
  } catch (error) {
    return fault(`it is no JSON: ${error instanceof Error ? oneLine(error.message) : ""}; was it cut off?`);
  }
  if (!hasFields(value)) return fault("expected an object");
  const all = new Checking(value);
  all.only(["format", "method", "sets"]);
  if (all.value("format") !== FORMAT) all.tell("format", `expected ${FORMAT}, found ${shown(all.value("format"))}`);
  all.text("method", { pattern: ID, expected: "the name of its folder: small letters, digits and hyphens" });
  const seen = new Set();
  for (const set of all.tables("sets", MOST_SETS)) {
    const id = checkSet(set, sets);
    if (seen.has(id)) set.tell("set", `the set ${id} stands here twice`);
    seen.add(id);
    if (all.findings.length > MOST_FINDINGS) break;
  }
  if (all.findings.length > 0) return { scores: none, findings: all.findings.slice(0, MOST_FINDINGS) };
  return { scores: /** @type {Scores} */ (/** @type {unknown} */ (value)), findings: [] };
}

/**
 * @param {Checking} set
 * @param {readonly import("./sets.mjs").ModelSet[]} sets
 */
function checkSet(set, sets) {
  set.only(["set", "engine", "scale", "summary", "models"]);
  const id = set.word("set", sets.map((each) => each.id));
  set.text("engine", { most: 40, pattern: /^\d+\.\d+\.\d+[\w.+-]*$/, expected: "the version of an engine, such as 0.3.0" });
  const scale = set.table("scale");
  scale?.only(["normalisation", "epsilon"]);
  scale?.word("normalisation", NORMALISATIONS.map(({ name }) => name));
  scale?.number("epsilon", { least: 0, most: 1e6 });
  const summary = set.table("summary");
  if (summary) checkSummary(summary);
  const models = set.tables("models", MOST_MODELS);
  const names = models.map(checkEntry);
  const wanted = sets.find((each) => each.id === id)?.models ?? [];
  const doubled = names.filter((name, at) => names.indexOf(name) !== at);
  const lacking = wanted.filter((name) => !names.includes(name));
  const strange = names.filter((name) => !wanted.includes(name));
  if (doubled.length > 0) set.tell("models", `${doubled.map(oneLine).join(", ")}: stands here more than once`);
  if (lacking.length > 0) set.tell("models", `the set has ${few(lacking)}, of which there is nothing here`);
  if (id !== undefined && strange.length > 0) set.tell("models", `there is no ${few(strange.map(oneLine))} in the set ${id}`);
  return id;
}

/**
 * The first of many names, and how many more.
 * @param {readonly string[]} names
 */
export function few(names) {
  return names.length > 8 ? `${names.slice(0, 8).join(", ")} and ${names.length - 8} more` : names.join(", ");
}

/** Most files that one role of a model may be spread over: one for each primitive. */
const MOST_FILES = 10_000;

const COUNTS = /** @type {const} */ (["points", "truth", "predicted", "typeErrors"]);

/** @param {Checking} entry */
function checkEntry(entry) {
  entry.only(["model", ...COUNTS, "surfacesFitted", "seconds", "inputs", "answers", ...BY, "figures"]);
  for (const count of COUNTS) entry.number(count, { least: 0, whole: true });
  if (entry.has("surfacesFitted") && entry.value("surfacesFitted") !== true) entry.tell("surfacesFitted", "expected true, or nothing");
  if (entry.has("seconds")) entry.number("seconds", { least: 0, most: 1e9 });
  for (const which of ["inputs", "answers"]) {
    const hashes = entry.table(which);
    hashes?.only(ROLE_NAMES);
    for (const role of ROLE_NAMES.filter((name) => hashes?.has(name))) {
      const value = hashes?.value(role);
      if (!Array.isArray(value)) hashes?.text(role, { pattern: SHA256, expected: "a SHA-256 of 64 hexadecimal digits" });
      else if (value.length < 2 || value.length > MOST_FILES || !value.every((hash) => typeof hash === "string" && SHA256.test(hash))) {
        hashes?.tell(role, "expected the SHA-256 of one file, or a list of those of several");
      }
    }
    const needed = which === "inputs" ? "cloud" : "primitives";
    if (hashes && !hashes.has(needed)) hashes.tell(needed, "its SHA-256 is missing");
  }
  checkFigures(entry, (figures, key) => {
    if (figures.value(key) !== null) figures.number(key);
  });
  return entry.text("model", { most: 60 });
}

const SPREAD = /** @type {const} */ (["count", "mean", "min", "lowerQuartile", "median", "upperQuartile", "max", "interval"]);

const SUMS = /** @type {const} */ (["models", "typeErrors", "surfacesFitted"]);

/** @param {Checking} summary */
function checkSummary(summary) {
  summary.only([...SUMS, "seconds", "types", "sizes", ...BY, "figures"]);
  for (const count of SUMS) summary.number(count, { least: 0, whole: true });
  checkSpread(summary, "seconds");
  checkFigures(summary, checkSpread);
  for (const which of ["types", "sizes"]) {
    for (const stratum of summary.tables(which, 20)) {
      stratum.only(["stratum", "primitives", "iou", "found"]);
      stratum.text("stratum", { most: 40 });
      stratum.number("primitives", { least: 0, whole: true });
      checkSpread(stratum, "iou");
      if (stratum.value("found") !== null) stratum.number("found", { least: 0, most: 1 });
    }
  }
}

/**
 * @param {Checking} table
 * @param {string} key
 */
function checkSpread(table, key) {
  if (table.value(key) === null) return;
  const spread = table.table(key);
  if (!spread) return;
  spread.only(SPREAD);
  for (const part of SPREAD.filter((name) => name !== "interval")) spread.number(part);
  const interval = spread.value("interval");
  const isPair = Array.isArray(interval) && interval.length === 2 && interval.every((end) => Number.isFinite(end));
  if (interval !== null && !isPair) spread.tell("interval", "expected two numbers, or null");
}

/**
 * @param {Checking} table
 * @param {(figures: Checking, key: string) => void} check
 */
function checkFigures(table, check) {
  for (const [which, keys] of /** @type {[string, readonly string[]][]} */ ([...BY.map((name) => [name, MEASURES]), ["figures", FIGURE_KEYS]])) {
    const figures = table.table(which);
    figures?.only(keys);
    for (const key of keys) if (figures?.has(key)) check(figures, key);
  }
}

/**
 * The text of a `scores.json`: a line a model, so that a change shows in a diff what it is of.
 * @param {Scores} scores
 */
export function writeScores({ method, sets }) {
  const texts = sets.map(({ models, ...set }) => {
    const head = Object.entries(set).map(([key, value]) => `   ${JSON.stringify(key)}: ${JSON.stringify(value)}`);
    const lines = models.map((model) => `    ${JSON.stringify(model)}`);
    return `  {\n${head.join(",\n")},\n   "models": [\n${lines.join(",\n")}\n   ]\n  }`;
  });
  return `{\n "format": ${FORMAT},\n "method": ${JSON.stringify(method)},\n "sets": [\n${texts.join(",\n")}\n ]\n}\n`;
}
