// Which Rust modules use which, and whether some use each other in a circle.
//
// What a module uses of those that it is in does not count: these hold what their parts share, and
// show the parts together. Tests may use what they like.

import { existsSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { ROOT } from "./paths.mjs";

/**
 * @typedef {{ from: string, to: string, path: string, file: string, line: number }} Use
 * @typedef {{ segments: string[], alias: string, line: number, shown: boolean }} Path
 * @typedef {{ name: string, file: string, children: Set<string>, paths: Path[] }} Module
 * @typedef {Map<string, Module>} Modules
 * @typedef {Map<string, Use[]>} Uses
 */

/**
 * Circles among the modules of a crate, each as the uses that make it up, the shortest through some
 * module of each knot.
 * @param {string} root its lib.rs or main.rs
 * @returns {Use[][]}
 */
export function circles(root) {
  const modules = readCrate(root);
  const uses = new Map([...modules.values()].map((module) => [module.name, usesOf(module, modules)]));
  return knots(uses).map((knot) => shortestCircle(knot, uses));
}

/**
 * Says what a circle is made of, a line for each use.
 * @param {Use[]} circle
 */
export function tell(circle) {
  return circle.map(
    ({ from, to, path, file, line }) => `${from} uses ${to}: ${path} (${relative(ROOT, file)}:${line})`,
  );
}

/**
 * Every module of the crate that has a file, by name.
 * @param {string} root
 */
function readCrate(root) {
  /** @type {Modules} */
  const modules = new Map();
  const open = [{ name: "crate", file: root }];
  for (let next = open.pop(); next; next = open.pop()) {
    const { name, file } = next;
    const text = withoutTests(bare(readFileSync(file, "utf8")));
    const children = new Set(Array.from(text.matchAll(/\bmod\s+(\w+)\s*;/g), ([, child = ""]) => child));
    modules.set(name, { name, file, children, paths: pathsIn(text, children) });
    for (const child of children) {
      open.push({ name: `${name}::${child}`, file: fileOf(child, file) });
    }
  }
  return modules;
}

/**
 * @param {string} child
 * @param {string} file of its parent
 */
function fileOf(child, file) {
  const isFolder = /(?:^|[\\/])(?:lib|main|mod)\.rs$/.test(file);
  const folder = isFolder ? dirname(file) : file.replace(/\.rs$/, "");
  const flat = join(folder, `${child}.rs`);
  return existsSync(flat) ? flat : join(folder, child, "mod.rs");
}

/**
 * Spaces in place of a text, line ends kept.
 * @param {string} text
 */
function blank(text) {
  return text.replace(/[^\n]/g, " ");
}

/**
 * A source with comments and literals blanked.
 * @param {string} text
 */
function bare(text) {
  return text.replace(
    /\/\/[^\n]*|\/\*[^]*?\*\/|r(#*)"[^]*?"\1|"(?:\\[^]|[^"\\])*"|'(?:\\[^']+|[^\\'])'/g,
    blank,
  );
}

/**
 * A bare source with what is compiled for tests alone blanked.
 * @param {string} text
 */
function withoutTests(text) {
  let rest = text;
  for (;;) {
    const start = rest.search(/#\[cfg\(test\)\]/);
    if (start < 0) {
      return rest;
    }
    const end = endOfItem(rest, start);
    rest = rest.slice(0, start) + blank(rest.slice(start, end)) + rest.slice(end);
  }
}

/**
 * Where the item that begins here ends: at its semicolon, or at the brace that closes it.
 * @param {string} text
 * @param {number} start
 */
function endOfItem(text, start) {
  let depth = 0;
  for (let at = start; at < text.length; at += 1) {
    if (text[at] === "{") {
      depth += 1;
    } else if (text[at] === "}") {
      depth -= 1;
    }
    if (depth === 0 && (text[at] === ";" || text[at] === "}")) {
      return at + 1;
    }
  }
  return text.length;
}

/**
 * The paths that a bare source imports or writes out.
 * @param {string} text
 * @param {Set<string>} children
 */
function pathsIn(text, children) {
  /** @param {number} at */
  const lineAt = (at) => text.slice(0, at).split("\n").length;
  /** @type {Path[]} */
  const paths = [];
  const imports = /(\bpub(?:\([^)]*\))?\s+)?\buse\s+([^;]+);/g;
  for (const { 1: shown, 2: tree = "", index } of text.matchAll(imports)) {
    for (const path of leaves(tree.replace(/\s+as\s+/g, "=").replace(/\s+/g, ""))) {
      paths.push({ ...path, line: lineAt(index), shown: shown !== undefined });
    }
  }
  for (const { 0: path, index } of text.replace(imports, blank).matchAll(/(?<![\w:])\w+(?:\s*::\s*\w+)+/g)) {
    const segments = path.split("::").map((segment) => segment.trim());
    const [first = ""] = segments;
    if (["crate", "self", "super"].includes(first) || children.has(first)) {
      paths.push({ segments, alias: "", line: lineAt(index), shown: false });
    }
  }
  return paths;
}

/**
 * The single paths of the tree of a use: `a::{b, c::d=e}` is `a::b` and `a::c::d` as `e`.
 * @param {string} tree
 * @param {string[]} before
 * @returns {{ segments: string[], alias: string }[]}
 */
function leaves(tree, before = []) {
  const brace = tree.indexOf("{");
  if (brace < 0) {
    const [path = "", renamed] = tree.split("=");
    const segments = [...before, ...path.split("::").filter(Boolean)];
    const last = segments.at(-1);
    const whole = last === "self" && segments.length > 1 ? segments.slice(0, -1) : segments;
    return [{ segments: whole, alias: renamed ?? whole.at(-1) ?? "" }];
  }
  const prefix = [...before, ...tree.slice(0, brace).split("::").filter(Boolean)];
  return parts(tree.slice(brace + 1, tree.lastIndexOf("}"))).flatMap((part) => leaves(part, prefix));
}

/**
 * Splits at the commas that are not within braces.
 * @param {string} list
 */
function parts(list) {
  const found = [];
  let depth = 0;
  let start = 0;
  for (let at = 0; at <= list.length; at += 1) {
    if (list[at] === "{") {
      depth += 1;
    } else if (list[at] === "}") {
      depth -= 1;
    } else if (at === list.length || (list[at] === "," && depth === 0)) {
      found.push(list.slice(start, at));
      start = at + 1;
    }
  }
  return found.filter(Boolean);
}

/**
 * What a module uses of modules that it is not in, once each.
 * @param {Module} module
 * @param {Modules} modules
 */
function usesOf(module, modules) {
  /** @type {Map<string, Use>} */
  const uses = new Map();
  for (const { segments, line } of module.paths) {
    const to = definedIn(segments, module, modules);
    if (to && !within(module.name, to.name) && !uses.has(to.name)) {
      const path = segments.join("::");
      uses.set(to.name, { from: module.name, to: to.name, path, file: module.file, line });
    }
  }
  return [...uses.values()];
}

/**
 * Whether a module is another or in it.
 * @param {string} name
 * @param {string} other
 */
function within(name, other) {
  return name === other || name.startsWith(`${other}::`);
}

/**
 * The module that defines what a path names, through what others show of it; none of other crates.
 * @param {string[]} path
 * @param {Module} module where it is written
 * @param {Modules} modules
 * @param {Set<string>} seen
 * @returns {Module | undefined}
 */
function definedIn(path, module, modules, seen = new Set()) {
  const [first = ""] = path;
  let left = path.slice(1);
  /** @type {Module | undefined} */
  let at = module;
  if (first === "crate") {
    at = modules.get("crate");
  } else if (first === "super") {
    at = modules.get(parentOf(module.name));
    while (at && left[0] === "super") {
      at = modules.get(parentOf(at.name));
      left = left.slice(1);
    }
  } else if (module.children.has(first)) {
    left = path;
  } else if (first !== "self") {
    return undefined;
  }
  for (let [name] = left; at && name !== undefined; [name] = left) {
    const rest = left.slice(1);
    if (at.children.has(name)) {
      at = modules.get(`${at.name}::${name}`);
      left = rest;
      continue;
    }
    const key = `${at.name}::${name}`;
    const source = at.paths.find(({ alias, shown }) => shown && alias === name);
    if (!source || seen.has(key)) {
      return at;
    }
    return definedIn([...source.segments, ...rest], at, modules, seen.add(key)) ?? at;
  }
  return at;
}

/** @param {string} name */
function parentOf(name) {
  return name.slice(0, name.lastIndexOf("::"));
}

/**
 * Sets of modules each of which leads to every other, of more than one (Tarjan 1972).
 * @param {Uses} uses
 */
function knots(uses) {
  /** @type {Set<string>[]} */
  const found = [];
  /** @type {Map<string, number>} */
  const numbers = new Map();
  /** @type {string[]} */
  const stack = [];
  /**
   * Gives the lowest number on the stack that the module leads to.
   * @param {string} name
   * @returns {number}
   */
  const visit = (name) => {
    const number = numbers.size;
    numbers.set(name, number);
    stack.push(name);
    let lowest = number;
    for (const { to } of uses.get(name) ?? []) {
      const known = numbers.get(to);
      if (known === undefined) {
        lowest = Math.min(lowest, visit(to));
      } else if (stack.includes(to)) {
        lowest = Math.min(lowest, known);
      }
    }
    if (lowest === number) {
      const knot = stack.splice(stack.indexOf(name));
      if (knot.length > 1) {
        found.push(new Set(knot));
      }
    }
    return lowest;
  };
  for (const name of uses.keys()) {
    if (!numbers.has(name)) {
      visit(name);
    }
  }
  return found;
}

/**
 * The shortest way within a knot from one of its modules back to it, over all of them.
 * @param {Set<string>} knot
 * @param {Uses} uses
 */
function shortestCircle(knot, uses) {
  const around = Array.from(knot, (start) => {
    /** @type {{ name: string, way: Use[] }[]} */
    const open = [{ name: start, way: [] }];
    const seen = new Set();
    for (const { name, way } of open) {
      for (const use of (uses.get(name) ?? []).filter(({ to }) => knot.has(to))) {
        if (use.to === start) {
          return [...way, use];
        }
        if (!seen.has(use.to)) {
          seen.add(use.to);
          open.push({ name: use.to, way: [...way, use] });
        }
      }
    }
    return [];
  });
  return around.reduce((best, way) => (way.length < best.length ? way : best));
}
