// Every protocol and figure of the field, in one thread: models that are read already, so that it is
// the figures alone that are timed.

import { eachModel, isOfTruth } from "../../bin/cli/models.mjs";
import { memory } from "../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";
import { timed } from "../lib/bench.mjs";
import { generatedZip, trainingZip } from "../lib/samples.mjs";

export const name = "field";
export const about = "all protocols and figures of an imperfect submission, one thread";

const SEED = 1;

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {{ models: number }} options
 */
export async function measure(bench, { models: most }) {
  const { declarations } = bench.engine;
  const { protocols, figureScale, figures } = declarations();
  const training = trainingZip();
  if (!training) {
    bench.note("the public files are not at hand; generated parts instead");
  }
  const zip = training ?? generatedZip(bench.engine);
  const files = listZip(memory(zip), STREAMED).entries;
  /** Processor seconds of the paper's measures, and of what the field reports. */
  const sum = { paper: 0, field: 0 };
  let count = 0;
  await eachModel(bench.engine, files, { wanted: isOfTruth }, (model) => {
    if (count >= most || !model.info().hasTruth) {
      return;
    }
    const method = model.imperfect(SEED);
    sum.paper += timed(() => protocols.map(({ name: protocol }) => model.score(method, protocol))).seconds;
    sum.field += timed(() => model.field(method, figureScale)).seconds;
    count += 1;
  });
  bench.note(`${count} models, ${protocols.length} protocols of the paper, ${figures.length} figures of the field`);
  const whole = training && count >= 188;
  bench.figure("of it the paper's measures", sum.paper, "s");
  bench.figure("of it the field's figures", sum.field, "s");
  bench.figure("all", sum.paper + sum.field, "s", whole ? { most: 4 } : {});
}
