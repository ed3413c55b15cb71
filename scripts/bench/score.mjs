// From the bytes of a zip to every measure, in one thread.

import { evaluate, scoredBy } from "../../bin/cli/evaluate.mjs";
import { memory } from "../../www/shared/zip/source.mjs";
import { STREAMED, listZip } from "../../www/shared/zip/zip.mjs";
import { generatedZip, testSampleZip, trainingZip } from "../lib/samples.mjs";

export const name = "score";
export const about = "zip bytes to all measures, one thread";

/** @param {import("../lib/bench.mjs").Bench} bench */
export async function measure(bench) {
  const sample = testSampleZip();
  if (sample) {
    await scoreZip(bench, "test_sample, methods HT and PG", sample, { runs: 5, most: 0.6 });
  }
  const training = trainingZip();
  if (training) {
    await scoreZip(bench, "training_set.zip against itself", training, { runs: 3, most: 8, self: true });
  }
  if (!sample && !training) {
    bench.note("the public files are not at hand; generated parts instead");
    await scoreZip(bench, "generated parts against themselves", generatedZip(bench.engine), {
      runs: 5,
      self: true,
    });
  }
}

/**
 * @param {import("../lib/bench.mjs").Bench} bench
 * @param {string} label
 * @param {Uint8Array} zip
 * @param {{ runs: number, most?: number, self?: boolean }} how
 */
async function scoreZip(bench, label, zip, { runs, most, self = false }) {
  const entries = () => listZip(memory(zip), STREAMED).entries;
  /** @param {readonly import("../../bin/cli/inputs.mjs").File[]} files */
  const score = (files) => evaluate(bench.engine, files, { report: scoredBy("definition"), self });
  const unpacked = entries().map((entry) => {
    const bytes = entry.read();
    return { ...entry, read: () => bytes };
  });

  const { results } = await score(unpacked);
  const whole = await bench.secondsOf(runs, () => score(entries()));
  const engine = await bench.secondsOf(runs, () => score(unpacked));
  bench.note(`${label}: ${results.length} submissions`);
  bench.figure("zip bytes to measures", whole, "s", { most, digits: 3 });
  bench.figure("of it the engine", engine, "s", { digits: 3 });
}
