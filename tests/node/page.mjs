// The page's modules under Node: those that need no browser can be tested without one.

import { join } from "node:path";
import { runnerImport } from "vite";
import { ROOT } from "../../scripts/lib/paths.mjs";

/**
 * What a TypeScript module of the page exports, by its path below `www/app`.
 * @param {string} path
 * @returns {Promise<any>} typed where it is used
 */
export async function pageModule(path) {
  const { module } = await runnerImport(join(ROOT, "www/app", path), { configFile: false, root: ROOT });
  return module;
}
