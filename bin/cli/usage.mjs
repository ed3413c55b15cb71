// Reading the arguments of a command.

import { parseArgs } from "node:util";

/**
 * What `util.parseArgs` takes for options.
 * @typedef {NonNullable<import("node:util").ParseArgsConfig["options"]>} Options
 */

/**
 * The values of options, as `util.parseArgs` gives them.
 * @template {Options} O
 * @typedef {ReturnType<typeof parseArgs<{ options: O, strict: true }>>["values"]} Values
 */

/** The command was called wrongly; the message says how, the exit code is 2. */
export class UsageError extends Error {}

/**
 * Parses the arguments by the options given as for `util.parseArgs`. Numbers that start with a
 * minus sign stay values of the option before them.
 * @template {Options} O
 * @param {readonly string[]} args
 * @param {O} options
 * @returns {{ values: Values<O>, positionals: string[] }}
 */
export function readArguments(args, options) {
  const joined = joinNegativeNumbers(args, options);
  try {
    return parseArgs({ args: joined, options, allowPositionals: true, strict: true });
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message.replace(/\. To specify a positional.*$/s, "") : String(error));
  }
}

/**
 * @param {readonly string[]} args
 * @param {Options} options
 */
function joinNegativeNumbers(args, options) {
  /** @type {string[]} */
  const joined = [];
  for (const argument of args) {
    const before = joined.at(-1);
    const takesValue = before?.startsWith("--") && options[before.slice(2)]?.type === "string";
    if (takesValue && /^-\.?\d/.test(argument)) {
      joined[joined.length - 1] = `${before}=${argument}`;
    } else {
      joined.push(argument);
    }
  }
  return joined;
}

/**
 * One of the allowed words.
 * @template {string} Word
 * @param {string} option
 * @param {string} value
 * @param {readonly Word[]} allowed
 */
export function choice(option, value, allowed) {
  const word = allowed.find((each) => each === value);
  if (word === undefined) {
    throw new UsageError(`--${option} ${value}: expected ${allowed.join(", ")}`);
  }
  return word;
}

/**
 * A number from `least` to `most`, or undefined where the option was not given.
 * @param {string} option
 * @param {string | undefined} value
 * @param {{ least?: number, most?: number, whole?: boolean }} range
 */
export function number(option, value, { least = -Infinity, most = Infinity, whole = false } = {}) {
  if (value === undefined) {
    return undefined;
  }
  const parsed = value.trim() === "" ? NaN : Number(value);
  if (!(parsed >= least && parsed <= most) || (whole && !Number.isSafeInteger(parsed))) {
    const kind = whole ? "a whole number" : "a number";
    const range = most === Infinity ? `of at least ${least}` : `from ${least} to ${most}`;
    throw new UsageError(`--${option} ${value}: expected ${kind} ${range}`);
  }
  return parsed;
}

/**
 * The numbers given for options that the engine declares with their ranges, by name.
 * @param {readonly { name: string, minimum: number, maximum: number, whole: boolean }[]} declared
 * @param {Readonly<Record<string, unknown>>} given
 */
export function numbersOf(declared, given) {
  /** @type {Record<string, number>} */
  const numbers = {};
  for (const { name, minimum: least, maximum: most, whole } of declared) {
    const word = given[name];
    const value = typeof word === "string" ? number(name, word, { least, most, whole }) : undefined;
    if (value !== undefined) numbers[name] = value;
  }
  return numbers;
}
