// The fitters' parameters as options, out of the engine's table.

import { FITTERS } from "../../www/generated/declared/fitters.js";
import { terms } from "./terms.mjs";
import { UsageError, number } from "./usage.mjs";

/** @typedef {import("../engine/engine.js").FitMethod} FitMethod */
/** @typedef {import("../engine/engine.js").ParameterInfo} ParameterInfo */
/** @typedef {{ info: ParameterInfo, flag: string, methods: FitMethod[] }} Option */


export const METHODS = FITTERS.map(({ name }) => name);

/** Every parameter of any method, each once. */
export function parameterOptions() {
  /** @type {Map<string, Option>} */
  const options = new Map();
  for (const { name, parameters } of FITTERS) {
    for (const info of parameters) {
      const known = options.get(info.name) ?? { info, flag: flagOf(info.name), methods: [] };
      options.set(info.name, { ...known, methods: [...known.methods, name] });
    }
  }
  return [...options.values()];
}

/**
 * The values given among those of `util.parseArgs`, by parameter name.
 * @param {readonly Option[]} options
 * @param {FitMethod} method
 * @param {Readonly<Record<string, string | boolean | undefined>>} values
 */
export function givenParameters(options, method, values) {
  /** @type {Record<string, number>} */
  const given = {};
  for (const { info, flag, methods } of options) {
    const value = values[flag];
    if (typeof value !== "string") {
      continue;
    }
    if (!methods.includes(method)) {
      throw new UsageError(`--${flag} is of method ${methods.join(", ")}; ${method} has no such parameter`);
    }
    const { minimum: least, maximum: most, whole } = info;
    const parsed = number(flag, value, { least, most, whole });
    if (parsed !== undefined) {
      given[info.name] = parsed;
    }
  }
  return given;
}

/** The part of `fit --help` that lists the parameters. */
export function parameterHelp() {
  return parameterOptions().map(describe).join("");
}

/** @param {Option} option */
function describe({ info, flag, methods }) {
  const only = methods.length < METHODS.length ? `; ${methods.join(", ").toUpperCase()} only` : "";
  const head = `  --${`${flag} N`.padEnd(24)}${rangeOf(info)}${only}\n`;
  return head + terms([["", info.explanation]], 6);
}

/**
 * The values that an option takes, and its default.
 * @param {ParameterInfo} info
 */
export function rangeOf({ whole, minimum, maximum, unit, default: initial }) {
  return `${whole ? "whole number, " : ""}${minimum} to ${maximum}${unit && ` ${unit}`}, default ${initial}`;
}

/** @param {string} name */
function flagOf(name) {
  return name.replaceAll("_", "-");
}
