// `--as`: what the caller knows better about a file than its name says.

import { ROLES } from "../../www/generated/declared/roles.js";
import { UsageError, choice } from "./usage.mjs";

const KEYS = ["role", "model", "method", "first"];

/**
 * The engine's overrides, by path, from values of the form `role=…,model=…,method=…,first=…:PATH`. An empty
 * method stands for the truth. In a name, `%2C` stands for a comma, `%3A` for a colon, `%25` for a
 * per cent sign.
 * @param {readonly string[]} values
 */
export function corrections(values) {
  return Object.fromEntries(values.map(correction));
}

/** @param {string} value */
function correction(value) {
  const colon = value.indexOf(":");
  const path = value.slice(colon + 1);
  if (colon < 0 || path === "") {
    throw new UsageError(`--as ${value}: expected role=…,model=…,method=…,first=…:FILE, as many of the four as are to be corrected`);
  }
  const pairs = value.slice(0, colon).split(",").map((pair) => keyAndName(pair, value));
  return [path, Object.fromEntries(pairs)];
}

/**
 * @param {string} pair
 * @param {string} value
 */
function keyAndName(pair, value) {
  const [, key = "", name = ""] = /^(\w+)=(.*)$/s.exec(pair) ?? [];
  if (!KEYS.includes(key)) {
    throw new UsageError(`--as ${value}: expected ${KEYS.map((known) => `${known}=…`).join(", ")} before the colon`);
  }
  if (key === "role") {
    choice("as role", name, ROLES.map((role) => role.name));
  }
  if (key === "first") {
    return [key, Number(choice("as first", name, ["0", "1"]))];
  }
  try {
    return [key, decodeURIComponent(name)];
  } catch {
    throw new UsageError(`--as ${value}: write %25 for a per cent sign`);
  }
}
