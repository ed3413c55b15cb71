// @ts-check
// `results/sets.toml`: the sets of models that rows of the standing table are about.

import { SAMPLE_OPTIONS } from "../../generated/declared/sample-options.js";
import { Checking } from "./checking.mjs";
import { ID, SHA256, tableOf } from "./method.mjs";
import { WEAR } from "./wear.mjs";

/** @typedef {import("./checking.mjs").Finding} Finding */
/** @typedef {import("./wear.mjs").Wear} Wear */

/**
 * @typedef {object} ModelSet
 * @property {string} id
 * @property {string} title
 * @property {string} meaning
 * @property {"training" | "test"} part of the public data that its models are of
 * @property {readonly string[]} models
 * @property {string | undefined} of the set that this one is a worse scan of
 * @property {Wear | undefined} degraded
 */

/**
 * @typedef {object} Sets
 * @property {{ repository: string, commit: string, archive: string, sha256: string | undefined }} source the public data, at a commit
 * @property {readonly ModelSet[]} sets
 */

const SEED = SAMPLE_OPTIONS.find(({ name }) => name === "seed");
const PARTS = /** @type {const} */ (["training", "test"]);
/** No set of the benchmark has as many. */
const MOST_NUMBER = 10_000;

/**
 * Reads the text of `sets.toml`.
 * @param {string} text
 * @returns {Sets & { findings: readonly Finding[] }}
 */
export function readSets(text) {
  const { fields, finding } = tableOf(text);
  const all = new Checking(fields, "", finding ? [finding] : []);
  all.only(["source", "sets"]);
  const source = all.table("source");
  source?.only(["repository", "commit", "archive", "sha256"]);
  const known = {
    repository: source?.text("repository") ?? "",
    commit: source?.text("commit", { pattern: /^[0-9a-f]{40}$/, expected: "a commit, 40 hexadecimal digits" }) ?? "",
    archive: source?.text("archive", { most: 300 }) ?? "",
    sha256: source?.optionalText("sha256", { pattern: SHA256, expected: "64 hexadecimal digits" }),
  };
  /** @type {ModelSet[]} */
  const sets = [];
  for (const each of all.tables("sets", 100)) sets.push(setOf(each, sets));
  return { source: known, sets, findings: all.findings };
}

/**
 * @param {Checking} set
 * @param {readonly ModelSet[]} before
 * @returns {ModelSet}
 */
function setOf(set, before) {
  set.only(["id", "title", "meaning", "part", "numbers", "of", "degraded"]);
  const id = set.text("id", { pattern: ID, expected: "small letters, digits and hyphens" });
  if (before.some((other) => other.id === id)) set.tell("id", `there is a set ${id} already`);
  const common = { id, title: set.text("title"), meaning: set.text("meaning", { most: 600 }) };
  if (!set.has("of")) {
    return { ...common, part: set.word("part", PARTS) ?? "test", models: numbersOf(set).map((number) => `PC${number}`), of: undefined, degraded: undefined };
  }
  const of = set.text("of");
  const base = before.find((other) => other.id === of);
  if (!base || base.degraded) set.tell("of", "expected a set before this one that is not degraded itself");
  return { ...common, part: base?.part ?? "test", models: base?.models ?? [], of, degraded: wearOf(set.table("degraded")) };
}

/**
 * Ranges of numbers: `[[1, 3], [5, 5]]`.
 * @param {Checking} set
 */
function numbersOf(set) {
  const value = set.value("numbers");
  const ranges = Array.isArray(value) ? value : [];
  /** @type {number[]} */
  const numbers = [];
  for (const range of ranges) {
    const [first, last] = Array.isArray(range) && range.length === 2 ? range : [];
    if (!(Number.isSafeInteger(first) && Number.isSafeInteger(last) && first >= 1 && first <= last && last <= MOST_NUMBER)) {
      set.tell("numbers", "expected ranges of numbers such as [[1, 3], [5, 5]]");
      return [];
    }
    for (let number = first; number <= last; number += 1) numbers.push(number);
  }
  if (numbers.length === 0) set.tell("numbers", "expected at least one range of numbers such as [[1, 3]]");
  return numbers;
}

/**
 * @param {Checking | undefined} table
 * @returns {Wear}
 */
function wearOf(table) {
  table?.only(["seed", ...WEAR.map(({ name }) => name)]);
  /** @type {Record<string, number>} */
  const wear = {};
  for (const { name, minimum: least, maximum: most } of WEAR) {
    if (table?.has(name)) wear[name] = table.number(name, { least, most });
  }
  return { ...wear, seed: table?.number("seed", { least: SEED?.minimum ?? 0, most: SEED?.maximum ?? 2 ** 32 - 1, whole: true }) ?? 1 };
}
