// A folder of the standing table, as it lies on the disk: the sets there are, and what a method's two files say.

import { existsSync, lstatSync, readFileSync, readdirSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { ID, MOST_TOML, readMethod } from "../../../www/shared/results/method.mjs";
import { MOST_JSON, readScores } from "../../../www/shared/results/scores.mjs";
import { readSets } from "../../../www/shared/results/sets.mjs";
import { whyUnread } from "../reasons.mjs";

/**
 * @typedef {import("../../../www/shared/results/checking.mjs").Finding} Finding
 * @typedef {import("../../../www/shared/results/method.mjs").Method} Method
 * @typedef {import("../../../www/shared/results/scores.mjs").Scores} Scores
 * @typedef {import("../../../www/shared/results/sets.mjs").Sets} Sets
 */

/** The table of this checkout. */
export const RESULTS = resolve(import.meta.dirname, "../../../results");

export const METHOD_FILE = "method.toml";
export const SCORES_FILE = "scores.json";

/** What a stranger's folder holds beyond this is not looked at. */
const MOST_ENTRIES = 1000;

/**
 * The table that a folder lies in: the one around it, else this checkout's.
 * @param {string} folder
 */
export function tableOf(folder) {
  const around = dirname(resolve(folder));
  return existsSync(join(around, "sets.toml")) ? around : RESULTS;
}

/**
 * The sets of a table. Throws where its `sets.toml` is not right: that is the table's own fault.
 * @param {string} results
 * @returns {Sets}
 */
export function setsOf(results = RESULTS) {
  const path = join(results, "sets.toml");
  const { findings, ...sets } = readSets(readFileSync(path, "utf8"));
  const [first] = findings;
  if (first) throw new Error(`${path}: ${first.where}: ${first.message}`);
  return sets;
}

/**
 * The methods of a table by the names of their folders, in the order of the alphabet.
 * @param {string} results
 */
export function methodsIn(results = RESULTS) {
  const folders = readdirSync(results, { withFileTypes: true }).filter((entry) => entry.isDirectory() && ID.test(entry.name));
  return folders.map(({ name }) => name).sort();
}

/**
 * A method's folder. Links are not followed, and nothing is read that is larger than it may be.
 * @param {string} folder
 * @param {Sets} sets
 * @returns {{ id: string, method: Method | undefined, scores: Scores | undefined, findings: readonly Finding[] }}
 */
export function readFolder(folder, sets) {
  const id = basename(resolve(folder));
  /** @type {Finding[]} */
  const findings = [];
  if (!ID.test(id)) findings.push({ where: id, message: "a folder is called by small letters, digits and hyphens, at most 48" });
  findings.push(...strangersIn(folder));
  const toml = textOf(join(folder, METHOD_FILE), MOST_TOML, findings);
  const json = textOf(join(folder, SCORES_FILE), MOST_JSON, findings);
  const said = toml === undefined ? undefined : readMethod(toml);
  const scored = json === undefined ? undefined : readScores(json, sets.sets);
  findings.push(...within(METHOD_FILE, said?.findings), ...within(SCORES_FILE, scored?.findings));
  if (scored?.findings.length === 0 && scored.scores.method !== id) {
    findings.push({ where: `${SCORES_FILE}: method`, message: `expected ${id}, the name of the folder, found ${scored.scores.method}` });
  }
  return {
    id,
    method: said?.findings.length === 0 ? said.method : undefined,
    scores: scored?.findings.length === 0 ? scored.scores : undefined,
    findings,
  };
}

/**
 * @param {string} file
 * @param {readonly Finding[]} findings
 */
function within(file, findings = []) {
  return findings.map(({ where, message }) => ({ where: `${file}: ${where}`, message }));
}

/**
 * Everything in a folder that is neither of its two files.
 * @param {string} folder
 * @returns {Finding[]}
 */
function strangersIn(folder) {
  try {
    const names = readdirSync(folder).filter((name) => name !== METHOD_FILE && name !== SCORES_FILE);
    return names.slice(0, MOST_ENTRIES).map((name) => ({ where: name, message: `only ${METHOD_FILE} and ${SCORES_FILE} belong in the folder; answers go to an archive elsewhere` }));
  } catch {
    // Its files are told of one by one.
    return [];
  }
}

/**
 * @param {string} path
 * @param {number} most
 * @param {Finding[]} findings
 */
function textOf(path, most, findings) {
  const tell = (/** @type {string} */ message) => void findings.push({ where: basename(path), message });
  try {
    const about = lstatSync(path);
    if (!about.isFile()) return tell("it is a link or a folder; a plain file is needed");
    if (about.size > most) return tell(`it has ${about.size} bytes; at most ${most} are read`);
    return new TextDecoder("utf-8", { fatal: true }).decode(readFileSync(path));
  } catch (error) {
    return tell(error instanceof TypeError ? "it is not UTF-8" : whyUnread(error));
  }
}
