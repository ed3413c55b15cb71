// The command line: finds the command, turns failures into exit codes.

import { NotBuilt } from "./engine.mjs";
import { HELP } from "./help.mjs";
import { endOnClosedPipe, print, warn } from "./terminal.mjs";
import { UsageError } from "./usage.mjs";

const USAGE = 2;
const FAILED = 1;

const COMMANDS = {
  score: async () => (await import("./score.mjs")).score,
  fit: async () => (await import("./fit.mjs")).fit,
  check: async () => (await import("./check.mjs")).check,
  stats: async () => (await import("./stats.mjs")).stats,
  generate: async () => (await import("./generate.mjs")).generate,
};

/** Runs the command line; gives the exit code: 0 all well, 1 some input unusable, 2 called wrongly. */
export async function main(args) {
  endOnClosedPipe();
  const [name, ...rest] = args;
  if (name === undefined) {
    process.stderr.write(await HELP.fit4cad());
    return USAGE;
  }
  if (name === "help" || name === "--help" || name === "-h") {
    return rest.length === 0 ? help("fit4cad") : (unknown(rest[0]) ?? help(rest[0]));
  }
  if (name === "--version" || name === "-V") {
    const { loadEngine } = await import("./engine.mjs");
    return attempt(name, async () => {
      await print(`fit4cad ${(await loadEngine()).version()}\n`);
      return 0;
    });
  }
  if (rest.includes("--help") || rest.includes("-h")) {
    return unknown(name) ?? help(name);
  }
  return unknown(name) ?? attempt(name, async () => (await COMMANDS[name]())(rest));
}

/** Says that there is no such command, and gives the exit code; nothing where there is. */
function unknown(name) {
  if (Object.hasOwn(COMMANDS, name)) {
    return undefined;
  }
  warn(`fit4cad: there is no command "${name}". Commands: ${Object.keys(COMMANDS).join(", ")}; try fit4cad --help.`);
  return USAGE;
}

async function help(topic) {
  await print(await HELP[topic]());
  return 0;
}

async function attempt(name, body) {
  try {
    return await body();
  } catch (error) {
    if (error instanceof UsageError) {
      warn(`fit4cad ${name}: ${error.message}`);
      warn(`Try fit4cad ${name} --help.`);
      return USAGE;
    }
    if (error instanceof NotBuilt) {
      warn(error.message);
      return FAILED;
    }
    if (error.code === "ERR_MODULE_NOT_FOUND") {
      warn("The npm packages are not installed. Run `npm run build` in the checkout, then try again.");
      return FAILED;
    }
    warn(`fit4cad ${name}: ${error.stack ?? error}`);
    return FAILED;
  }
}
