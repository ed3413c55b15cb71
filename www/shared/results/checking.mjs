// @ts-check
// Looks at what somebody else wrote, key by key, and says in plain words what is wrong with it.

import { oneLine } from "../text.mjs";

/** @typedef {{ where: string, message: string }} Finding */

/** @typedef {Readonly<Record<string, unknown>>} Fields */

/** Most characters of a wrong value that are repeated to its author. */
const SHOWN = 60;

/**
 * A value as a finding shows it.
 * @param {unknown} value
 */
export function shown(value) {
  // JSON has no word for numbers beyond the largest: `1e999` is read as infinite, and would be written as null.
  const plain = typeof value === "bigint" || typeof value === "number";
  const text = value === undefined ? "nothing" : plain ? String(value) : JSON.stringify(value);
  return oneLine(text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text);
}

/**
 * Whether it is an object with keys, as TOML's tables and those of JSON are.
 * @param {unknown} value
 * @returns {value is Fields}
 */
export function hasFields(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value) && !(value instanceof Date);
}

/** What is found in a table, and in those within it. */
export class Checking {
  /** @type {Finding[]} */
  findings;
  #fields;
  #where;

  /**
   * @param {Fields} fields
   * @param {string} where what the table is called, empty for the outermost
   * @param {Finding[]} findings taken on by the tables within
   */
  constructor(fields, where = "", findings = []) {
    this.#fields = fields;
    this.#where = where;
    this.findings = findings;
  }

  /**
   * @param {string} key
   * @param {string} message
   */
  tell(key, message) {
    this.findings.push({ where: this.#where === "" ? key : `${this.#where}.${key}`, message });
  }

  /** @param {string} key */
  has(key) {
    return Object.hasOwn(this.#fields, key);
  }

  /** @param {string} key */
  value(key) {
    return this.has(key) ? this.#fields[key] : undefined;
  }

  /**
   * Tells of every key that is none of those there are.
   * @param {readonly string[]} known
   */
  only(known) {
    for (const key of Object.keys(this.#fields)) {
      if (!known.includes(key)) this.tell(shown(key), `there is no such key here; there are ${known.join(", ")}`);
    }
  }

  /**
   * A text of one line.
   * @param {string} key
   * @param {{ most?: number, pattern?: RegExp, expected?: string }} rules
   */
  text(key, { most = 200, pattern, expected = `a text of at most ${most} characters in one line` } = {}) {
    const value = this.value(key);
    const is = typeof value === "string" && value.trim() !== "" && value.length <= most && oneLine(value) === value;
    if (is && (pattern?.test(value) ?? true)) return value;
    this.tell(key, `expected ${expected}, found ${shown(value)}`);
    return "";
  }

  /**
   * The same where the key may be left out.
   * @param {string} key
   * @param {{ most?: number, pattern?: RegExp, expected?: string }} rules
   */
  optionalText(key, rules = {}) {
    return this.has(key) ? this.text(key, rules) : undefined;
  }

  /**
   * One of the allowed words.
   * @template {string} Word
   * @param {string} key
   * @param {readonly Word[]} allowed
   * @returns {Word | undefined}
   */
  word(key, allowed) {
    const value = this.value(key);
    const word = allowed.find((each) => each === value);
    if (word === undefined) this.tell(key, `expected ${allowed.join(", ")}, found ${shown(value)}`);
    return word;
  }

  /**
   * A finite number.
   * @param {string} key
   * @param {{ least?: number, most?: number, whole?: boolean }} range
   */
  number(key, { least = -Infinity, most = Infinity, whole = false } = {}) {
    const value = this.value(key);
    const fits = typeof value === "number" && Number.isFinite(value) && value >= least && value <= most;
    if (fits && (!whole || Number.isSafeInteger(value))) return value;
    const range = [least > -Infinity ? ` of at least ${least}` : "", most < Infinity ? ` of at most ${most}` : ""];
    this.tell(key, `expected a ${whole ? "whole " : ""}number${range.filter((part) => part).join(" and")}, found ${shown(value)}`);
    return 0;
  }

  /**
   * A table within.
   * @param {string} key
   */
  table(key) {
    const value = this.value(key);
    const where = this.#where === "" ? key : `${this.#where}.${key}`;
    if (hasFields(value)) return new Checking(value, where, this.findings);
    this.tell(key, `expected a table, found ${shown(value)}`);
    return undefined;
  }

  /**
   * A list of tables within, at most so many.
   * @param {string} key
   * @param {number} most
   */
  tables(key, most) {
    const value = this.value(key);
    if (!Array.isArray(value) || value.length > most || !value.every(hasFields)) {
      this.tell(key, `expected a list of at most ${most} tables, found ${shown(value)}`);
      return [];
    }
    const where = this.#where === "" ? key : `${this.#where}.${key}`;
    return value.map((fields, at) => new Checking(fields, `${where}[${at + 1}]`, this.findings));
  }
}
