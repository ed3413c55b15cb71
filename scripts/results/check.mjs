// Checks what a pull request does to results/: reads its folders as a stranger's files, has the public data and
// the answers, scores everything again and prints how the rows stand. Nothing of the pull request is run.
//
//   node scripts/results/check.mjs --submission DIR [--table results] [--data PATH…] [--mirror FROM=TO…]

import { lstatSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { loadEngine } from "../../bin/cli/engine.mjs";
import { collect } from "../../bin/cli/inputs.mjs";
import { METHOD_FILE, RESULTS, SCORES_FILE, methodsIn, readFolder, setsOf } from "../../bin/cli/standing/folder.mjs";
import { outcomeLines } from "../../bin/cli/standing/words.mjs";
import { isVerified, verifyFolder } from "../../bin/cli/verify.mjs";
import { ID } from "../../www/shared/results/method.mjs";
import { oneLine, printable } from "../../www/shared/text.mjs";
import { Unfetched, fetchInto } from "./fetch.mjs";
import { clashesOf } from "./clashes.mjs";
import { neighbours } from "./neighbours.mjs";

/** @typedef {ReturnType<typeof readFolder>} Folder */

/** More in one pull request are looked at by a person first. */
const MOST_CHANGED = 20;
/** The largest answer there can be to a public cloud is a hundredth of this. */
const MOST_ANSWER = 32 * 2 ** 20;

const { values } = parseArgs({
  options: {
    submission: { type: "string" },
    table: { type: "string", default: RESULTS },
    data: { type: "string", multiple: true, default: [] },
    mirror: { type: "string", multiple: true, default: [] },
  },
});

/** @param {string} text */
function say(text) {
  process.stdout.write(`${printable(text)}\n`);
}

/**
 * A line that holds a stranger's words: as code, so that nothing in them is Markdown.
 * @param {string} mark
 * @param {string} text
 */
function sayOf(mark, text) {
  say(`${mark} \`${oneLine(text).replaceAll("`", "'")}\`\n`);
}

/**
 * What of a folder of results is another than in the table.
 * @param {string} submission
 * @param {string} table
 */
function changedIn(submission, table) {
  const same = (/** @type {string} */ id) => [METHOD_FILE, SCORES_FILE].every((name) => bytesOf(join(submission, id, name))?.equals(bytesOf(join(table, id, name)) ?? Buffer.of()));
  const entries = readdirSync(submission, { withFileTypes: true });
  const own = entries.filter((entry) => !(entry.isFile() && ["README.md", "sets.toml"].includes(entry.name)));
  const folders = own.filter((entry) => entry.isDirectory() && ID.test(entry.name)).map(({ name }) => name).sort();
  return {
    strangers: own.filter((entry) => !(entry.isDirectory() && ID.test(entry.name))).map(({ name }) => name),
    changed: folders.filter((id) => !same(id)),
    gone: methodsIn(table).filter((id) => !folders.includes(id)),
    redefined: !bytesOf(join(submission, "sets.toml"))?.equals(bytesOf(join(table, "sets.toml")) ?? Buffer.of()),
  };
}

/**
 * Of a plain file; links are not followed.
 * @param {string} path
 */
function bytesOf(path) {
  return lstatSync(path, { throwIfNoEntry: false })?.isFile() ? readFileSync(path) : undefined;
}

/**
 * Files that are not too large to be an answer, and a word on the others.
 * @param {Awaited<ReturnType<typeof collect>>} inputs
 */
function bounded({ files, diagnostics }) {
  for (const { path, size } of files) if (size > MOST_ANSWER) sayOf("!", `${path}: ${size} bytes are more than any answer has; it is left out`);
  for (const { file, message } of diagnostics) sayOf("!", `${file}: ${message}`);
  return files.filter(({ size }) => size <= MOST_ANSWER);
}

/**
 * @param {Folder} folder
 * @param {string} cache
 */
async function answersOf({ method }, cache) {
  if (method?.answers.way === "archive") {
    const { archive, sha256 } = method.answers;
    return bounded(await collect([await fetchInto(cache, archive, { sha256, mirrors: values.mirror })]));
  }
  if (method?.answers.way === "script") throw new Unfetched(`the answers are made by ${method.answers.script}, and nobody but its author has them: name an archive`);
  return [];
}

/** @param {string} cache */
async function main(cache) {
  if (values.submission === undefined) {
    say("node scripts/results/check.mjs --submission DIR [--table results] [--data PATH…] [--mirror FROM=TO…]");
    return 2;
  }
  const [submission, table] = [resolve(values.submission), resolve(values.table)];
  if (!lstatSync(submission, { throwIfNoEntry: false })?.isDirectory()) {
    say(`✗ ${values.submission}: expected a folder`);
    return 1;
  }
  const { strangers, changed, gone, redefined } = changedIn(submission, table);
  for (const name of strangers) sayOf("✗", `${name}: only folders of methods belong here, called by small letters, digits and hyphens`);
  for (const id of gone) say(`! ${id}: the row is taken out of the table`);
  if (redefined) say("! sets.toml is another than in the table; the table's own is used");
  if (changed.length > MOST_CHANGED) {
    say(`✗ ${changed.length} rows change at once; at most ${MOST_CHANGED} are checked`);
    return 1;
  }
  const sets = setsOf(table);
  const rows = methodsIn(table).map((id) => readFolder(join(table, id), sets));
  let well = strangers.length === 0;
  const engine = await loadEngine();
  /** @type {readonly import("../../bin/cli/inputs.mjs").File[] | undefined} */
  let data;
  for (const id of changed) {
    say(`\n## ${id}\n`);
    const folder = readFolder(join(submission, id), sets);
    const others = [...rows.filter((row) => row.id !== id), ...changed.filter((other) => other < id).map((other) => readFolder(join(submission, other), sets))];
    const findings = [...folder.findings, ...clashesOf(folder, others, sets)];
    for (const { where, message } of findings) sayOf("✗", `${where}: ${message}`);
    well &&= findings.length === 0;
    if (findings.length > 0) continue;
    try {
      data ??= bounded(await collect(values.data.length > 0 ? values.data : [await fetchInto(cache, sets.source.archive, { sha256: sets.source.sha256, mirrors: values.mirror })]));
      const verified = await verifyFolder(engine, join(submission, id), { sets, data, answers: await answersOf(folder, cache) });
      for (const { file, message } of verified.problems) sayOf("!", `${file}: ${message}`);
      const engines = new Map(folder.scores?.sets.map((set) => [set.set, set.engine]));
      for (const outcome of verified.outcomes) for (const { mark, text } of outcomeLines(outcome, engines.get(outcome.set) ?? "")) sayOf(mark, text);
      well &&= isVerified(verified);
      say(neighbours(folder, others, sets));
    } catch (error) {
      if (!(error instanceof Unfetched)) throw error;
      well = false;
      sayOf("✗", error.message);
    }
  }
  say(`\n${changed.length === 0 ? "No row changes." : well ? "Every digit was found again." : "Not everything was borne out."}`);
  return well ? 0 : 1;
}

const cache = mkdtempSync(join(tmpdir(), "fit4cad-results-"));
try {
  process.exitCode = await main(cache);
} finally {
  rmSync(cache, { recursive: true, force: true });
}
