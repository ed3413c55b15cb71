// Reading the arguments of a command.

import { parseArgs } from "node:util";

/** The command was called wrongly; the message says how, the exit code is 2. */
export class UsageError extends Error {}

/**
 * Parses the arguments by the options given as for `util.parseArgs`. Numbers that start with a
 * minus sign stay values of the option before them.
 */
export function readArguments(args, options) {
  const joined = joinNegativeNumbers(args, options);
  try {
    return parseArgs({ args: joined, options, allowPositionals: true, strict: true });
  } catch (error) {
    throw new UsageError(error.message.replace(/\. To specify a positional.*$/s, ""));
  }
}

function joinNegativeNumbers(args, options) {
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

/** One of the allowed words. */
export function choice(option, value, allowed) {
  if (!allowed.includes(value)) {
    throw new UsageError(`--${option} ${value}: expected ${allowed.join(", ")}`);
  }
  return value;
}

/** A number from `least` to `most`, or undefined where the option was not given. */
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
