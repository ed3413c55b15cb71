// `fit4cad verify`.

import { resolve } from "node:path";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect, unusable } from "./inputs.mjs";
import { RESULTS, readFolder, setsOf, tableOf } from "./standing/folder.mjs";
import { Known, degradeInto } from "./standing/known.mjs";
import { rescore } from "./standing/rescore.mjs";
import { outcomeLines } from "./standing/words.mjs";
import { print, progress } from "./terminal.mjs";
import { UsageError, readArguments } from "./usage.mjs";

/** @typedef {import("./standing/rescore.mjs").Outcome} Outcome */
/** @typedef {import("../../www/shared/results/checking.mjs").Finding} Finding */

const OPTIONS = /** @type {const} */ ({
  data: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
  answers: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
  set: { type: "string", multiple: true, default: /** @type {string[]} */ ([]) },
  ...FORMAT_OPTIONS,
});

/**
 * Scores again what folders of the standing table claim; gives the exit code.
 * @param {readonly string[]} args
 */
export async function verify(args) {
  const { values, positionals } = readArguments(args, OPTIONS);
  const format = formatOf(values, ["table", "json"]);
  if (positionals.length === 0) throw new UsageError("give at least one folder of results, such as results/fit4cad-ht");
  if (values.data.length === 0) throw new UsageError("say where the clouds and their truth are: --data FOLDER");
  const sets = setsOf(tableOf(positionals[0] ?? RESULTS));
  for (const set of values.set) {
    if (!sets.sets.some(({ id }) => id === set)) throw new UsageError(`--set ${set}: expected ${sets.sets.map(({ id }) => id).join(", ")}`);
  }
  const engine = await loadEngine();
  const data = await collect(values.data);
  const answers = await collect(values.answers);
  const folders = [];
  for (const folder of positionals) {
    folders.push(await verifyFolder(engine, resolve(folder), { sets, data: data.files, answers: answers.files, only: values.set }));
  }
  progress.clear();
  tell(engine, [...data.diagnostics, ...answers.diagnostics, ...folders.flatMap(({ problems }) => problems)]);
  const told = folders.map(({ problems: _, ...folder }) => folder);
  await print(format === "json" ? `${JSON.stringify(told, null, 2)}\n` : told.map(words).join(""));
  return told.every(isVerified) ? 0 : 1;
}

/**
 * Whether every claim was borne out.
 * @param {{ findings: readonly Finding[], outcomes: readonly Outcome[] }} folder
 */
export function isVerified({ findings, outcomes }) {
  return findings.length === 0 && outcomes.length > 0 && outcomes.every(({ models, scored, differences }) => scored === models && differences.length === 0);
}

/**
 * @param {import("./engine.mjs").Engine} engine
 * @param {string} folder
 * @param {{ sets: import("../../www/shared/results/sets.mjs").Sets, data: readonly import("./inputs.mjs").File[], answers: readonly import("./inputs.mjs").File[], only?: readonly string[] }} how
 */
export async function verifyFolder(engine, folder, { sets, data, answers, only = [] }) {
  const { id, method, scores, findings } = readFolder(folder, sets);
  /** @type {Outcome[]} */
  const outcomes = [];
  /** @type {import("./inputs.mjs").Diagnostic[]} */
  const problems = [];
  if (!method || !scores) return { id, method, scores, findings, outcomes, problems };
  progress.show(`${id}: hashing files`);
  const known = new Known();
  problems.push(...known.take([...data, ...answers]));
  let able = engine;
  const { answers: source } = method;
  for (const claimed of scores.sets.filter(({ set }) => only.length === 0 || only.includes(set))) {
    const set = sets.sets.find((each) => each.id === claimed.set);
    if (set?.degraded) {
      progress.show(`${id}: making ${set.id}`);
      able = await degradeInto(able, data, set, known);
    }
    const fitter = source.way === "fitter" ? source.fitter : undefined;
    const done = await rescore(able, claimed, { known, method: source.called, fitter, progress: (text) => progress.show(`${id}: ${text}`) });
    able = done.engine;
    outcomes.push(done.outcome);
  }
  if (outcomes.length === 0) problems.push(unusable(id, "it has no scores of the sets asked for"));
  return { id, method, scores, findings, outcomes, problems };
}

/** @param {{ id: string, findings: readonly Finding[], outcomes: readonly Outcome[], scores: import("./standing/folder.mjs").Scores | undefined }} folder */
function words({ id, findings, outcomes, scores }) {
  const lines = findings.map(({ where, message }) => `✗ ${id}: ${where}: ${message}`);
  const claims = new Map(scores?.sets.map((set) => [set.set, set.engine]));
  for (const outcome of outcomes) lines.push(...outcomeLines(outcome, claims.get(outcome.set) ?? "").map((line) => `${line.mark} ${id}: ${line.text}`));
  return lines.map((line) => `${line}\n`).join("");
}
