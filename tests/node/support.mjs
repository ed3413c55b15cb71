// What the tests of the command line share.

import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { benchmarkFiles, ROOT } from "../../scripts/lib/paths.mjs";

export const COMMAND = join(ROOT, "bin/fit4cad.mjs");
/** Where the benchmark's own files are; tests that need them are skipped without. */
export const PUBLIC_FILES = benchmarkFiles() ?? "";
export const WITHOUT_PUBLIC_FILES = PUBLIC_FILES === "" && "the benchmark's files are not in ../shared/fit4cad";

/**
 * Runs `fit4cad` to its end: `{ code, out, err }`.
 * @param {string[]} args
 */
export function fit4cad(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [COMMAND, ...args], {
    encoding: "utf8",
    maxBuffer: 1 << 28,
  });
  return { code: status, out: stdout, err: stderr };
}

/**
 * A folder with these files, by path, that is gone when the test ends.
 * @param {import("node:test").TestContext} test
 * @param {Readonly<Record<string, string | Uint8Array>>} files
 */
export function folder(test, files) {
  const root = mkdtempSync(join(tmpdir(), "fit4cad-"));
  test.after(() => rmSync(root, { recursive: true, force: true }));
  for (const [path, content] of Object.entries(files)) {
    mkdirSync(dirname(join(root, path)), { recursive: true });
    writeFileSync(join(root, path), content);
  }
  return root;
}

/**
 * Two unit squares at heights 0 and 1, nine points each, as the files of a model.
 * @param {string} model
 * @returns {Record<string, string>}
 */
export function twoPlanes(model) {
  /** @param {number} z */
  const grid = (z) => [0, 0.5, 1].flatMap((x) => [0, 0.5, 1].map((y) => `[${x}, ${y}, ${z}]`));
  /** @param {number} from */
  const list = (from) => Array.from({ length: 9 }, (_, index) => from + index).join(" ");
  /** @param {string} first @param {string} second */
  const entries = (first, second) => `Primitive1:=[${first}];\nPrimitive2:=[${second}];\n`;
  return {
    [`${model}.txt`]: `Points:=[\n${[...grid(0), ...grid(1)].join(", \n")} \n ];\n`,
    [`${model}_primitives.txt`]: entries(list(1), list(10)),
    [`${model}_parametric.txt`]: entries(
      "Plane, [1 0 0 0 1 0 0 0 0]",
      "Plane, [1 0 0 0 1 0 0 0 1]",
    ),
    [`${model}_implicit.txt`]: entries("Plane, [0 0 1 0]", "Plane, [0 0 1 -1]"),
  };
}

/**
 * The model's truth in `truth/` and the same as the result of each method in its own folders.
 * @param {string} model
 * @param {string[]} methods
 * @returns {Record<string, string>}
 */
export function submitted(model, ...methods) {
  const files = Object.entries(twoPlanes(model));
  /** @param {string} name */
  const role = (name) => /_(primitives|parametric|implicit)\.txt$/.exec(name)?.[1];
  const truth = files.map(([name, text]) => {
    const suffix = role(name) ? `_${role(name)}` : "";
    return [`pointCloud${suffix}/${name}`, text];
  });
  const results = methods.flatMap((method) =>
    files
      .filter(([name]) => role(name))
      .map(([name, text]) => [`pointCloud_${role(name)}_${method}/${name}`, text]),
  );
  return Object.fromEntries([...truth, ...results]);
}
