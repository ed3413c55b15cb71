// The fitters' parameters as options, out of the engine's table.

import { NotBuilt, loadEngine } from "./engine.mjs";
import { UsageError, number } from "./usage.mjs";

export const METHODS = ["ht", "pg"];

const WIDTH = 96;
const INDENT = " ".repeat(6);

/** Every parameter of any method, each once, as `{ info, flag, methods }`. */
export function parameterOptions(engine) {
  const options = new Map();
  for (const method of METHODS) {
    for (const info of engine.fitParameters(method)) {
      const known = options.get(info.name) ?? { info, flag: flagOf(info.name), methods: [] };
      options.set(info.name, { ...known, methods: [...known.methods, method] });
    }
  }
  return [...options.values()];
}

/** The values given among those of `util.parseArgs`, by parameter name. */
export function givenParameters(options, method, values) {
  const given = {};
  for (const { info, flag, methods } of options) {
    if (values[flag] === undefined) {
      continue;
    }
    if (!methods.includes(method)) {
      throw new UsageError(`--${flag} is of method ${methods.join(", ")}; ${method} has no such parameter`);
    }
    const { minimum: least, maximum: most, whole } = info;
    given[info.name] = number(flag, values[flag], { least, most, whole });
  }
  return given;
}

/** The part of `fit --help` that lists the parameters. */
export async function parameterHelp() {
  try {
    return parameterOptions(await loadEngine()).map(describe).join("");
  } catch (error) {
    if (error instanceof NotBuilt) {
      return "  (listed once the engine is built: npm run build)\n";
    }
    throw error;
  }
}

function describe({ info, flag, methods }) {
  const kind = info.whole ? "whole number, " : "";
  const unit = info.unit ? ` ${info.unit}` : "";
  const range = `${kind}${info.minimum} to ${info.maximum}${unit}, default ${info.default}`;
  const only = methods.length < METHODS.length ? `; ${methods.join(", ").toUpperCase()} only` : "";
  return `  --${`${flag} N`.padEnd(24)}${range}${only}\n${wrap(info.explanation)}\n`;
}

function wrap(text) {
  const lines = [INDENT];
  for (const word of text.split(" ")) {
    const last = lines.length - 1;
    const joined = lines[last] === INDENT ? INDENT + word : `${lines[last]} ${word}`;
    if (joined.length <= WIDTH) {
      lines[last] = joined;
    } else {
      lines.push(INDENT + word);
    }
  }
  return lines.join("\n");
}

function flagOf(name) {
  return name.replaceAll("_", "-");
}
