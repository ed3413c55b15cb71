// The files of the standing table, as a stranger may send them: whatever they hold, they are read without a throw, and
// what is found whole is written as it was read.

import { deepEqual as alike } from "node:assert";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { RESULTS, methodsIn, setsOf } from "../../../bin/cli/standing/folder.mjs";
import { differencesOf } from "../../../www/shared/results/compare.mjs";
import { feedOf } from "../../../www/shared/results/feed.mjs";
import { readMethod } from "../../../www/shared/results/method.mjs";
import { readScores, writeScores } from "../../../www/shared/results/scores.mjs";
import { readSets } from "../../../www/shared/results/sets.mjs";

/** Of one model: inputs are to be short. */
const SETS = setsOf().sets.slice(0, 1).map((set) => ({ ...set, models: set.models.slice(0, 1) }));

/** A row of the table with one model, one measure and one figure. */
function smallScores() {
  const [id = ""] = methodsIn();
  const { sets: [set] = [], ...scores } = JSON.parse(readFileSync(join(RESULTS, id, "scores.json"), "utf8"));
  const first = (/** @type {object} */ figures) => Object.fromEntries(Object.entries(figures).slice(0, 1));
  const few = (/** @type {any} */ of) => ({ ...of, definition: first(of.definition), published: first(of.published), figures: first(of.figures) });
  const { types, sizes, ...summary } = few(set.summary);
  const small = { ...set, summary: { ...summary, types: types.slice(0, 1), sizes: sizes.slice(0, 1) }, models: set.models.slice(0, 1).map(few) };
  return JSON.stringify({ ...scores, sets: [small] });
}

/** @type {import("../targets.mjs").Body} */
export const body = {
  seeds: () =>
    [
      ...methodsIn().map((id) => readFileSync(join(RESULTS, id, "method.toml"), "utf8")),
      readFileSync(join(RESULTS, "sets.toml"), "utf8").slice(0, 4000),
      smallScores(),
    ].map((text) => new TextEncoder().encode(text)),
  run(input) {
    const text = new TextDecoder().decode(input);
    const { method, findings } = readMethod(text);
    if (findings.length === 0) JSON.parse(feedOf([{ id: "mine", method, sets: [] }], "../"));
    readSets(text);
    const read = readScores(text, SETS);
    for (const { where, message } of [...findings, ...read.findings]) {
      assert.equal(typeof where, "string");
      // eslint-disable-next-line no-control-regex -- they are what is looked for
      assert.doesNotMatch(where + message, /[\u0000-\u001f\u007f]/);
    }
    if (read.findings.length > 0) return;
    const again = readScores(writeScores(read.scores), SETS);
    // The sign of a zero alone is lost in writing.
    alike(again, read);
    for (const set of read.scores.sets) assert.deepEqual(differencesOf(set, set), []);
  },
};
