// A row between those above and below it, as Markdown.

import { FIGURES } from "../../www/generated/declared/figures.js";
import { MEASURES as DECLARED } from "../../www/generated/declared/measures.js";
import { escapedMarkdown } from "../../www/shared/formats/markdown.mjs";

/**
 * @typedef {ReturnType<typeof import("../../bin/cli/standing/folder.mjs").readFolder>} Folder
 * @typedef {import("../../www/shared/results/scores.mjs").Summary} Summary
 * @typedef {{ title: string, decimals: number, of: (summary: Summary) => number | undefined }} Column
 */

/** @type {readonly Column[]} */
const MEASURES = DECLARED.map(({ key, decimals }) => ({ title: key, decimals, of: ({ definition }) => definition[key]?.mean }));
/** @type {readonly Column[]} */
const FIELD = FIGURES.filter(({ group }) => group === "segmentation").map(({ key, title, decimals }) => ({ title, decimals, of: ({ figures }) => figures[key]?.mean }));
/** @type {Column} */
const SECONDS = { title: "seconds a cloud, median", decimals: 2, of: ({ seconds }) => seconds?.median };

/** What rows are ordered by, here as on the page. */
const ORDER = MEASURES[0];

/**
 * For each set of a row the rows above and below it, with its own figures minus theirs.
 * @param {Folder} own
 * @param {readonly Folder[]} others
 * @param {import("../../www/shared/results/sets.mjs").Sets} sets
 */
export function neighbours(own, others, { sets }) {
  const tables = (own.scores?.sets ?? []).flatMap(({ set, summary }) => {
    const title = sets.find(({ id }) => id === set)?.title ?? set;
    const all = [own, ...others].flatMap((folder) => {
      const found = folder.scores?.sets.find((each) => each.set === set);
      return found && folder.method ? [{ folder, name: folder.method.name, summary: found.summary }] : [];
    });
    all.sort((one, other) => (ORDER?.of(other.summary) ?? -1) - (ORDER?.of(one.summary) ?? -1));
    const at = all.findIndex(({ folder }) => folder === own);
    const near = all.slice(Math.max(0, at - 1), at + 2);
    return [
      `\n### ${escapedMarkdown(title)}: place ${at + 1} of ${all.length} by ${ORDER?.title ?? ""}\n`,
      ...[[...MEASURES, SECONDS], FIELD].map((columns) => tableOf(near, own, summary, columns)),
    ];
  });
  return tables.join("\n");
}

/**
 * @param {readonly { folder: Folder, name: string, summary: Summary }[]} rows
 * @param {Folder} own
 * @param {Summary} summary
 * @param {readonly Column[]} columns
 */
function tableOf(rows, own, summary, columns) {
  const line = (/** @type {readonly string[]} */ cells) => `| ${cells.join(" | ")} |`;
  const cell = (/** @type {Column} */ { of, decimals }, /** @type {Summary} */ theirs, /** @type {boolean} */ isOwn) => {
    const [value, mine] = [of(theirs), of(summary)];
    if (value === undefined) return "n/a";
    if (isOwn || mine === undefined) return value.toFixed(decimals);
    const by = mine - value;
    return `${value.toFixed(decimals)} (${by < 0 ? "−" : "+"}${Math.abs(by).toFixed(decimals)})`;
  };
  return [
    line(["method", ...columns.map(({ title }) => escapedMarkdown(title))]),
    line(["---", ...columns.map(() => "---:")]),
    ...rows.map(({ folder, name, summary: theirs }) => {
      const isOwn = folder === own;
      return line([isOwn ? `**${escapedMarkdown(name)}**` : escapedMarkdown(name), ...columns.map((column) => cell(column, theirs, isOwn))]);
    }),
    "",
  ].join("\n");
}
