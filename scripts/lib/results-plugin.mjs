// The standing table as the page imports it: what its files say, checked while the page is built.

import { readdirSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { ROOT } from "./paths.mjs";

const RESULTS = join(ROOT, "results");

/**
 * Where the page will lie, as far as that is known: the feed has to name itself. Else from where the feed lies.
 * @param {string | undefined} repository `owner/name`, on GitHub
 */
function homeOf(repository) {
  const [owner, name] = repository?.split("/") ?? [];
  return owner && name ? `https://${owner}.github.io/${name}/` : "../";
}

/**
 * A plugin for Vite: `method.toml` and `sets.toml` as what they say, `scores.json?summary` as what the
 * table shows of it, without single models, types and sizes, and `results/feed.json` beside the page.
 * @returns {import("vite").Plugin}
 */
export function resultsPlugin() {
  return {
    name: "results",
    enforce: "pre",
    async load(id) {
      const [path = "", query] = id.split("?");
      if (!path.replaceAll("\\", "/").includes("/results/")) return null;
      // What is shared reads what the engine declares, which is there once the page is built.
      const { readFolder, setsOf } = await import("../../bin/cli/standing/folder.mjs");
      const sets = setsOf(RESULTS);
      if (basename(path) === "sets.toml") return module(sets);
      const file = basename(path);
      if (file !== "method.toml" && !(file === "scores.json" && query === "summary")) return null;
      const { method, scores, findings } = readFolder(dirname(path), sets);
      const [first] = findings;
      if (first || !method || !scores) throw new Error(`${dirname(path)}: ${first?.where}: ${first?.message}`);
      if (file === "method.toml") return module(method);
      return module(scores.sets.map(({ models: _, summary: { types: __, sizes: ___, ...summary }, ...set }) => ({ ...set, summary })));
    },
    async generateBundle() {
      const { readFolder, setsOf } = await import("../../bin/cli/standing/folder.mjs");
      const { feedOf } = await import("../../www/shared/results/feed.mjs");
      const sets = setsOf(RESULTS);
      const titles = new Map(sets.sets.map(({ id, title }) => [id, title]));
      const folders = readdirSync(RESULTS, { withFileTypes: true }).filter((entry) => entry.isDirectory());
      const rows = folders.flatMap(({ name }) => {
        const { id, method, scores } = readFolder(join(RESULTS, name), sets);
        return method && scores ? [{ id, method, sets: scores.sets.map(({ set }) => titles.get(set) ?? set) }] : [];
      });
      this.emitFile({ type: "asset", fileName: "results/feed.json", source: feedOf(rows, homeOf(process.env.GITHUB_REPOSITORY)) });
    },
  };
}

/** @param {unknown} value */
function module(value) {
  return { code: `export default ${JSON.stringify(value)}`, moduleType: "js" };
}
