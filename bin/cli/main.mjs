// The command line: finds the command, turns failures into exit codes.

import { NotBuilt, codeOf } from "./engine.mjs";
import { asksForJson } from "./format.mjs";
import { endOnClosedPipe, print, warn } from "./terminal.mjs";
import { UsageError } from "./usage.mjs";
import { NotWritten } from "./write.mjs";

const USAGE = 2;
const FAILED = 1;

const COMMANDS = {
  score: async () => (await import("./score.mjs")).score,
  fit: async () => (await import("./fit.mjs")).fit,
  export: async () => (await import("./export.mjs")).exportFiles,
  import: async () => (await import("./import.mjs")).importParts,
  check: async () => (await import("./check.mjs")).check,
  stats: async () => (await import("./stats.mjs")).stats,
  generate: async () => (await import("./generate.mjs")).generate,
  degrade: async () => (await import("./degrade.mjs")).degrade,
  submit: async () => (await import("./submit.mjs")).submit,
  verify: async () => (await import("./verify.mjs")).verify,
};

/** @typedef {keyof typeof COMMANDS} Command */

/**
 * Runs the command line; gives the exit code: 0 all well, 1 some input unusable, 2 called wrongly.
 * @param {readonly string[]} args
 */
export async function main(args) {
  endOnClosedPipe();
  const [name, ...rest] = args;
  if (name === undefined) {
    return attempt("help", args, async () => {
      process.stderr.write(await helpOn("fit4cad"));
      return USAGE;
    });
  }
  if (name === "help" || name === "--help" || name === "-h") {
    const topic = rest[0] ?? "fit4cad";
    return topic === "fit4cad" || isCommand(topic) ? help(topic) : unknown(topic, rest);
  }
  if (name === "--version" || name === "-V") {
    const { loadEngine } = await import("./engine.mjs");
    return attempt(name, rest, async () => {
      await print(`fit4cad ${(await loadEngine()).version()}\n`);
      return 0;
    });
  }
  if (!isCommand(name)) {
    return unknown(name, rest);
  }
  if (rest.includes("--help") || rest.includes("-h")) {
    return help(name);
  }
  return attempt(name, rest, async () => {
    const command = await COMMANDS[name]();
    return command(rest);
  });
}

/**
 * @param {string} name
 * @returns {name is Command}
 */
function isCommand(name) {
  return Object.hasOwn(COMMANDS, name);
}

/**
 * Says that there is no such command; gives the exit code.
 * @param {string} name
 * @param {readonly string[]} args
 */
function unknown(name, args) {
  const message = `there is no command "${name}". Commands: ${Object.keys(COMMANDS).join(", ")}; try fit4cad --help.`;
  return fail("fit4cad", args, { code: USAGE, message });
}

/** @param {Command | "fit4cad"} topic */
function help(topic) {
  return attempt("help", [], async () => {
    await print(await helpOn(topic));
    return 0;
  });
}

/**
 * Loaded when asked for: it lists what the built engine declares.
 * @param {Command | "fit4cad"} topic
 */
async function helpOn(topic) {
  const { HELP } = await import("./help.mjs");
  return HELP[topic]();
}

/**
 * Runs a command; a failure is said in the terminal, and in the result where JSON is asked for.
 * @param {string} name
 * @param {readonly string[]} args
 * @param {() => Promise<number>} body
 */
async function attempt(name, args, body) {
  try {
    return await body();
  } catch (error) {
    return fail(`fit4cad ${name}`, args, failureOf(name, error));
  }
}

/** @typedef {{ code: number, message: string, advice?: string }} Failure */

/**
 * @param {string} name
 * @param {unknown} error
 * @returns {Failure}
 */
function failureOf(name, error) {
  if (error instanceof UsageError) {
    return { code: USAGE, message: error.message, advice: `Try fit4cad ${name} --help.` };
  }
  if (error instanceof NotBuilt || error instanceof NotWritten) {
    return { code: FAILED, message: error.message };
  }
  if (codeOf(error) === "ERR_MODULE_NOT_FOUND") {
    return { code: FAILED, message: "The engine or the npm packages are not there yet. Run `npm run build` in the checkout, then try again." };
  }
  return { code: FAILED, message: error instanceof Error ? (error.stack ?? error.message) : String(error) };
}

/**
 * @param {string} who
 * @param {readonly string[]} args
 * @param {Failure} failure
 */
async function fail(who, args, { code, message, advice }) {
  warn(`${who}: ${message}`);
  if (advice !== undefined) {
    warn(advice);
  }
  if (asksForJson(args)) {
    await print(`${JSON.stringify({ error: message }, null, 2)}\n`);
  }
  return code;
}
