// @ts-check
// A table for the eye: one row per finding, then how many there are.

import { align } from "./align.mjs";

const HEAD = ["model", "primitive", "severity", "check", "finding"];

/** @typedef {import("../../generated/engine/engine.js").Audit} Audit */

/**
 * The findings of audits as a table.
 * @param {readonly Audit[]} audits
 */
export function findings(audits) {
  const rows = audits.flatMap(({ model, findings: own }) =>
    own.map(({ primitive, severity, check, message, hint }) => [
      model,
      primitive === null ? "" : String(primitive),
      severity,
      check,
      hint === "" ? message : `${message}. ${hint}`,
    ]),
  );
  const lines = rows.length === 0 ? [] : [align([HEAD, ...rows], HEAD.length)];
  return audits.length === 0 ? "" : `${[...lines, summary(audits)].join("\n")}\n`;
}

/** @param {readonly Audit[]} audits */
function summary(audits) {
  const all = audits.flatMap(({ findings: own }) => own);
  /** @param {Audit["findings"][number]["severity"]} wanted */
  const count = (wanted) => all.filter(({ severity }) => severity === wanted).length;
  const primitives = audits.reduce((sum, audit) => sum + audit.primitives.length, 0);
  const counts = [
    counted(count("error"), "error"),
    counted(count("warning"), "warning"),
    counted(count("note"), "note"),
  ];
  return `${counted(audits.length, "model")}, ${counted(primitives, "primitive")}: ${counts.join(", ")}`;
}

/** @param {number} number @param {string} noun */
function counted(number, noun) {
  return `${number} ${noun}${number === 1 ? "" : "s"}`;
}
