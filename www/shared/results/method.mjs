// @ts-check
// `method.toml`: what a row of the standing table is of, as its author says. Read and checked here for
// the command line, the workflow and the page alike.

import { TomlError, parse } from "smol-toml";
import { FITTERS } from "../../generated/declared/fitters.js";
import { Checking } from "./checking.mjs";
import { KINDS } from "./kinds.mjs";

/** @typedef {import("./checking.mjs").Finding} Finding */

/**
 * @typedef {{ given: string, family: string } | { name: string }} Author
 * @typedef {(typeof KINDS)[number]["name"]} Kind
 * @typedef {(typeof PLATFORMS)[number]} Platform
 * @typedef {import("../../generated/engine/engine.js").FitMethod} FitMethod
 */

/**
 * How the answers are had by somebody who wants to check them: exactly one of four ways.
 * @typedef {{ way: "archive", archive: string, sha256: string }
 *   | { way: "public" }
 *   | { way: "fitter", fitter: FitMethod }
 *   | { way: "script", script: string }} Source
 */

/**
 * @typedef {object} Method
 * @property {string} name
 * @property {readonly Author[]} authors
 * @property {number} year
 * @property {Kind} kind
 * @property {string} trainedOn in words; `nothing` for what learns nothing
 * @property {string} added a day, as `2026-11-29`
 * @property {string | undefined} note what has to be known to read the row
 * @property {string | undefined} code where the code is
 * @property {{ title: string, journal: string | undefined, doi: string | undefined, url: string | undefined } | undefined} paper
 * @property {{ platform: Platform, machine: string, seconds: number | undefined, source: string | undefined } | undefined} time
 * @property {{ called: string, licence: string } & Source} answers `called`: the method in the names of their folders
 * @property {readonly { day: string, what: string }[]} changes
 */

export const PLATFORMS = /** @type {const} */ (["wasm", "native"]);

/** A folder of `results`: what stands in addresses. */
export const ID = /^[a-z0-9](?:[a-z0-9-]{0,46}[a-z0-9])?$/;

/** More is no description of a method. */
export const MOST_TOML = 64 * 2 ** 10;

