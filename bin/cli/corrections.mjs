// `--as`: what the caller knows better about a file than its name says.

import { UsageError, choice } from "./usage.mjs";

const KEYS = ["role", "model", "method"];
const ROLES = ["cloud", "primitives", "parametric", "implicit"];

/**
 * The engine's overrides, by path, from values of the form `role=…,model=…,method=…:PATH`. An empty
 * method stands for the truth. In a name, `%2C` stands for a comma, `%3A` for a colon, `%25` for a
 * per cent sign.
 */
export function corrections(values) {
  return Object.fromEntries(values.map(correction));
}

function correction(value) {
  const colon = value.indexOf(":");
  const path = value.slice(colon + 1);
  if (colon < 0 || path === "") {
    throw new UsageError(`--as ${value}: expected role=…,model=…,method=…:FILE, as many of the three as are to be corrected`);
  }
  const pairs = value.slice(0, colon).split(",").map((pair) => keyAndName(pair, value));
  return [path, Object.fromEntries(pairs)];
}

function keyAndName(pair, value) {
  const [, key, name] = /^(\w+)=(.*)$/s.exec(pair) ?? [];
  if (!KEYS.includes(key)) {
    throw new UsageError(`--as ${value}: expected ${KEYS.map((known) => `${known}=…`).join(", ")} before the colon`);
  }
  if (key === "role") {
    choice("as role", name, ROLES);
  }
  try {
    return [key, decodeURIComponent(name)];
  } catch {
    throw new UsageError(`--as ${value}: write %25 for a per cent sign`);
  }
}
