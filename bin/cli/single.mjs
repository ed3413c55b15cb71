// `fit4cad fit --single`: each cloud, or each segment of it that is given, is one primitive.

import { join } from "node:path";
import { align } from "../../www/shared/formats/align.mjs";
import { SEGMENTATION } from "../../www/shared/roles.mjs";
import { tell } from "./diagnostics.mjs";
import { collect } from "./inputs.mjs";
import { eachModel, isOfTruth } from "./models.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { makeFolder, writeWhole } from "./write.mjs";

/** @typedef {import("../engine/engine.js").SingleInfo} SingleInfo */
/** @typedef {{ engine: string, model: string, points: number, seconds: number, segments: SingleInfo[] }} Recognised */

/**
 * Recognises what the paths name; gives the exit code.
 * @param {import("./engine.mjs").Engine} engine
 * @param {readonly string[]} paths
 * @param {{ out: string | undefined, json: boolean }} how
 */
export async function recognise(engine, paths, { out, json }) {
  if (out !== undefined) {
    makeFolder(out);
  }
  progress.show("looking for files");
  const inputs = await collect(paths);
  const problems = [...inputs.diagnostics];
  /** @type {Recognised[]} */
  const models = [];
  const how = { wanted: isOfTruth, progress: (/** @type {string} */ text) => progress.show(`recognising ${text}`) };
  const read = await eachModel(engine, inputs.files, how, (model, _files, _place, able) => {
    const { name, points, diagnostics } = model.info();
    problems.push(...diagnostics);
    if (points === 0) {
      return;
    }
    const start = performance.now();
    const { method, segments } = model.fitSingle();
    models.push({ engine: able.version(), model: name, points, seconds: (performance.now() - start) / 1000, segments });
    if (out === undefined) {
      return;
    }
    const texts = model.write(method);
    for (const role of SEGMENTATION) {
      writeWhole(join(out, able.pathOf("test-set", name, role, method)), texts[role]);
    }
    for (const { number, answer } of segments) {
      const stem = segments.length === 1 ? name : `${name}_${number}`;
      writeWhole(join(out, "shrec2022", `${able.fileName(stem)}.txt`), answer);
    }
  });
  progress.clear();
  tell(read.engine, [...problems, ...read.diagnostics]);
  if (models.length === 0) {
    warn("fit4cad fit: there was no cloud to fit; see fit4cad fit --help.");
  }
  await print(json ? `${JSON.stringify(models, null, 2)}\n` : table(models));
  const failed = [...problems, ...read.diagnostics].some(({ severity }) => severity === "error");
  return models.length === 0 || failed ? 1 : 0;
}

/** @param {readonly Recognised[]} models */
function table(models) {
  if (models.length === 0) {
    return "";
  }
  const head = ["model", "segment", "points", "type", "rms", "largest", "runner-up", "its rms", "margin"];
  const rows = models.flatMap(({ model, segments }) =>
    segments.map(({ number, points, best, runnerUp, margin }) => [
      ...[model, String(number), String(points), best.type, best.rms.toExponential(2), best.largest.toExponential(2)],
      ...[runnerUp.type, runnerUp.rms.toExponential(2), margin.toPrecision(3)],
    ]),
  );
  return `${align([head, ...rows], 1)}\n`;
}