const HTTPS = { most: 300, pattern: /^https:\/\/[^\s"<>\\^`{|}]+$/, expected: "an address that begins with https://" };
export const SHA256 = /^[0-9a-f]{64}$/;
const DAY = /^\d{4}-(?:0[1-9]|1[0-2])-(?:0[1-9]|[12]\d|3[01])$/;

/**
 * Reads the text of a `method.toml`. Without findings the method is whole.
 * @param {string} text
 * @returns {{ method: Method, findings: readonly Finding[] }}
 */
export function readMethod(text) {
  const { fields, finding } = tableOf(text);
  const all = new Checking(fields, "", finding ? [finding] : []);
  const method = finding ? undefined : methodOf(all);
  return { method: method ?? methodOf(new Checking({})), findings: all.findings };
}

/**
 * The table that a TOML file is, or why it is none.
 * @param {string} text
 * @returns {{ fields: import("./checking.mjs").Fields, finding?: Finding }}
 */
export function tableOf(text) {
  if (text.length > MOST_TOML) {
    return { fields: {}, finding: { where: "file", message: `it has more than ${MOST_TOML} characters` } };
  }
  try {
    return { fields: parse(text, { maxDepth: 16 }) };
  } catch (error) {
    if (error instanceof TomlError) {
      const [message = ""] = error.message.split("\n");
      return { fields: {}, finding: { where: `line ${error.line}, column ${error.column}`, message: message.replace(/^Invalid TOML document: /, "") } };
    }
    return { fields: {}, finding: { where: "file", message: error instanceof Error ? error.message : String(error) } };
  }
}

/**
 * @param {Checking} all
 * @returns {Method}
 */
function methodOf(all) {
  all.only(["name", "authors", "year", "kind", "trained_on", "added", "note", "code", "paper", "time", "answers", "changes"]);
  return {
    name: all.text("name", { most: 60 }),
    authors: all.tables("authors", 100).map(authorOf),
    year: all.number("year", { least: 1950, most: 2100, whole: true }),
    kind: all.word("kind", KINDS.map(({ name }) => name)) ?? "other",
    trainedOn: all.text("trained_on"),
    added: day(all, "added"),
    note: all.optionalText("note", { most: 600 }),
    code: all.optionalText("code", HTTPS),
    paper: all.has("paper") ? paperOf(all.table("paper")) : undefined,
    time: all.has("time") ? timeOf(all.table("time")) : undefined,
    answers: answersOf(all.table("answers")),
    changes: all.has("changes") ? all.tables("changes", 200).map(changeOf) : [],
  };
}

/**
 * @param {Checking} author
 * @returns {Author}
 */
function authorOf(author) {
  author.only(["given", "family", "name"]);
  return author.has("name") ? { name: author.text("name") } : { given: author.text("given"), family: author.text("family") };
}

/** @param {Checking | undefined} paper */
function paperOf(paper) {
  paper?.only(["title", "journal", "doi", "url"]);
  return {
    title: paper?.text("title", { most: 300 }) ?? "",
    journal: paper?.optionalText("journal"),
    doi: paper?.optionalText("doi", { pattern: /^10\.\d{4,9}\/[^\s"<>]+$/, expected: "a DOI such as 10.1016/j.cag.2021.09.013" }),
    url: paper?.optionalText("url", HTTPS),
  };
}

/** @param {Checking | undefined} time */
function timeOf(time) {
  time?.only(["platform", "machine", "seconds", "source"]);
  return {
    platform: time?.word("platform", PLATFORMS) ?? "native",
    machine: time?.text("machine") ?? "",
    seconds: time?.has("seconds") ? time.number("seconds", { least: 0 }) : undefined,
    source: time?.optionalText("source"),
  };
}

/**
 * @param {Checking | undefined} answers
 * @returns {Method["answers"]}
 */
function answersOf(answers) {
  if (!answers) return { called: "", licence: "", way: "script", script: "" };
  answers.only(["called", "licence", "archive", "sha256", "public", "fitter", "script"]);
  const common = { called: answers.text("called", { most: 60 }), licence: answers.text("licence", { most: 60 }) };
  const ways = ["archive", "public", "fitter", "script"].filter((way) => answers.has(way));
  if (ways.length !== 1) {
    answers.tell("archive", `expected exactly one of archive, public, fitter and script: where the answers are had. Found ${ways.join(" and ") || "none"}`);
    return { ...common, way: "script", script: "" };
  }
  switch (ways[0]) {
    case "archive":
      return {
        ...common,
        way: "archive",
        archive: answers.text("archive", { ...HTTPS, pattern: /^https:\/\/[^\s"<>\\^`{|}]+\.zip$/i, expected: "the address of a zip that begins with https://" }),
        sha256: answers.text("sha256", { pattern: SHA256, expected: "the SHA-256 of the zip, 64 hexadecimal digits" }),
      };
    case "public":
      if (answers.value("public") !== true) answers.tell("public", "expected true: the answers are in the public repository");
      return { ...common, way: "public" };
    case "fitter":
      return { ...common, way: "fitter", fitter: answers.word("fitter", FITTERS.map(({ name }) => name)) ?? "ht" };
    default:
      return { ...common, way: "script", script: answers.text("script", { pattern: /^scripts\/results\/[a-z0-9-]+\.py$/, expected: "a script of this repository, scripts/results/….py" }) };
  }
}

/** @param {Checking} change */
function changeOf(change) {
  change.only(["day", "what"]);
  return { day: day(change, "day"), what: change.text("what", { most: 400 }) };
}

/**
 * A day; TOML has a type of its own for it.
 * @param {Checking} table
 * @param {string} key
 */
function day(table, key) {
  const value = table.value(key);
  const text = value instanceof Date && !Number.isNaN(value.getTime()) ? value.toISOString().slice(0, 10) : value;
  if (typeof text === "string" && DAY.test(text)) return text;
  table.tell(key, "expected a day such as 2026-11-29");
  return "";
}
