// Under what conditions the models of a set were made, as the manifest of the set says.

import { basename } from "node:path";

/** @typedef {import("../engine/engine.js").Condition} Condition */

/** What a manifest calls the conditions that it declares. */
const DEGRADATION = /** @type {const} */ (["noise", "missing"]);

/**
 * By model, the conditions that a manifest among the files declares (see `fit4cad import`). What is no such
 * manifest declares nothing, and what two declare differently is left to be measured.
 * @param {Pick<import("./engine.mjs").Engine, "declaredCondition">} engine
 * @param {readonly import("./inputs.mjs").File[]} files
 */
export function declaredConditions(engine, files) {
  /** @type {Map<string, Condition[]>} */
  const byModel = new Map();
  for (const { path, read } of files) {
    if (basename(path) !== "manifest.json") {
      continue;
    }
    const manifest = parsed(read);
    const degradation = /** @type {Record<string, unknown>} */ (manifest?.["degradation"] ?? {});
    const models = Array.isArray(manifest?.["models"]) ? /** @type {{ model?: unknown }[]} */ (manifest["models"]) : [];
    const conditions = DEGRADATION.flatMap((by) => {
      const value = degradation[by];
      const condition = typeof value === "number" && value >= 0 ? engine.declaredCondition(by, value) : undefined;
      return condition ? [condition] : [];
    });
    for (const name of models.flatMap(({ model }) => (typeof model === "string" ? [model] : []))) {
      const before = byModel.get(name);
      byModel.set(name, before ? before.filter((one) => conditions.some(({ by, value }) => by === one.by && value === one.value)) : conditions);
    }
  }
  return byModel;
}

/**
 * @param {() => Uint8Array} read
 * @returns {Record<string, unknown> | undefined}
 */
function parsed(read) {
  try {
    const found = /** @type {unknown} */ (JSON.parse(new TextDecoder().decode(read())));
    return typeof found === "object" && found !== null ? /** @type {Record<string, unknown>} */ (found) : undefined;
  } catch {
    return undefined;
  }
}
