// `fit4cad stats`.

import { STATISTICS } from "../../www/shared/formats/statistics.mjs";
import { tell } from "./diagnostics.mjs";
import { loadEngine } from "./engine.mjs";
import { FORMAT_OPTIONS, formatOf } from "./format.mjs";
import { collect } from "./inputs.mjs";
import { eachModel, isOfTruth } from "./models.mjs";
import { print, progress, warn } from "./terminal.mjs";
import { UsageError, readArguments } from "./usage.mjs";

const FORMATS = /** @type {const} */ (["table", "json", "csv"]);

/**
 * Counts what the models named by the arguments hold; gives the exit code.
 * @param {readonly string[]} args
 */
export async function stats(args) {
  const { values, positionals } = readArguments(args, FORMAT_OPTIONS);
  if (positionals.length === 0) {
    throw new UsageError("give at least one file, folder or zip");
  }
  const format = formatOf(values, FORMATS);
  const engine = await loadEngine();

  progress.show("looking for files");
  const inputs = await collect(positionals);
  /** @type {import("../engine/engine.js").ModelStatistics[]} */
  const models = [];
  const problems = [...inputs.diagnostics];
  /** @param {string} text */
  const show = (text) => progress.show(`counting ${text}`);
  const read = await eachModel(engine, inputs.files, { wanted: isOfTruth, progress: show }, (model) => {
    const { diagnostics } = model.info();
    problems.push(...diagnostics.filter(({ severity }) => severity === "error"));
    models.push(model.statistics());
  });
  progress.clear();

  const told = [...problems, ...read.diagnostics];
  tell(read.engine, told);
  if (models.length === 0) {
    warn("fit4cad stats: there is no model among the files; see fit4cad stats --help.");
  }
  await print(STATISTICS[format]({ engine: engine.version(), set: read.engine.datasetStatistics(models), models }));
  return models.length === 0 || told.some(({ severity }) => severity === "error") ? 1 : 0;
}
