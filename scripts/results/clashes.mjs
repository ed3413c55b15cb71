// A row against the others of the table: what cannot be the case for both.

import { few } from "../../www/shared/results/scores.mjs";
import { oneLine } from "../../www/shared/text.mjs";

/**
 * @typedef {ReturnType<typeof import("../../bin/cli/standing/folder.mjs").readFolder>} Folder
 * @typedef {import("../../www/shared/results/checking.mjs").Finding} Finding
 * @typedef {import("../../www/shared/results/scores.mjs").SetScores} SetScores
 */

/**
 * @param {Folder} own
 * @param {readonly Folder[]} others
 * @param {import("../../www/shared/results/sets.mjs").Sets} sets
 * @returns {Finding[]}
 */
export function clashesOf(own, others, { sets }) {
  if (!own.method || !own.scores) return [];
  const { name } = own.method;
  const clean = new Set(sets.filter(({ degraded }) => !degraded).map(({ id }) => id));
  /** @type {Finding[]} */
  const findings = [];
  for (const other of others) {
    if (!other.method || !other.scores) continue;
    if (bare(other.method.name) === bare(name)) findings.push({ where: "name", message: `${other.id} is called ${oneLine(other.method.name)} already` });
    const pairs = own.scores.sets.flatMap((set) => {
      const theirs = other.scores?.sets.find((each) => each.set === set.set);
      return theirs ? [{ set, theirs }] : [];
    });
    // Different methods may well agree on worse scans.
    const compared = pairs.filter(({ set }) => clean.has(set.set));
    if (compared.length > 0 && compared.every(({ set, theirs }) => unlike(set, theirs, "answers").length === 0)) {
      findings.push({ where: "answers", message: `they are those of ${other.id}, to the last byte: the row would be a duplicate` });
    }
    for (const { set, theirs } of pairs) {
      const differing = unlike(set, theirs, "inputs");
      if (differing.length > 0) findings.push({ where: set.set, message: `${few(differing)}: cloud or ground truth are other files than those that ${other.id} was scored on` });
    }
  }
  return findings;
}

/**
 * The models of which files have other hashes.
 * @param {SetScores} one
 * @param {SetScores} other
 * @param {"inputs" | "answers"} which
 */
function unlike(one, other, which) {
  const theirs = new Map(other.models.map((entry) => [entry.model, entry[which]]));
  const key = (/** @type {object | undefined} */ hashes) => JSON.stringify(Object.entries(hashes ?? {}).sort(([one], [another]) => one.localeCompare(another)));
  return one.models.filter((entry) => key(entry[which]) !== key(theirs.get(entry.model))).map(({ model }) => model);
}

/**
 * A name without what makes it look like another.
 * @param {string} name
 */
function bare(name) {
  return name.normalize("NFKC").toLowerCase().replace(/[^\p{L}\p{N}]/gu, "");
}
